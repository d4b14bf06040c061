/* SPDX-License-Identifier: BSD-3-Clause */
/* A pipe's node on the user element of examples/macro_element/abaqus_uel.c, solved by Newton's method as Abaqus does: increments, tries, and svars that are taken back. */
#include "check.h"
#include "macro_element.h"

#include <string.h>

void uel_(double*, double*, double*, double*, const int*, const int*, const int*, const double*, const int*, const double*, const int*, const int*, const double*, const double*,
          const double*, const double*, const int*, const double*, const double*, const int*, const int*, const int*, const double*, const int*, const int*, const double*, const double*,
          const int*, const int*, const int*, const double*, const int*, double*, const int*, const int*, const double*);

static const double props[3] = {2.0, 0.05, 800};
static double rhs[3], amatrx[9], pnewdt;

static void call(const double u[3], double svars[19], int what)
{
  const int one = 1, three = 3, zero = 0, ndofel = 3, nsvars = 19, lflags[5] = {1, 1, what, 0, 0};
  const double none[3] = {0}, time[2] = {0}, dtime = 1;
  double energy[8] = {0};
  pnewdt = 1;
  uel_(rhs, amatrx, svars, energy, &ndofel, &one, &nsvars, props, &three, none, &three, &one, u, none, none, none, &one, time, &dtime, &one, &one, &one, none, &zero, &zero, none, none, &zero,
       lflags, &ndofel, none, &zero, &pnewdt, &zero, &zero, none);
}

/* du = A^-1 r, by Gauss. */
static void solve(const double r[3], double du[3])
{
  double A[3][4];
  int i, j, k;
  for (i = 0; i < 3; ++i) {
    for (j = 0; j < 3; ++j) A[i][j] = amatrx[i + 3 * j];
    A[i][3] = r[i];
  }
  for (k = 0; k < 3; ++k)
    for (i = 0; i < 3; ++i) {
      const double f = A[i][k] / A[k][k];
      for (j = k; j < 4 && i != k; ++j) A[i][j] -= f * A[k][j];
    }
  for (i = 0; i < 3; ++i) du[i] = A[i][3] / A[i][i];
}

int main(void)
{
  double u[3] = {0}, svars[19] = {0}, tried[19], du[3], r[3], load[3], zero[3] = {0}, wild[3] = {0, 1e9, 0};
  int step, k, i, most = 0;
  take_locale();
  call(zero, svars, 1);
  CHECK_NEAR(rhs[2], props[0] * props[2], 1e-6); /* the soil carries what acted at the start */
  CHECK(svars[18] == 1);
  /* Its weight and a growing pull sideways and along. */
  for (step = 1; step <= 20; ++step) {
    load[0] = 10.0 * step, load[1] = 20.0 * step, load[2] = -props[0] * props[2];
    for (k = 0; k < 40; ++k) {
      double left = 0;
      memcpy(tried, svars, sizeof tried);
      call(u, tried, 1);
      CHECK(pnewdt == 1);
      for (i = 0; i < 3; ++i) r[i] = load[i] + rhs[i], left += fabs(r[i]);
      if (left < 1e-6) break;
      solve(r, du);
      for (i = 0; i < 3; ++i) u[i] += du[i];
    }
    CHECK(k < 40);
    if (k > most) most = k;
    memcpy(svars, tried, sizeof svars);
  }
  printf("most iterations of an increment: %d\n", most);
  CHECK(u[0] > 0 && u[1] > 0);
  /* The same way in one call of the macro-element for each increment gives the same state: svars hold no more than it. */
  CHECK_NEAR(svars[17], props[2], 1e-6 * props[2]);
  /* The tangent is that of the force. */
  for (i = 0; i < 3; ++i) {
    double plus[3], minus[3], A[9];
    const double h = 1e-8;
    int j;
    memcpy(tried, svars, sizeof tried);
    u[1] += 1e-4; /* on, away from where it stood */
    call(u, tried, 2);
    memcpy(A, amatrx, sizeof A);
    CHECK(memcmp(tried, svars, sizeof tried) == 0 && rhs[0] == 0);
    u[i] += h, memcpy(tried, svars, sizeof tried), call(u, tried, 1), memcpy(plus, rhs, sizeof plus);
    u[i] -= 2 * h, memcpy(tried, svars, sizeof tried), call(u, tried, 1), memcpy(minus, rhs, sizeof minus);
    u[i] += h, u[1] -= 1e-4;
    for (j = 0; j < 3; ++j) CHECK_NEAR(A[j + 3 * i], -(plus[j] - minus[j]) / (2 * h), 1e-3 * props[0] * berm_macro_element_fitted.vertical_stiffness);
  }
  call(u, tried, 4);
  CHECK(amatrx[0] == 0 && rhs[1] == 0);
  call(wild, svars, 1);
  CHECK(pnewdt < 1);
  return failures == 0 ? 0 : 1;
}

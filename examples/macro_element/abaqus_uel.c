/* SPDX-License-Identifier: BSD-3-Clause */
/* The macro-element as a user element of Abaqus/Standard (UEL): a node of a pipe on the seabed, x along the pipe, y across it, z up.

   *USER ELEMENT, NODES=1, TYPE=U1, PROPERTIES=3, COORDINATES=3, VARIABLES=19, UNSYMM
   1, 2, 3
   *UEL PROPERTY, ELSET=SEABED
   length of pipe at the node (m), embedment of the invert at the start (m), V on the pipe at the start (N/m)

   Compile it and macro_element.c with the analysis (abaqus job=... user=...). SI units. Displacements of the node are from the start. Written to the public documentation of UEL; a test calls
   it, Abaqus has not. */
#include "macro_element.h"

#include <math.h>
#include <string.h>

enum { DIRECTIONS = 3, STARTED = BERM_MACRO_ELEMENT_NUMBERS }; /* of svars; the numbers of the state come before it */
enum { STIFFNESS_ONLY = 2, DAMPING = 3, MASS = 4 };            /* lflags[2] */

static const double down[DIRECTIONS] = {1, 1, -1}; /* macro-element's w is downwards */

void uel_(double* rhs, double* amatrx, double* svars, double* energy, const int* ndofel, const int* nrhs, const int* nsvars, const double* props, const int* nprops,
          const double* coords, const int* mcrd, const int* nnode, const double* u, const double* du, const double* v, const double* a, const int* jtype,
          const double* time, const double* dtime, const int* kstep, const int* kinc, const int* jelem, const double* params, const int* ndload, const int* jdltyp,
          const double* adlmag, const double* predef, const int* npredf, const int* lflags, const int* mlvarx, const double* ddlmag, const int* mdload, double* pnewdt,
          const int* jprops, const int* njprop, const double* period);

void uel_(double* rhs, double* amatrx, double* svars, double* energy, const int* ndofel, const int* nrhs, const int* nsvars, const double* props, const int* nprops,
          const double* coords, const int* mcrd, const int* nnode, const double* u, const double* du, const double* v, const double* a, const int* jtype,
          const double* time, const double* dtime, const int* kstep, const int* kinc, const int* jelem, const double* params, const int* ndload, const int* jdltyp,
          const double* adlmag, const double* predef, const int* npredf, const int* lflags, const int* mlvarx, const double* ddlmag, const int* mdload, double* pnewdt,
          const int* jprops, const int* njprop, const double* period)
{
  const double length = props[0], start[DIRECTIONS] = {0, 0, props[1]};
  double displacement[DIRECTIONS], F[DIRECTIONS], K[DIRECTIONS][DIRECTIONS];
  berm_macro_element_state state;
  int i, j, error = 0;
  (void)energy, (void)nrhs, (void)nsvars, (void)nprops, (void)coords, (void)mcrd, (void)nnode, (void)du, (void)v, (void)a, (void)jtype, (void)time, (void)dtime;
  (void)kstep, (void)kinc, (void)jelem, (void)params, (void)ndload, (void)jdltyp, (void)adlmag, (void)predef, (void)npredf, (void)mlvarx, (void)ddlmag, (void)mdload;
  (void)jprops, (void)njprop, (void)period;

  memset(amatrx, 0, (size_t)(*ndofel * *ndofel) * sizeof *amatrx);
  memset(rhs, 0, (size_t)*ndofel * sizeof *rhs);
  if (lflags[2] == MASS || lflags[2] == DAMPING) return;

  /* svars are of the start of the increment, however often it is tried. */
  if (svars[STARTED] == 0) {
    error = berm_macro_element_start(&berm_macro_element_fitted, start, props[2], &state);
  } else {
    state.version = BERM_MACRO_ELEMENT_VERSION;
    memcpy(&state.x, svars, BERM_MACRO_ELEMENT_NUMBERS * sizeof *svars);
  }
  for (i = 0; i < DIRECTIONS; ++i) displacement[i] = start[i] + down[i] * u[i];
  if (error == 0) error = berm_macro_element_step(&berm_macro_element_fitted, &state, displacement, &state, F, K);
  if (error != 0) {
    *pnewdt = 0.25; /* a smaller increment; what cannot be mended so ends the analysis at its smallest */
    return;
  }
  for (i = 0; i < DIRECTIONS; ++i) {
    if (lflags[2] != STIFFNESS_ONLY) rhs[i] = -length * down[i] * F[i];
    for (j = 0; j < DIRECTIONS; ++j) amatrx[i + *ndofel * j] = length * down[i] * down[j] * K[i][j]; /* column-major */
  }
  if (lflags[2] == STIFFNESS_ONLY) return;
  memcpy(svars, &state.x, BERM_MACRO_ELEMENT_NUMBERS * sizeof *svars);
  svars[STARTED] = 1;
}

/* SPDX-License-Identifier: BSD-3-Clause */
/* A footing or spudcan as a macro-element behind the interface of the REDWIN foundation models, which OpenFAST's SoilDyn calls (CalcOption 3). C99, with
   nothing but the C library: cc -O2 -fPIC -shared redwin.c -o redwin.so -lm

   Axes are those of OpenFAST: z up, rotations right-handed. Displacements (m, rad) and forces (N, N m) are those of the middle of the base, forces those of the
   footing on the soil: V = -Fz, w = -z. Sideways H and M are vectors, (Fx, Fy) and (My, -Mx), so that H and M of one sign push and tilt the same way.

   Elastic-plastic: V = k_v (w - w_p); H and M from the symmetric stiffness k_h, k_hm, k_m in each vertical plane; torsion elastic. The yield surface, with
   v = V/V0 and V0 = V_max + hardening w_p, is
     |h|^2 + |m|^2 - 2 cross h.m = y(v)^2,   h = H V_max/(H_max V0),   m = M V_max/(M_max V0),
     y = (s/p)^b1 ((1 - s)/(1 - p))^b2,   s = (v + tension)/(1 + tension),   p = b1/(b1 + b2).
   Flow is associated where the footing sinks; where it would rise V stays elastic. It parts from the soil at V = -tension V0, and has no tension then.

   Each call is one implicit step from what StVar holds to Disp. Nothing is kept outside of Props and StVar. */
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PATH_LETTERS = 45, SIGNATURE = 20261127 };
enum { SET_UP = 1, MOVE = 2, STIFFNESS = 3 };
/* Beyond the codes of the REDWIN models, so that OpenFAST stops at any of them; LINE + the number of the line is added where a line is wrong. */
enum { NO_FILE = 101, WRONG_LINE = 102, OUT_OF_RANGE = 103, WRONG_TASK = 104, NOT_SET_UP = 105, NO_NUMBER = 106, LINE = 1000 };

/* In Props, behind the signature. */
enum { K_V, K_H, K_HM, K_M, K_T, V_MAX, H_MAX, M_MAX, CROSS, TENSION, B1, B2, HARDENING, LENGTH, PROPERTIES };
static const char* const names[PROPERTIES] = {"vertical_stiffness", "horizontal_stiffness", "coupling_stiffness", "rotational_stiffness", "torsional_stiffness",
                                              "V_max", "H_max", "M_max", "cross", "tension", "b1", "b2", "hardening", "length"};

/* In the first column of StVar: plastic displacement, and whether the footing has parted from the soil. */
enum { PLASTIC, PARTED = 6 };

/* The generalised eigenvectors of compliance and yield surface in a vertical plane: (H, M) = T p makes them c_0 p_0^2 + c_1 p_1^2 and p_0^2 + p_1^2. */
typedef struct {
  double T[2][2], c[2];
} axes;

static void invert(double A[2][2], double I[2][2])
{
  const double det = A[0][0] * A[1][1] - A[0][1] * A[1][0];
  I[0][0] = A[1][1] / det;
  I[1][1] = A[0][0] / det;
  I[0][1] = -A[0][1] / det;
  I[1][0] = -A[1][0] / det;
}

static axes axes_of(const double* p)
{
  /* The surface is |U f| with f = (H, M); its inverse W = U^-1 is upper triangular. */
  const double sine = sqrt(1 - p[CROSS] * p[CROSS]);
  double K[2][2] = {{p[K_H], p[K_HM]}, {p[K_HM], p[K_M]}}, C[2][2], W[2][2] = {{p[H_MAX], p[H_MAX] * p[CROSS] / sine}, {0, p[M_MAX] / sine}}, B[2][2];
  axes a;
  double angle;
  int i, j, k, l;
  invert(K, C);
  memset(B, 0, sizeof B);
  for (i = 0; i < 2; ++i)
    for (j = 0; j < 2; ++j)
      for (k = 0; k < 2; ++k)
        for (l = 0; l < 2; ++l) B[i][j] += W[k][i] * C[k][l] * W[l][j];
  angle = 0.5 * atan2(2 * B[0][1], B[0][0] - B[1][1]);
  for (i = 0; i < 2; ++i) {
    a.T[i][0] = W[i][0] * cos(angle) + W[i][1] * sin(angle);
    a.T[i][1] = -W[i][0] * sin(angle) + W[i][1] * cos(angle);
  }
  for (i = 0; i < 2; ++i) {
    a.c[i] = 0;
    for (k = 0; k < 2; ++k)
      for (l = 0; l < 2; ++l) a.c[i] += a.T[k][i] * C[k][l] * a.T[l][i];
  }
  return a;
}

/* y and its slope. */
static double shape(const double* p, double v, double* slope)
{
  const double b1 = p[B1], b2 = p[B2], peak = b1 / (b1 + b2), least = 1e-15, raw = (v + p[TENSION]) / (1 + p[TENSION]);
  const double s = raw < least ? least : raw > 1 - least ? 1 - least : raw;
  const double y = pow(s / peak, b1) * pow((1 - s) / (1 - peak), b2);
  *slope = y * (b1 / s - b2 / (1 - s)) / (1 + p[TENSION]);
  return y;
}

/* The multiplier that brings a trial with the lengths P along both axes to the length Y: |c P/(c + mu)| = Y. */
static double multiplier(const axes* a, const double P[2], double Y)
{
  double mu = 0;
  int k, i;
  for (k = 0; k < 100; ++k) {
    double squares = 0, slope = 0, length, change;
    for (i = 0; i < 2; ++i) {
      const double part = a->c[i] * P[i] / (a->c[i] + mu);
      squares += part * part;
      slope += part * part / (a->c[i] + mu);
    }
    length = sqrt(squares);
    if (length <= Y) break;
    change = (length / Y - 1) * squares / slope; /* Newton's step for 1/length */
    mu += change;
    if (change <= 1e-15 * mu) break;
  }
  return mu;
}

/* A step: what stays while V is looked for. */
typedef struct {
  const double* p;
  const axes* a;
  double P[2], V_trial, w_p; /* w_p before the step */
} step;

static double V0_at(const step* t, double V)
{
  return t->p[V_MAX] + t->p[HARDENING] * (t->w_p + (t->V_trial - V) / t->p[K_V]);
}

/* V that is v times the V0 that it leaves. */
static double V_at(const step* t, double v)
{
  return v * V0_at(t, 0) / (1 + v * t->p[HARDENING] / t->p[K_V]);
}

/* What is left of the vertical condition at V, rising with V; gives the multiplier. */
static double residual(const step* t, double V, double* mu)
{
  const double V0 = V0_at(t, V);
  double slope;
  const double Y = V0 / t->p[V_MAX] * shape(t->p, V / V0, &slope);
  *mu = multiplier(t->a, t->P, Y);
  return (V - t->V_trial) / t->p[K_V] - *mu * Y * slope / t->p[V_MAX];
}

/* V and the multiplier where the footing sinks: between the peak of the surface and its tip. */
static double sinking(const step* t, double* mu)
{
  double low = V_at(t, (1 + t->p[TENSION]) * t->p[B1] / (t->p[B1] + t->p[B2]) - t->p[TENSION]), high = V_at(t, 1), at_low, at_high, V;
  int k;
  at_high = residual(t, high, mu);
  if (at_high <= 0) return high;
  at_low = residual(t, low, mu);
  for (k = 0; k < 200 && high - low > 1e-15 * t->p[V_MAX]; ++k) {
    double r;
    V = k % 3 == 2 ? 0.5 * (low + high) : low - at_low * (high - low) / (at_high - at_low);
    if (!(V > low && V < high)) V = 0.5 * (low + high);
    r = residual(t, V, mu);
    if (r == 0) return V;
    if (r < 0) low = V, at_low = r;
    else high = V, at_high = r;
  }
  residual(t, low, mu);
  return low;
}

/* Takes the footing to disp; state and force are changed. */
static void move(const double* p, const double disp[6], double state[12], double force[6])
{
  const axes a = axes_of(p);
  const double peak = (1 + p[TENSION]) * p[B1] / (p[B1] + p[B2]) - p[TENSION];
  double f[2][2], trial[2][2], inverse[2][2], T[2][2], slope, V, mu = 0, V0, Y; /* [H, M][x, y] */
  step t;
  int i, k;
  t.p = p;
  t.a = &a;
  t.w_p = -state[PLASTIC + 2];
  t.V_trial = p[K_V] * (-disp[2] - t.w_p);
  for (k = 0; k < 2; ++k) {
    const double u = disp[k] - state[PLASTIC + k], theta = k == 0 ? disp[4] - state[PLASTIC + 4] : state[PLASTIC + 3] - disp[3];
    f[0][k] = p[K_H] * u + p[K_HM] * theta;
    f[1][k] = p[K_HM] * u + p[K_M] * theta;
  }
  force[5] = p[K_T] * (disp[5] - state[PLASTIC + 5]);
  V = t.V_trial;
  V0 = V0_at(&t, V);
  if (V < (state[PARTED] != 0 ? 0 : -p[TENSION] * V0)) { /* lifted off: nothing acts, and it will touch down where it is then */
    state[PARTED] = 1;
    memset(force, 0, 6 * sizeof *force);
    for (i = 0; i < 6; ++i)
      if (i != 2) state[PLASTIC + i] = disp[i];
    return;
  }
  memcpy(T, a.T, sizeof T);
  invert(T, inverse);
  for (i = 0; i < 2; ++i) {
    for (k = 0; k < 2; ++k) trial[i][k] = inverse[i][0] * f[0][k] + inverse[i][1] * f[1][k];
    t.P[i] = hypot(trial[i][0], trial[i][1]);
  }
  Y = V0 / p[V_MAX] * shape(p, V / V0, &slope);
  if (V > V0 || hypot(t.P[0], t.P[1]) > Y) {
    if (V <= peak * V0) mu = multiplier(&a, t.P, Y);
    else V = sinking(&t, &mu);
    for (k = 0; k < 2; ++k) {
      double q[2], g[2], K[2][2] = {{p[K_H], p[K_HM]}, {p[K_HM], p[K_M]}}, C[2][2], lost[2];
      invert(K, C);
      for (i = 0; i < 2; ++i) q[i] = a.c[i] * trial[i][k] / (a.c[i] + mu);
      for (i = 0; i < 2; ++i) g[i] = a.T[i][0] * q[0] + a.T[i][1] * q[1];
      for (i = 0; i < 2; ++i) lost[i] = C[i][0] * (f[0][k] - g[0]) + C[i][1] * (f[1][k] - g[1]);
      for (i = 0; i < 2; ++i) f[i][k] = g[i];
      state[PLASTIC + k] += lost[0];
      state[PLASTIC + (k == 0 ? 4 : 3)] += k == 0 ? lost[1] : -lost[1];
    }
    state[PLASTIC + 2] -= (t.V_trial - V) / p[K_V];
  }
  force[0] = f[0][0];
  force[1] = f[0][1];
  force[2] = -V;
  force[3] = -f[1][1];
  force[4] = f[1][0];
}

static int in_range(const double* p)
{
  static const int positive[] = {K_V, K_H, K_M, K_T, V_MAX, H_MAX, M_MAX, B1, B2, LENGTH};
  int k;
  for (k = 0; k < PROPERTIES; ++k)
    if (p[k] - p[k] != 0) return 0;
  for (k = 0; k < (int)(sizeof positive / sizeof *positive); ++k)
    if (!(p[positive[k]] > 0)) return 0;
  return p[K_HM] * p[K_HM] < p[K_H] * p[K_M] && fabs(p[CROSS]) < 1 && p[TENSION] >= 0 && p[TENSION] < 1 && p[B1] <= 1 && p[B2] <= 1 && p[HARDENING] >= 0;
}

/* Whether a word is a number, with a point: strtod obeys the locale that the program has set, and gets that one's decimal sign. */
static int read_number(const char* word, double* value)
{
  const char *sign = localeconv()->decimal_point, *point = strchr(word, '.');
  const size_t before = point == NULL ? strlen(word) : (size_t)(point - word);
  char own[300], *end;
  if (strlen(word) + strlen(sign) >= sizeof own || word[strspn(word, "+-.0123456789eE")] != 0) return 0;
  memcpy(own, word, before);
  own[before] = 0;
  if (point != NULL) strcat(strcat(own, sign), point + 1);
  *value = strtod(own, &end);
  return end != own && *end == 0;
}

/* Lines of a name and a number; # begins a comment. Gives an error, and the line that it is about. */
static int read_properties(const char* path, double* p, int* line)
{
  char text[256], name[64], number[256], more;
  int seen[PROPERTIES] = {0}, k;
  FILE* file = fopen(path, "r");
  if (file == NULL) return NO_FILE;
  for (*line = 1; fgets(text, (int)sizeof text, file) != NULL; ++*line) {
    double value;
    int found;
    if (strchr(text, '\n') == NULL && !feof(file)) break;
    text[strcspn(text, "#\n\r")] = 0;
    found = sscanf(text, "%63s %255s %c", name, number, &more);
    if (found <= 0) continue;
    for (k = 0; k < PROPERTIES && strcmp(name, names[k]) != 0; ++k) {}
    if (found != 2 || k == PROPERTIES || seen[k] || !read_number(number, &value)) break;
    seen[k] = 1;
    p[k] = value;
  }
  k = feof(file) && !ferror(file);
  fclose(file);
  if (!k) return WRONG_LINE;
  *line = 0;
  for (k = 0; k < PROPERTIES; ++k)
    if (!seen[k]) return WRONG_LINE;
  return in_range(p) ? 0 : OUT_OF_RANGE;
}

static int set_up(const char* props_file, double* props, double* st_var, int* line)
{
  static const int of_length[] = {K_V, K_H, K_HM, K_M, K_T, V_MAX, H_MAX, M_MAX, HARDENING};
  char path[PATH_LETTERS + 1];
  double* p = props + 1;
  int length = PATH_LETTERS, error, k;
  memcpy(path, props_file, PATH_LETTERS);
  while (length > 0 && path[length - 1] == ' ') --length;
  path[length] = 0;
  memset(props, 0, 100 * 200 * sizeof *props);
  memset(st_var, 0, 12 * 100 * sizeof *st_var);
  error = read_properties(path, p, line);
  if (error != 0) return error;
  for (k = 0; k < (int)(sizeof of_length / sizeof *of_length); ++k) p[of_length[k]] *= p[LENGTH];
  props[0] = SIGNATURE;
  return 0;
}

static void elastic(const double* p, double D[36])
{
  memset(D, 0, 36 * sizeof *D);
  D[0] = D[7] = p[K_H];
  D[14] = p[K_V];
  D[21] = D[28] = p[K_M];
  D[35] = p[K_T];
  D[4] = D[24] = p[K_HM];   /* x with ry */
  D[9] = D[19] = -p[K_HM];  /* y with rx */
}

#define ARGUMENTS                                                                                                                                     \
  const char *props_file, const char *ldisp_file, const int *task, int *errors, int *error_code, double *props, double *st_var, int *st_var_print,  \
    const double *disp, double *force, double *D
void INTERFACEFOUNDATION(ARGUMENTS);
void interfacefoundation(ARGUMENTS);
void interfacefoundation_(ARGUMENTS);

void INTERFACEFOUNDATION(ARGUMENTS)
{
  int error = 0, line = 0, k;
  (void)ldisp_file;
  (void)st_var_print;
  if (*task == SET_UP) error = set_up(props_file, props, st_var, &line);
  else if (*task != MOVE && *task != STIFFNESS) error = WRONG_TASK;
  else if (props[0] != SIGNATURE) error = NOT_SET_UP;
  if (error == 0) elastic(props + 1, D);
  if (error == 0 && *task == MOVE) {
    for (k = 0; k < 6; ++k)
      if (disp[k] - disp[k] != 0) error = NO_NUMBER;
    if (error == 0) move(props + 1, disp, st_var, force);
  }
  *errors = 0;
  if (error != 0) error_code[(*errors)++] = error;
  if (line != 0) error_code[(*errors)++] = LINE + line;
}

/* As Fortran compilers spell it. */
void interfacefoundation(ARGUMENTS)
{
  INTERFACEFOUNDATION(props_file, ldisp_file, task, errors, error_code, props, st_var, st_var_print, disp, force, D);
}

void interfacefoundation_(ARGUMENTS)
{
  INTERFACEFOUNDATION(props_file, ldisp_file, task, errors, error_code, props, st_var, st_var_print, disp, force, D);
}

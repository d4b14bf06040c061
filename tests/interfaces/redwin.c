/* SPDX-License-Identifier: BSD-3-Clause */
/* Calls redwin.so as OpenFAST's SoilDyn does.

   redwin LIBRARY            a foundation with known properties, in the current folder
   redwin LIBRARY ENVELOPE   the one of a strip of 1 m that berm envelope wrote with --travel 0.05: follows its probes and compares their ends */
#include "check.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

typedef void interface_function(char*, char*, int*, int*, int*, double*, double*, int*, double*, double*, double*);

/* All that OpenFAST keeps of a foundation; Fortran's arrays, the first index running fastest. */
typedef struct {
  char props_file[45], ldisp_file[45];
  int errors, error_code[100], st_var_print[12 * 100];
  double props[100 * 200], st_var[12 * 100], force[6], D[36];
} foundation;

static interface_function* call_library;
static foundation now, before;

static const double k_v = 4e8, k_h = 3e8, k_hm = -2e8, k_m = 5e9, k_t = 6e9, V_max = 2e7, H_max = 2.5e6, M_max = 1.2e7, cross = 0.2, b1 = 0.7, b2 = 0.9, stiffening = 5e7;

static void call(foundation* f, int task, const double disp[6])
{
  double d[6];
  memcpy(d, disp, sizeof d);
  call_library(f->props_file, f->ldisp_file, &task, &f->errors, f->error_code, f->props, f->st_var, f->st_var_print, d, f->force, f->D);
}

/* A Fortran string: blanks behind the path. */
static void set_path(char to[45], const char* path)
{
  memset(to, ' ', 45);
  memcpy(to, path, strlen(path));
}

static void write_line(const char* name, const char* line)
{
  FILE* file = fopen(name, "w");
  fputs(line, file);
  fclose(file);
}

static int start(const char* path)
{
  static const double nowhere[6];
  memset(&now, 0, sizeof now);
  set_path(now.props_file, path);
  set_path(now.ldisp_file, path);
  call(&now, 1, nowhere);
  return now.errors == 0;
}

static void write_properties(const char* name, double tension, double hardening, const char* more)
{
  FILE* file = fopen(name, "w");
  fprintf(file, "# a comment\n\nlength 1\nvertical_stiffness %g # N/m\nhorizontal_stiffness %g\ncoupling_stiffness %g\nrotational_stiffness %g\n", k_v, k_h, k_hm, k_m);
  fprintf(file, "torsional_stiffness %g\nV_max %g\nH_max %g\nM_max %g\ncross %g\ntension %g\nb1 %g\nb2 %g\nhardening %g\n%s", k_t, V_max, H_max, M_max, cross, tension, b1, b2, hardening, more);
  fclose(file);
}

/* In a vertical plane at an angle from x: w, u and theta of the direction in which both push and tilt. */
static void go_to(double w, double u, double theta, double angle)
{
  const double c = cos(angle), s = sin(angle), disp[6] = {u * c, u * s, -w, -theta * s, theta * c, 0};
  call(&now, 2, disp);
}

static void go(const double from[3], const double to[3], double angle, int steps)
{
  int k;
  for (k = 1; k <= steps; ++k) {
    const double t = (double)k / steps;
    go_to(from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]), from[2] + t * (to[2] - from[2]), angle);
  }
}

static double V_now(void) { return -now.force[2]; }
static double H_now(double angle) { return now.force[0] * cos(angle) + now.force[1] * sin(angle); }
static double M_now(double angle) { return now.force[4] * cos(angle) - now.force[3] * sin(angle); }

/* sqrt(|h|^2 + |m|^2 - 2 cross h.m) - y, 0 on the surface. */
static double distance_now(double V0)
{
  const double H = hypot(now.force[0], now.force[1]), M = hypot(now.force[3], now.force[4]);
  const double along = now.force[0] * now.force[4] - now.force[1] * now.force[3]; /* H.M */
  const double h = H * V_max / (H_max * V0), m = M * V_max / (M_max * V0), s = V_now() / V0, peak = b1 / (b1 + b2);
  return sqrt(h * h + m * m - 2 * cross * along * V_max * V_max / (H_max * M_max * V0 * V0)) - pow(s / peak, b1) * pow((1 - s) / (1 - peak), b2);
}

static void check_elastic(void)
{
  const double small[6] = {1e-6, -2e-6, -3e-5, 4e-8, 5e-8, 6e-8}, full[36] = {0}; /* pressed down; columns of the symmetric matrix */
  double D[36], force[6];
  int i, j;
  CHECK(start("./foundation.txt"));
  call(&now, 3, small);
  CHECK(now.errors == 0 && now.force[0] == full[0]);
  memcpy(D, now.D, sizeof D);
  CHECK_NEAR(D[0], k_h, 0);
  CHECK_NEAR(D[6 * 4 + 0], k_hm, 0); /* Fx over ry: row 1, column 5 */
  CHECK_NEAR(D[6 * 3 + 1], -k_hm, 0);
  for (i = 0; i < 6; ++i)
    for (j = 0; j < 6; ++j) CHECK_NEAR(D[6 * i + j], D[6 * j + i], 0);
  call(&now, 2, small);
  for (i = 0; i < 6; ++i) {
    force[i] = 0;
    for (j = 0; j < 6; ++j) force[i] += D[6 * j + i] * small[j];
    CHECK_NEAR(now.force[i], force[i], 1e-9 * k_v * 1e-5);
  }
  for (i = 0; i < 1200; ++i) CHECK(now.st_var[i] == 0);
}

static void check_paths(void)
{
  static const double origin[3], angles[3] = {0, 0.7, 2.5};
  int k;
  for (k = 0; k < 3; ++k) {
    const double a = angles[k], pushed[3] = {0.2, 0, 0}, dragged[3] = {0.2, 0.5, 0}, turned[3] = {0.2, 0, 0.05}, both[3] = {0.3, 0.4, 0.06}, light[3] = {0.02, 0, 0};
    const double sliding[3] = {0.02, 0.2, 0};
    CHECK(start("./foundation.txt"));
    go(origin, pushed, a, 50);
    CHECK_NEAR(V_now(), V_max, 1e-9 * V_max);
    CHECK_NEAR(H_now(a), 0, 1e-9 * V_max);
    go(pushed, dragged, a, 400);
    CHECK_NEAR(distance_now(V_max), 0, 1e-9);
    CHECK_NEAR(V_now(), V_max * b1 / (b1 + b2), 1e-3 * V_max); /* where the normal has no vertical part */
    /* A long drag without rotation ends where flow has none either: H along the surface's normal, m = cross h. */
    CHECK_NEAR(H_now(a), H_max / sqrt(1 - cross * cross), 2e-3 * H_max);
    CHECK_NEAR(M_now(a), cross * M_max / sqrt(1 - cross * cross), 2e-3 * M_max);
    CHECK_NEAR(hypot(now.force[0], now.force[1]), fabs(H_now(a)), 1e-6 * H_max);
    CHECK(start("./foundation.txt"));
    go(origin, pushed, a, 50);
    go(pushed, turned, a, 400);
    CHECK_NEAR(distance_now(V_max), 0, 1e-9);
    CHECK_NEAR(M_now(a), M_max / sqrt(1 - cross * cross), 2e-3 * M_max);
    go(turned, both, a, 400);
    CHECK_NEAR(distance_now(V_max), 0, 1e-9);
    /* Under less V than at the peak it slides and does not rise. */
    CHECK(start("./foundation.txt"));
    go(origin, light, a, 1);
    go(light, sliding, a, 50);
    CHECK_NEAR(V_now(), 0.02 * k_v, 1e-9 * V_max);
    CHECK_NEAR(distance_now(V_max), 0, 1e-9);
  }
  /* Through a corner sideways, one vertical plane after the other, forces stay on the surface. */
  {
    const double corner[6] = {0.1, 0, -0.2, 0, 0.02, 0}, far[6] = {0.1, 0.3, -0.2, -0.03, 0.02, 0};
    CHECK(start("./foundation.txt"));
    call(&now, 2, corner);
    CHECK_NEAR(distance_now(V_max), 0, 1e-9);
    call(&now, 2, far);
    CHECK_NEAR(distance_now(V_max), 0, 1e-9);
  }
}

static void check_hardening(void)
{
  static const double origin[3];
  const double pushed[3] = {0.2, 0, 0}, dragged[3] = {0.2, 0.3, 0}, elastic = V_max / k_v;
  CHECK(start("./hardens.txt"));
  go(origin, pushed, 0, 100);
  /* V0 = V_max + stiffening w_p = k_v (w - w_p) */
  CHECK_NEAR(V_now(), V_max + stiffening * (0.2 - elastic) / (1 + stiffening / k_v), 1e-9 * V_max);
  go(pushed, dragged, 0, 400);
  CHECK_NEAR(distance_now(V_max + stiffening * -now.st_var[2]), 0, 1e-9);
  CHECK(-now.st_var[2] > 0.15);
}

static void check_parting(void)
{
  const double pressed[6] = {0, 0, -0.02, 0, 0, 0}, lifted[6] = {0.05, 0, 0.3, 0, 0.01, 0.02}, down[6] = {0.05, 0, -0.01, 0, 0.01, 0.02};
  const double pulled[6] = {0, 0, 0.002, 0, 0, 0};
  int i;
  CHECK(start("./foundation.txt"));
  call(&now, 2, pressed);
  call(&now, 2, lifted);
  for (i = 0; i < 6; ++i) CHECK(now.force[i] == 0);
  call(&now, 2, down);
  CHECK_NEAR(V_now(), 0.01 * k_v, 1e-9 * V_max); /* it touches down at the height where it was */
  for (i = 0; i < 6; ++i)
    if (i != 2) CHECK_NEAR(now.force[i], 0, 1e-6);
  /* A base that sticks holds 0.1 V_max, once. */
  CHECK(start("./sticks.txt"));
  call(&now, 2, pulled);
  CHECK_NEAR(V_now(), -0.002 * k_v, 1e-9 * V_max);
  call(&now, 2, lifted);
  CHECK(V_now() == 0);
  call(&now, 2, pulled);
  CHECK(V_now() == 0);
}

/* OpenFAST tries a step, goes back to the copy that it kept, and tries another. */
static void check_rollback(void)
{
  static const double origin[3];
  const double pushed[3] = {0.2, 0.1, 0.01}, there[6] = {0.15, 0.02, -0.21, 0.001, 0.012, 0.003}, elsewhere[6] = {-0.3, 0.2, 0.1, 0.02, -0.05, 0};
  double force[6], st_var[1200];
  CHECK(start("./foundation.txt"));
  go(origin, pushed, 0.3, 20);
  before = now;
  call(&now, 2, there);
  memcpy(force, now.force, sizeof force);
  memcpy(st_var, now.st_var, sizeof st_var);
  now = before;
  call(&now, 2, elsewhere);
  CHECK(memcmp(force, now.force, sizeof force) != 0);
  now = before;
  call(&now, 2, there);
  CHECK(memcmp(force, now.force, sizeof force) == 0);
  CHECK(memcmp(st_var, now.st_var, sizeof st_var) == 0);
  CHECK(memcmp(before.props, now.props, sizeof now.props) == 0);
}

static void check_errors(void)
{
  double wrong[6] = {0};
  CHECK(!start("./nowhere.txt") && now.error_code[0] == 101);
  CHECK(!start("./twice.txt") && now.errors == 2 && now.error_code[0] == 102 && now.error_code[1] == 1017);
  CHECK(!start("./comma.txt") && now.errors == 2 && now.error_code[0] == 102 && now.error_code[1] == 1001);
  CHECK(!start("./short.txt") && now.errors == 1 && now.error_code[0] == 102);
  CHECK(!start("./negative.txt") && now.errors == 1 && now.error_code[0] == 103);
  call(&now, 2, wrong);
  CHECK(now.errors == 1 && now.error_code[0] == 105);
  CHECK(start("./foundation.txt"));
  call(&now, 4, wrong);
  CHECK(now.errors == 1 && now.error_code[0] == 104);
  wrong[4] = NAN;
  before = now;
  call(&now, 2, wrong);
  CHECK(now.errors == 1 && now.error_code[0] == 106 && memcmp(before.st_var, now.st_var, sizeof now.st_var) == 0);
}

/* The displacement sideways at which H is 0, by tries that are taken back. */
static void go_free_sideways(double w, double theta, double* u, double reach)
{
  double low = *u - reach, high = *u + reach;
  int k;
  before = now;
  for (k = 0; k < 60; ++k) {
    *u = 0.5 * (low + high);
    now = before;
    go_to(w, *u, theta, 0);
    if (now.force[0] > 0) high = *u;
    else low = *u;
  }
}

/* Follows the probes of envelope.csv and compares what they meet along their motion at the end, and V, H and M. */
static void follow_probes(const char* folder)
{
  static const double origin[3];
  const double degree = atan(1) / 45, D = 1, travel = 0.05;
  char path[200], line[1000];
  double V0 = 0;
  int compared = 0;
  FILE* file;
  snprintf(path, sizeof path, "%s/envelope.csv", folder);
  file = fopen(path, "r");
  CHECK(file != NULL);
  snprintf(path, sizeof path, "%s/redwin.txt", folder);
  while (file != NULL && fgets(line, sizeof line, file) != NULL) {
    char* fields[20] = {NULL};
    char *rest = line, *probe;
    int n = 0, k;
    double angle, turn, V, H, M, a, b, met, meets;
    for (; n < 20 && rest != NULL; ++n) fields[n] = strsep(&rest, ",\n");
    probe = fields[0];
    if (n < 16 || strcmp(fields[1], "path") == 0 || strcmp(fields[1], "kind") == 0) continue;
    angle = strtod(fields[2], NULL), V = strtod(fields[3], NULL), H = strtod(fields[4], NULL), turn = strtod(fields[12], NULL), M = strtod(fields[14], NULL);
    if (V0 == 0) V0 = V; /* the first goes down */
    a = strcmp(fields[1], "swipe") == 0 ? 0 : angle * degree;
    b = turn * degree;
    CHECK(start(path));
    if (strcmp(fields[1], "swipe") == 0) {
      const double pushed[3] = {travel * D, 0, 0}, end[3] = {travel * D, 2 * travel * D * cos(b), 2 * travel * sin(b)};
      go(origin, pushed, 0, 50);
      if (fields[13][0] == '1') {
        double u = 0;
        for (k = 1; k <= 200; ++k) go_free_sideways(pushed[0], 2 * travel * k / 200, &u, travel * D / 10);
      } else
        go(pushed, end, 0, 400);
    } else if (fields[13][0] == '1') {
      double u = 0;
      for (k = 1; k <= 200; ++k) go_free_sideways(travel * D * sin(a) * k / 200, travel * cos(a) * k / 200, &u, travel * D / 10);
    } else {
      const double end[3] = {travel * D * sin(a), travel * D * cos(a), 0};
      go(origin, end, 0, 400);
    }
    CHECK(now.errors == 0);
    met = V * sin(a) + cos(a) * (H * cos(b) + M / D * sin(b));
    meets = V_now() * sin(a) + cos(a) * (H_now(0) * cos(b) + M_now(0) / D * sin(b));
    printf("%-14s V %7.3f %7.3f H %7.3f %7.3f M %7.3f %7.3f of V_max D, along the motion %6.3f of the probe's\n", probe, V / V0, V_now() / V0, H / V0, H_now(0) / V0, M / V0, M_now(0) / V0, meets / met);
    if (turn == 90 && a <= 0 && strcmp(fields[1], "swipe") != 0) continue; /* unloaded, it rises as it turns, and so finds its V */
    if (turn != 0 && turn != 90) continue;                                  /* its end slides at less V, as clay and base part */
    CHECK_NEAR(meets / met, 1, 0.03);
    ++compared;
  }
  if (file != NULL) fclose(file);
  CHECK(compared >= 6);
}

int main(int argc, char** argv)
{
  void* library = dlopen(argc > 1 ? argv[1] : "", RTLD_LAZY);
  if (library == NULL) return fprintf(stderr, "%s\n", dlerror()), 1;
  *(void**)&call_library = dlsym(library, "interfacefoundation");
  CHECK(call_library != NULL);
  *(void**)&call_library = dlsym(library, "INTERFACEFOUNDATION");
  CHECK(call_library != NULL);
  *(void**)&call_library = dlsym(library, "interfacefoundation_");
  CHECK(call_library != NULL);
  if (call_library == NULL) return 1;
  if (argc > 2) {
    follow_probes(argv[2]);
  } else {
    write_properties("foundation.txt", 0, 0, "");
    write_properties("hardens.txt", 0, stiffening, "");
    write_properties("sticks.txt", 0.1, 0, "");
    write_properties("twice.txt", 0, 0, "b1 0.5\n");
    write_properties("negative.txt", -0.1, 0, "");
    write_line("short.txt", "");
    write_line("comma.txt", "b1 0,7\n");
    take_locale(); /* after what this program writes */
    check_elastic();
    check_paths();
    check_hardening();
    check_parting();
    check_rollback();
    check_errors();
  }
  return failures == 0 ? 0 : 1;
}

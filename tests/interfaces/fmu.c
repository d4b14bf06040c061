/* SPDX-License-Identifier: BSD-3-Clause */
/* Runs the functional mock-up units of a macro-element as a co-simulation does, and compares them with the macro-element to the bit. Compiled with the
   macro_element.h and macro_element.c that lie beside the units.

   fmu LIBRARY2 RESOURCES2 TOKEN2 LIBRARY3 RESOURCES3 TOKEN3     the resources as a URI and as a path */
#include "check.h"
#include "macro_element.h"

#include <dlfcn.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { OK = 0, ERROR = 3 };

/* As the standard declares them. */
typedef void* instance;
typedef struct {
  void (*logger)(void*, const char*, int, const char*, const char*, ...);
  void* (*allocate)(size_t, size_t);
  void (*release)(void*);
  void (*finished)(void*, int);
  void* environment;
} callbacks2;
typedef instance instantiate2(const char*, int, const char*, const char*, const callbacks2*, int, int);
typedef instance instantiate3(const char*, const char*, const char*, bool, bool, bool, bool, const unsigned*, size_t, void*, void (*)(void*, int, const char*, const char*), void*);
typedef int setup2(instance, int, double, double, int, double);
typedef int initialize3(instance, bool, double, double, bool, double);
typedef int simple(instance);
typedef int get2(instance, const unsigned*, size_t, double*);
typedef int set2(instance, const unsigned*, size_t, const double*);
typedef int get3(instance, const unsigned*, size_t, double*, size_t);
typedef int set3(instance, const unsigned*, size_t, const double*, size_t);
typedef int step2(instance, double, double, int);
typedef int step3(instance, double, double, bool, bool*, bool*, bool*, double*);
typedef int derive2(instance, const unsigned*, size_t, const unsigned*, size_t, const double*, double*);
typedef int derive3(instance, const unsigned*, size_t, const unsigned*, size_t, const double*, size_t, double*, size_t);
typedef int state_to(instance, void**);
typedef int state_from(instance, void*);
typedef int state_size(instance, void*, size_t*);
typedef int state_bytes(instance, void*, char*, size_t);
typedef int state_of_bytes(instance, const char*, size_t, void**);

static void* library;
static int version, logged;

static void* function(const char* name)
{
  char full[100];
  void* found;
  snprintf(full, sizeof full, "fmi%d%s", version, name);
  found = dlsym(library, full);
  if (found == NULL) fprintf(stderr, "no %s\n", full), exit(1);
  return found;
}

static void tell2(void* environment, const char* name, int status, const char* category, const char* message, ...)
{
  (void)message;
  logged += environment == (void*)&library && strcmp(name, "pipe") == 0 && status == ERROR && strcmp(category, "logStatusError") == 0;
}

static void tell3(void* environment, int status, const char* category, const char* message)
{
  logged += environment == (void*)&library && status == ERROR && strcmp(category, "logStatusError") == 0 && *message != 0;
}

static const callbacks2 callbacks = {tell2, calloc, free, NULL, &library};

static instance make(const char* token, const char* resources)
{
  if (version == 2) return ((instantiate2*)function("Instantiate"))("pipe", 1, token, resources, &callbacks, 0, 0);
  return ((instantiate3*)function("InstantiateCoSimulation"))("pipe", token, resources, false, false, false, false, NULL, 0, &library, tell3, NULL);
}

static int enter(instance c)
{
  if (version == 3) return ((initialize3*)function("EnterInitializationMode"))(c, false, 0, 1.5, false, 0);
  CHECK(((setup2*)function("SetupExperiment"))(c, 0, 0, 1.5, 0, 0) == OK);
  return ((simple*)function("EnterInitializationMode"))(c);
}

static int get(instance c, const unsigned* variables, size_t n, double* values)
{
  return version == 2 ? ((get2*)function("GetReal"))(c, variables, n, values) : ((get3*)function("GetFloat64"))(c, variables, n, values, n);
}

static int set(instance c, const unsigned* variables, size_t n, const double* values)
{
  return version == 2 ? ((set2*)function("SetReal"))(c, variables, n, values) : ((set3*)function("SetFloat64"))(c, variables, n, values, n);
}

static int step(instance c, double time, double by)
{
  bool event = true, terminate = true, early = true;
  double last = 0;
  int status;
  if (version == 2) return ((step2*)function("DoStep"))(c, time, by, 0);
  status = ((step3*)function("DoStep"))(c, time, by, false, &event, &terminate, &early, &last);
  CHECK(!event && !terminate && !early && last == (status == OK ? time + by : time));
  return status;
}

static int derive(instance c, const unsigned* of, size_t n_of, const unsigned* by, size_t n_by, const double* seed, double* result)
{
  return version == 2 ? ((derive2*)function("GetDirectionalDerivative"))(c, of, n_of, by, n_by, seed, result)
                      : ((derive3*)function("GetDirectionalDerivative"))(c, of, n_of, by, n_by, seed, n_by, result, n_of);
}

static const char* of_state(const char* two, const char* three)
{
  return version == 2 ? two : three;
}

static const unsigned time_of[1] = {0}, inputs[3] = {1, 2, 3}, outputs[3] = {4, 5, 6}, V_start[1] = {7};

/* A pipe that is pushed to 0.1 D, dragged, lifted and dragged back. */
static void displacement_at(int k, double d[3])
{
  const double D = berm_macro_element_fitted.diameter;
  d[0] = 0.01 * D * sin(0.1 * k);
  d[1] = 0.5 * D * sin(0.03 * k);
  d[2] = 0.1 * D + 0.02 * D * sin(0.011 * k);
}

static instance begin(const char* token, const char* resources, double start[3], double V)
{
  const instance c = make(token, resources);
  if (c == NULL) fprintf(stderr, "no instance of FMI %d\n", version), exit(1);
  CHECK(set(c, inputs, 3, start) == OK && set(c, V_start, 1, &V) == OK);
  CHECK(enter(c) == OK && ((simple*)function("ExitInitializationMode"))(c) == OK);
  return c;
}

static void check_same(instance c, const double F[3])
{
  double values[3];
  CHECK(get(c, outputs, 3, values) == OK && memcmp(values, F, sizeof values) == 0);
}

static void run(const char* token, const char* resources)
{
  const double V = 500, dt = 0.1;
  double d[3], F[3], K[3][3], seed[3] = {1e-3, -2e-3, 3e-3}, result[3], value;
  berm_macro_element_state state, middle;
  void *saved = NULL, *read = NULL;
  char* bytes;
  size_t size = 0;
  int k, i;
  instance c;
  displacement_at(0, d);
  c = begin(token, resources, d, V);
  CHECK(berm_macro_element_start(&berm_macro_element_fitted, d, V, &state) == 0);
  CHECK(get(c, outputs + 2, 1, &value) == OK);
  CHECK_NEAR(value, V, 1e-9 * V);
  CHECK(get(c, time_of, 1, &value) == OK && value == 1.5);
  for (k = 1; k <= 300; ++k) {
    displacement_at(k, d);
    CHECK(set(c, inputs, 3, d) == OK && step(c, 1.5 + dt * (k - 1), dt) == OK);
    CHECK(berm_macro_element_step(&berm_macro_element_fitted, &state, d, &state, F, K) == 0);
    check_same(c, F);
    if (k == 150) {
      CHECK(((state_to*)function(of_state("GetFMUstate", "GetFMUState")))(c, &saved) == OK);
      middle = state;
    }
  }
  CHECK(get(c, time_of, 1, &value) == OK);
  CHECK_NEAR(value, 1.5 + 300 * dt, 1e-9);
  CHECK(derive(c, outputs, 3, inputs, 3, seed, result) == OK);
  for (i = 0; i < 3; ++i) CHECK_NEAR(result[i], K[i][0] * seed[0] + K[i][1] * seed[1] + K[i][2] * seed[2], 1e-9 * fabs(result[i]) + 1e-9);

  /* Back to the middle, by the state and, in another instance, by its bytes. */
  CHECK(((state_from*)function(of_state("SetFMUstate", "SetFMUState")))(c, saved) == OK);
  CHECK(((state_size*)function(of_state("SerializedFMUstateSize", "SerializedFMUStateSize")))(c, saved, &size) == OK && size > 0);
  bytes = malloc(size);
  CHECK(((state_bytes*)function(of_state("SerializeFMUstate", "SerializeFMUState")))(c, saved, bytes, size) == OK);
  {
    const instance other = make(token, resources);
    state = middle;
    CHECK(((state_of_bytes*)function(of_state("DeSerializeFMUstate", "DeserializeFMUState")))(other, bytes, size, &read) == OK);
    CHECK(((state_of_bytes*)function(of_state("DeSerializeFMUstate", "DeserializeFMUState")))(other, bytes, size - 1, &read) == ERROR);
    CHECK(((state_from*)function(of_state("SetFMUstate", "SetFMUState")))(other, read) == OK);
    for (k = 151; k <= 200; ++k) {
      displacement_at(k, d);
      CHECK(set(c, inputs, 3, d) == OK && step(c, 1.5 + dt * (k - 1), dt) == OK);
      CHECK(set(other, inputs, 3, d) == OK && step(other, 1.5 + dt * (k - 1), dt) == OK);
      CHECK(berm_macro_element_step(&berm_macro_element_fitted, &state, d, &state, F, K) == 0);
      check_same(c, F);
      check_same(other, F);
    }
    CHECK(((state_to*)function(of_state("FreeFMUstate", "FreeFMUState")))(other, &read) == OK && read == NULL);
    ((void (*)(instance))function("FreeInstance"))(other);
  }
  CHECK(((state_to*)function(of_state("FreeFMUstate", "FreeFMUState")))(c, &saved) == OK && saved == NULL);
  free(bytes);

  /* Errors are told, and nothing changes. */
  logged = 0;
  d[1] = NAN;
  CHECK(set(c, inputs, 3, d) == OK && step(c, 0, dt) == ERROR && logged == 1);
  check_same(c, F);
  CHECK(set(c, V_start, 1, d) == ERROR && set(c, outputs, 1, d) == ERROR && logged == 3);
  CHECK(((simple*)function("Terminate"))(c) == OK && ((simple*)function("Reset"))(c) == OK);
  CHECK(step(c, 0, dt) == ERROR && logged == 4);
  ((void (*)(instance))function("FreeInstance"))(c);
  CHECK(make("another token", resources) == NULL && logged == 5);
  CHECK(make(token, "/nowhere") == NULL && logged == 6);
}

int main(int argc, char** argv)
{
  for (version = 2; version <= 3 && argc == 7; ++version) {
    char** arguments = argv + 1 + 3 * (version - 2);
    library = dlopen(arguments[0], RTLD_NOW | RTLD_LOCAL);
    if (library == NULL) return fprintf(stderr, "%s\n", dlerror()), 1;
    CHECK(strcmp(((const char* (*)(void))function("GetVersion"))(), version == 2 ? "2.0" : "3.0") == 0);
    run(arguments[2], arguments[1]);
  }
  return argc == 7 && failures == 0 ? 0 : 1;
}

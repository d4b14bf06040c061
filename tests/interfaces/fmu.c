/* SPDX-License-Identifier: BSD-3-Clause */
/* Runs the functional mock-up units of a macro-element as a co-simulation does, and compares them with the macro-element to the bit. Compiled with the
   macro_element.h and macro_element.c that lie beside the units.

   fmu LIBRARY2 RESOURCES2 TOKEN2 LIBRARY3 RESOURCES3 TOKEN3     the resources as a URI and as a path */
#include "fmi.h"
#include "macro_element.h"

static const unsigned time_of[1] = {0}, inputs[3] = {1, 2, 3}, outputs[3] = {4, 5, 6}, V_start[1] = {7};

/* A pipe that is pushed to 0.1 D, dragged, lifted and dragged back. */
static void displacement_at(int k, double d[3])
{
  const double D = berm_macro_element_fitted.diameter;
  d[0] = 0.01 * D * sin(0.1 * k);
  d[1] = 0.5 * D * sin(0.03 * k);
  d[2] = 0.1 * D + 0.02 * D * sin(0.011 * k);
}

/* A master that solves for the start asks for outputs in initialization mode: they are those at its end. */
static instance begin(const char* token, const char* resources, double start[3], double V)
{
  const instance c = make(token, resources);
  const double less = 0.5 * V, nowhere[3] = {0, 0, NAN}, seed[3] = {1, 1, 1};
  double F[3], end[3];
  if (c == NULL) fprintf(stderr, "no instance of FMI %d: %s\n", version, said), exit(1);
  CHECK(set(c, inputs, 3, start) == OK && set(c, V_start, 1, &less) == OK && enter(c) == OK);
  CHECK(get(c, outputs, 3, F) == OK);
  CHECK_NEAR(F[2], less, 1e-9 * V);
  CHECK(set(c, V_start, 1, &V) == OK && get(c, outputs, 3, F) == OK);
  CHECK_NEAR(F[2], V, 1e-9 * V);
  logged = 0;
  CHECK(set(c, inputs, 3, nowhere) == OK && get(c, outputs, 3, end) == ERROR && derive(c, outputs, 3, inputs, 3, seed, end) == ERROR && logged == 2);
  CHECK(set(c, inputs, 3, start) == OK && ((simple*)function("ExitInitializationMode"))(c) == OK);
  CHECK(get(c, outputs, 3, end) == OK && memcmp(F, end, sizeof F) == 0);
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

  /* Of a unit with another token. */
  logged = 0;
  bytes[0] ^= 1;
  CHECK(((state_of_bytes*)function(of_state("DeSerializeFMUstate", "DeserializeFMUState")))(c, bytes, size, &read) == ERROR);
  CHECK(read == NULL && logged == 1 && strstr(said, "another FMU") != NULL);
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
  take_locale();
  for (version = 2; version <= 3 && argc == 7; ++version) {
    char** arguments = argv + 1 + 3 * (version - 2);
    library = dlopen(arguments[0], RTLD_NOW | RTLD_LOCAL);
    if (library == NULL) return fprintf(stderr, "%s\n", dlerror()), 1;
    CHECK(strcmp(((const char* (*)(void))function("GetVersion"))(), version == 2 ? "2.0" : "3.0") == 0);
    run(arguments[2], arguments[1]);
  }
  return argc == 7 && failures == 0 ? 0 : 1;
}

/* SPDX-License-Identifier: BSD-3-Clause */
/* A functional mock-up unit of FMI 2.0 or 3.0 as a co-simulation calls it: one set of calls for both, by `version` and `library`. */
#ifndef BERM_TESTS_FMI_H
#define BERM_TESTS_FMI_H

#include "check.h"

#include <dlfcn.h>
#include <stdarg.h>
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
static char said[1000]; /* the last message */

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
  va_list words;
  va_start(words, message);
  vsnprintf(said, sizeof said, message, words);
  va_end(words);
  logged += environment == (void*)&library && strcmp(name, "pipe") == 0 && status == ERROR && strcmp(category, "logStatusError") == 0;
}

static void tell3(void* environment, int status, const char* category, const char* message)
{
  snprintf(said, sizeof said, "%s", message);
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

#endif

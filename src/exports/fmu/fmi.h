/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef BERM_FMI_H
#define BERM_FMI_H

/* What fmi.c, which has the functions of FMI 2.0 and 3.0 for co-simulation, asks of the model of a functional mock-up unit. C99.
   Types of these interfaces stand here as plain C: an enumeration is an int, a value reference an unsigned int. Functions that return an int give FMI_OK or FMI_ERROR. */
#include <stddef.h>

/* Two units in one program do not take each other's functions. */
#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/* Both versions count alike. */
enum { FMI_OK = 0, FMI_ERROR = 3 };

/* One instance of a unit, as far as messages go: of the two loggers there is one. */
typedef struct {
  char* name;
  void* environment;
  void (*logger2)(void* environment, const char* instance, int status, const char* category, const char* message, ...);
  void (*logger3)(void* environment, int status, const char* category, const char* message);
} fmi_teller;

/* Tells its user what is wrong, and gives FMI_ERROR. */
int fmi_fail(const fmi_teller* teller, const char* words);

/* What an instance computes with. */
typedef struct model model;

/* Of the unit with this token, whose resources lie in that folder. The teller outlives it. NULL where it cannot be. */
model* model_create(const fmi_teller* teller, const char* token, const char* resources);
void model_destroy(model* m);
/* The time at which initialization ends. */
void model_begin(model* m, double time);
int model_initialize(model* m);
int model_step(model* m, double time, double dt);
/* As it was created. */
void model_reset(model* m);
/* Outputs before initialization ends are those that it would end with. */
int model_get(model* m, const unsigned int* variables, size_t n, double* values);
int model_set(model* m, const unsigned int* variables, size_t n, const double* values);
int model_derive(const model* m, const unsigned int* unknowns, size_t n_unknowns, const unsigned int* knowns, size_t n_knowns, const double* seed, double* result);
/* All that changes: kept in *saved, which is NULL or was kept before, and put back. */
int model_save(const model* m, void** saved);
int model_restore(model* m, const void* saved);
void model_forget(const model* m, void* saved);
int model_size(const model* m, size_t* size);
int model_serialize(const model* m, const void* saved, void* bytes, size_t size);
int model_deserialize(const model* m, const void* bytes, size_t size, void** saved);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#endif

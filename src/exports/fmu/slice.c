/* SPDX-License-Identifier: BSD-3-Clause */
/* A slice of soil that the material point method computes, as the model of a functional mock-up unit (fmi.h): berm/slice.h, of a libberm that the loader finds. C99, with fmi.c.

   Inputs v_u, v_w are the velocity of the pipe in the next step; H, V are the mean forces in the last one, u, w and contact_mass those of its end. resources/case.toml is laid
   when initialization ends, or before, where outputs are asked for, up to the stage that resources/unit.txt names behind the token. All that changes is in `changing`. */
#include "fmi.h"

#include <berm/slice.h>
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TIME, INPUT, OUTPUT = INPUT + 2, VARIABLES = OUTPUT + 5 };
enum { TOKEN_LETTERS = 64, STAGE_LETTERS = 255 };

typedef struct {
  berm_slice* slice; /* NULL before it is laid */
  int initialized;
  double time, input[2], output[5];
} changing;

struct model {
  const fmi_teller* teller;
  char* case_file;
  char stage[STAGE_LETTERS + 1];
  changing now;
  __typeof__(berm_slice_open)* open;
  __typeof__(berm_slice_lay)* lay;
  __typeof__(berm_slice_step)* step;
  __typeof__(berm_slice_now)* look;
  __typeof__(berm_slice_clone)* clone;
  __typeof__(berm_slice_close)* close;
  __typeof__(berm_slice_message)* message;
};

static int load_function(void* library, const char* name, void* pointer)
{
  void* found = dlsym(library, name);
  memcpy(pointer, &found, sizeof found);
  return found != NULL;
}

/* It stays loaded. */
static int load_berm(model* m)
{
  void* library = dlopen(BERM_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  return library != NULL && load_function(library, "berm_slice_open", &m->open) && load_function(library, "berm_slice_lay", &m->lay) &&
         load_function(library, "berm_slice_step", &m->step) && load_function(library, "berm_slice_now", &m->look) &&
         load_function(library, "berm_slice_clone", &m->clone) && load_function(library, "berm_slice_close", &m->close) &&
         load_function(library, "berm_slice_message", &m->message);
}

static int read_unit(const char* path, const char* token, char* stage)
{
  char of_unit[TOKEN_LETTERS + 1];
  FILE* file = fopen(path, "r");
  int good;
  if (file == NULL) return 0;
  good = fscanf(file, "token %64s stage %255[^\n]", of_unit, stage) == 2 && strcmp(of_unit, token) == 0;
  fclose(file);
  return good;
}

model* model_create(const fmi_teller* teller, const char* token, const char* resources)
{
  model* m = (model*)calloc(1, sizeof *m);
  const char* wrong = "no memory";
  if (m != NULL) m->case_file = (char*)malloc(strlen(resources) + sizeof "/case.toml");
  if (m != NULL && m->case_file != NULL) {
    m->teller = teller;
    strcat(strcpy(m->case_file, resources), "/unit.txt"); /* as long as case.toml */
    if (!read_unit(m->case_file, token, m->stage)) wrong = "resources/unit.txt cannot be read, is damaged, or is of another FMU than the token (GUID)";
    else if (!load_berm(m)) wrong = "the loader finds no " BERM_LIBRARY " of berm: install it, or name its folder in LD_LIBRARY_PATH before the program starts";
    else wrong = NULL;
    strcat(strcpy(m->case_file, resources), "/case.toml");
  }
  if (wrong == NULL) return m;
  fmi_fail(teller, wrong);
  if (m != NULL) free(m->case_file);
  free(m);
  return NULL;
}

void model_reset(model* m)
{
  m->close(m->now.slice);
  memset(&m->now, 0, sizeof m->now);
}

void model_destroy(model* m)
{
  model_reset(m);
  free(m->case_file);
  free(m);
}

void model_begin(model* m, double time)
{
  m->now.time = time;
}

/* Outputs under these forces of the soil, N/m. A zero has no sign. */
static int look(model* m, const double force[2], const berm_slice_state* state)
{
  const double output[5] = {-force[0] + 0., force[1] + 0., state->u, state->w, state->contact_mass};
  memcpy(m->now.output, output, sizeof output);
  return FMI_OK;
}

/* As the case has it, once: inputs drive the first step. */
static int lay(model* m)
{
  berm_slice_state state;
  berm_slice* slice = NULL;
  if (m->now.slice != NULL) return FMI_OK;
  if (m->open(m->case_file, 0, NULL, &slice) != BERM_SLICE_OK || m->lay(slice, m->stage) != BERM_SLICE_OK || m->look(slice, &state) != BERM_SLICE_OK) {
    fmi_fail(m->teller, m->message());
    m->close(slice);
    return FMI_ERROR;
  }
  m->now.slice = slice;
  return look(m, state.force, &state);
}

int model_initialize(model* m)
{
  if (lay(m) != FMI_OK) return FMI_ERROR;
  m->now.initialized = 1;
  return FMI_OK;
}

int model_step(model* m, double time, double dt)
{
  const double velocity[3] = {m->now.input[0], -m->now.input[1], NAN};
  double force[3];
  berm_slice_state state;
  if (!m->now.initialized) return fmi_fail(m->teller, "a step before the end of initialization");
  if (m->step(m->now.slice, velocity, dt, force) != BERM_SLICE_OK || m->look(m->now.slice, &state) != BERM_SLICE_OK) return fmi_fail(m->teller, m->message());
  m->now.time = time + dt;
  return look(m, force, &state);
}

int model_get(model* m, const unsigned int* variables, size_t n, double* values)
{
  size_t k;
  for (k = 0; k < n; ++k) {
    const unsigned int v = variables[k];
    if (v >= VARIABLES) return fmi_fail(m->teller, "there is no such variable");
    if (v >= OUTPUT && lay(m) != FMI_OK) return FMI_ERROR;
    values[k] = v == TIME ? m->now.time : v < OUTPUT ? m->now.input[v - INPUT] : m->now.output[v - OUTPUT];
  }
  return FMI_OK;
}

int model_set(model* m, const unsigned int* variables, size_t n, const double* values)
{
  size_t k;
  for (k = 0; k < n; ++k) {
    if (variables[k] < INPUT || variables[k] >= OUTPUT) return fmi_fail(m->teller, "only v_u and v_w can be set");
    m->now.input[variables[k] - INPUT] = values[k];
  }
  return FMI_OK;
}

/* A second one in the same state. */
static int copy_state(const model* m, const changing* from, changing* to)
{
  *to = *from;
  if (from->slice == NULL) return FMI_OK;
  to->slice = NULL;
  return m->clone(from->slice, &to->slice) == BERM_SLICE_OK ? FMI_OK : fmi_fail(m->teller, m->message());
}

int model_save(const model* m, void** saved)
{
  changing* copy = (changing*)malloc(sizeof *copy);
  if (copy == NULL) return fmi_fail(m->teller, "no memory");
  if (copy_state(m, &m->now, copy) != FMI_OK) return free(copy), FMI_ERROR;
  if (*saved != NULL) model_forget(m, *saved);
  *saved = copy;
  return FMI_OK;
}

int model_restore(model* m, const void* saved)
{
  changing back;
  if (saved == NULL) return fmi_fail(m->teller, "no state to go back to");
  if (copy_state(m, (const changing*)saved, &back) != FMI_OK) return FMI_ERROR;
  m->close(m->now.slice);
  m->now = back;
  return FMI_OK;
}

void model_forget(const model* m, void* saved)
{
  m->close(((changing*)saved)->slice);
  free(saved);
}

/* What the description says that this unit cannot. */
static int none(const model* m)
{
  return fmi_fail(m->teller, "a slice of soil has no derivatives, and its states are no bytes");
}

int model_derive(const model* m, const unsigned int* unknowns, size_t n_unknowns, const unsigned int* knowns, size_t n_knowns, const double* seed, double* result)
{
  (void)unknowns, (void)n_unknowns, (void)knowns, (void)n_knowns, (void)seed, (void)result;
  return none(m);
}

int model_size(const model* m, size_t* size)
{
  (void)size;
  return none(m);
}

int model_serialize(const model* m, const void* saved, void* bytes, size_t size)
{
  (void)saved, (void)bytes, (void)size;
  return none(m);
}

int model_deserialize(const model* m, const void* bytes, size_t size, void** saved)
{
  (void)bytes, (void)size, (void)saved;
  return none(m);
}

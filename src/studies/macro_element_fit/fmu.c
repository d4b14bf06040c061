/* SPDX-License-Identifier: BSD-3-Clause */
/* The macro-element of a pipe as the model of a functional mock-up unit (fmi.h). C99, with fmi.c and macro_element.c.

   Inputs x, u, w are the displacement at the end of the next step; outputs T, H, V the forces there. Their values when initialization ends are where the pipe
   lies, V_start is the V that acts on it. Parameters of the macro-element are in resources/parameters.txt. All that changes is in `changing`. */
#include "fmi.h"
#include "macro_element.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TIME, INPUT, OUTPUT = INPUT + 3, V_START = OUTPUT + 3, VARIABLES };
enum { TOKEN_LETTERS = 64 };

typedef struct {
  berm_macro_element_state state;
  double time, input[3], V_start, F[3], K[3][3];
  int initialized;
} changing;

struct model {
  const fmi_teller* teller;
  berm_macro_element_parameters parameters;
  changing now;
};

/* A token, the version, then lines of a name and a number; backbone's with w and V. Gives whether all is there. */
static int read_parameters(const char* path, const char* token, berm_macro_element_parameters* p)
{
  char name[TOKEN_LETTERS + 1];
  double value, V;
  int seen = 0, k, good;
  FILE* file = fopen(path, "r");
  if (file == NULL) return 0;
  memset(p, 0, sizeof *p);
  good = fscanf(file, "token %64s version %d", name, &p->version) == 2 && strcmp(name, token) == 0;
  while (good && fscanf(file, "%64s %lf", name, &value) == 2) {
    if (strcmp(name, "backbone") == 0) {
      good = p->backbone_points < BERM_MACRO_ELEMENT_MAX_POINTS && fscanf(file, "%lf", &V) == 1;
      if (!good) break;
      p->backbone_w[p->backbone_points] = value;
      p->backbone_V[p->backbone_points++] = V;
      continue;
    }
    for (k = 0; k < BERM_MACRO_ELEMENT_MEMBERS && strcmp(name, berm_macro_element_members[k].name) != 0; ++k) {}
    good = k < BERM_MACRO_ELEMENT_MEMBERS;
    if (!good) break;
    memcpy((char*)p + berm_macro_element_members[k].offset, &value, sizeof value);
    ++seen;
  }
  fclose(file);
  return good && seen == BERM_MACRO_ELEMENT_MEMBERS && berm_macro_element_check(p, NULL) == BERM_MACRO_ELEMENT_OK;
}

model* model_create(const fmi_teller* teller, const char* token, const char* resources)
{
  model* m = (model*)calloc(1, sizeof *m);
  char* path = (char*)malloc(strlen(resources) + sizeof "/parameters.txt");
  if (m != NULL && path != NULL) {
    m->teller = teller;
    strcat(strcpy(path, resources), "/parameters.txt");
    if (!read_parameters(path, token, &m->parameters)) {
      fmi_fail(teller, "resources/parameters.txt cannot be read, is damaged, or is of another FMU than the token (GUID)");
      free(m), m = NULL;
    }
  } else {
    free(m), m = NULL;
  }
  free(path);
  return m;
}

void model_destroy(model* m)
{
  free(m);
}

void model_reset(model* m)
{
  memset(&m->now, 0, sizeof m->now);
}

void model_begin(model* m, double time)
{
  m->now.time = time;
}

static int move(model* m)
{
  const int error = berm_macro_element_step(&m->parameters, &m->now.state, m->now.input, &m->now.state, m->now.F, m->now.K);
  return error == BERM_MACRO_ELEMENT_OK ? FMI_OK : fmi_fail(m->teller, berm_macro_element_error(error));
}

int model_initialize(model* m)
{
  const int error = berm_macro_element_start(&m->parameters, m->now.input, m->now.V_start, &m->now.state);
  if (error != BERM_MACRO_ELEMENT_OK) return fmi_fail(m->teller, berm_macro_element_error(error));
  m->now.initialized = 1;
  return move(m);
}

int model_step(model* m, double time, double step)
{
  if (!m->now.initialized) return fmi_fail(m->teller, "a step before the end of initialization");
  if (move(m) != FMI_OK) return FMI_ERROR;
  m->now.time = time + step;
  return FMI_OK;
}

int model_get(const model* m, const unsigned int* variables, size_t n, double* values)
{
  size_t k;
  for (k = 0; k < n; ++k) {
    const unsigned int v = variables[k];
    if (v >= VARIABLES) return fmi_fail(m->teller, "there is no such variable");
    values[k] = v == TIME ? m->now.time : v < OUTPUT ? m->now.input[v - INPUT] : v < V_START ? m->now.F[v - OUTPUT] : m->now.V_start;
  }
  return FMI_OK;
}

int model_set(model* m, const unsigned int* variables, size_t n, const double* values)
{
  size_t k;
  for (k = 0; k < n; ++k) {
    const unsigned int v = variables[k];
    if (v >= INPUT && v < OUTPUT) m->now.input[v - INPUT] = values[k];
    else if (v == V_START && !m->now.initialized) m->now.V_start = values[k];
    else return fmi_fail(m->teller, "only x, u, w can be set, and before initialization V_start");
  }
  return FMI_OK;
}

/* Of outputs by inputs, in the last step. */
int model_derive(const model* m, const unsigned int* unknowns, size_t n_unknowns, const unsigned int* knowns, size_t n_knowns, const double* seed, double* result)
{
  size_t i, j;
  for (i = 0; i < n_unknowns; ++i) {
    result[i] = 0;
    for (j = 0; j < n_knowns; ++j) {
      if (unknowns[i] < OUTPUT || unknowns[i] >= V_START || knowns[j] < INPUT || knowns[j] >= OUTPUT) return fmi_fail(m->teller, "derivatives are those of outputs by inputs");
      result[i] += m->now.K[unknowns[i] - OUTPUT][knowns[j] - INPUT] * seed[j];
    }
  }
  return FMI_OK;
}

int model_save(const model* m, void** saved)
{
  if (*saved == NULL) *saved = calloc(1, sizeof m->now);
  if (*saved == NULL) return fmi_fail(m->teller, "no memory");
  memcpy(*saved, &m->now, sizeof m->now);
  return FMI_OK;
}

int model_restore(model* m, const void* saved)
{
  if (saved == NULL) return fmi_fail(m->teller, "no state to go back to");
  memcpy(&m->now, saved, sizeof m->now);
  return FMI_OK;
}

int model_serialize(const model* m, const void* saved, void* bytes, size_t size)
{
  if (saved == NULL || size < sizeof m->now) return fmi_fail(m->teller, "too little room for a state");
  memcpy(bytes, saved, sizeof m->now);
  return FMI_OK;
}

int model_deserialize(const model* m, const void* bytes, size_t size, void** saved)
{
  changing read;
  if (size != sizeof read) return fmi_fail(m->teller, "bytes that are no state");
  memcpy(&read, bytes, sizeof read);
  if (read.initialized && read.state.version != BERM_MACRO_ELEMENT_VERSION) return fmi_fail(m->teller, "a state of another version");
  *saved = malloc(sizeof read);
  if (*saved == NULL) return fmi_fail(m->teller, "no memory");
  memcpy(*saved, bytes, sizeof read);
  return FMI_OK;
}

void model_forget(const model* m, void* saved)
{
  (void)m;
  free(saved);
}

int model_size(const model* m, size_t* size)
{
  *size = sizeof m->now;
  return FMI_OK;
}

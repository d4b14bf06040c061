/* SPDX-License-Identifier: BSD-3-Clause */
/* The macro-element of a pipe as the model of a functional mock-up unit (fmi.h). C99, with fmi.c and macro_element.c.

   Inputs x, u, w are the displacement at the end of the next step; outputs T, H, V the forces there. Their values when initialization ends are where the pipe
   lies, V_start is the V that acts on it; until then outputs are those of a start with the inputs as they are. Parameters of the macro-element are in resources/parameters.txt. All that changes is in `changing`. */
#include "fmi.h"
#include "macro_element.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TIME, INPUT, OUTPUT = INPUT + 3, V_START = OUTPUT + 3, VARIABLES };
enum { TOKEN_LETTERS = 64, NUMBER_LETTERS = 64 };

typedef struct {
  berm_macro_element_state state;
  double time, input[3], V_start, F[3], K[3][3];
  int initialized;
} changing;

/* A state as bytes: of the unit with this token. */
typedef struct {
  char token[TOKEN_LETTERS];
  changing now;
} bytes_of_state;

struct model {
  const fmi_teller* teller;
  char token[TOKEN_LETTERS];
  berm_macro_element_parameters parameters;
  changing now;
};

/* A token, the version, then lines of a name and a number; backbone's with w and V. Gives whether all is there. */
static int read_parameters(const char* path, const char* token, berm_macro_element_parameters* p)
{
  char name[TOKEN_LETTERS + 1], number[NUMBER_LETTERS + 1];
  double value, V;
  int seen = 0, k, good;
  FILE* file = fopen(path, "r");
  if (file == NULL) return 0;
  memset(p, 0, sizeof *p);
  good = fscanf(file, "token %64s version %d", name, &p->version) == 2 && strcmp(name, token) == 0;
  while (good && fscanf(file, "%64s %64s", name, number) == 2) {
    good = berm_macro_element_read_number(number, &value) != NULL;
    if (!good) break;
    if (strcmp(name, "backbone") == 0) {
      good = p->backbone_points < BERM_MACRO_ELEMENT_MAX_POINTS && fscanf(file, "%64s", number) == 1 && berm_macro_element_read_number(number, &V) != NULL;
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
    } else {
      memcpy(m->token, token, strlen(token)); /* no longer than the one in the file */
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

static int move(const model* m, changing* now)
{
  const int error = berm_macro_element_step(&m->parameters, &now->state, now->input, &now->state, now->F, now->K);
  return error == BERM_MACRO_ELEMENT_OK ? FMI_OK : fmi_fail(m->teller, berm_macro_element_error(error));
}

/* Lays the pipe where the inputs have it. */
static int start(const model* m, changing* now)
{
  const int error = berm_macro_element_start(&m->parameters, now->input, now->V_start, &now->state);
  if (error != BERM_MACRO_ELEMENT_OK) return fmi_fail(m->teller, berm_macro_element_error(error));
  now->initialized = 1;
  return move(m, now);
}

int model_initialize(model* m)
{
  return start(m, &m->now);
}

int model_step(model* m, double time, double step)
{
  if (!m->now.initialized) return fmi_fail(m->teller, "a step before the end of initialization");
  if (move(m, &m->now) != FMI_OK) return FMI_ERROR;
  m->now.time = time + step;
  return FMI_OK;
}

int model_get(model* m, const unsigned int* variables, size_t n, double* values)
{
  changing now = m->now;
  size_t k;
  for (k = 0; k < n; ++k) {
    const unsigned int v = variables[k];
    if (v >= VARIABLES) return fmi_fail(m->teller, "there is no such variable");
    if (v >= OUTPUT && v < V_START && !now.initialized && start(m, &now) != FMI_OK) return FMI_ERROR;
    values[k] = v == TIME ? now.time : v < OUTPUT ? now.input[v - INPUT] : v < V_START ? now.F[v - OUTPUT] : now.V_start;
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
  if (!m->now.initialized) return fmi_fail(m->teller, "derivatives are those of a step, after the end of initialization");
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
  bytes_of_state written;
  if (saved == NULL || size < sizeof written) return fmi_fail(m->teller, "too little room for a state");
  memset(&written, 0, sizeof written);
  memcpy(written.token, m->token, sizeof written.token);
  memcpy(&written.now, saved, sizeof written.now);
  memcpy(bytes, &written, sizeof written);
  return FMI_OK;
}

int model_deserialize(const model* m, const void* bytes, size_t size, void** saved)
{
  bytes_of_state read;
  if (size != sizeof read) return fmi_fail(m->teller, "bytes that are no state");
  memcpy(&read, bytes, sizeof read);
  if (memcmp(read.token, m->token, sizeof read.token) != 0) return fmi_fail(m->teller, "a state of another FMU: it has another token (GUID), as of other parameters");
  if (read.now.initialized && read.now.state.version != BERM_MACRO_ELEMENT_VERSION) return fmi_fail(m->teller, "a state of another version");
  *saved = malloc(sizeof read.now);
  if (*saved == NULL) return fmi_fail(m->teller, "no memory");
  memcpy(*saved, &read.now, sizeof read.now);
  return FMI_OK;
}

void model_forget(const model* m, void* saved)
{
  (void)m;
  free(saved);
}

int model_size(const model* m, size_t* size)
{
  (void)m;
  *size = sizeof(bytes_of_state);
  return FMI_OK;
}

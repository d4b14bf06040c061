/* SPDX-License-Identifier: BSD-3-Clause */
/* The macro-element of a pipe as a functional mock-up unit for co-simulation: both FMI 2.0 and 3.0 (fmi-standard.org), one library. C99, with macro_element.c.
   Types of these interfaces stand here as plain C: an enumeration is an int, a value reference an unsigned int.

   Inputs x, u, w are the displacement at the end of the next step; outputs T, H, V the forces there. Their values when initialization ends are where the pipe
   lies, V_start is the V that acts on it. Parameters of the macro-element are in resources/parameters.txt. All that changes is in `changing`. */
#include "macro_element.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Both versions count alike. */
enum { OK = 0, ERROR = 3 };
enum { TIME, INPUT, OUTPUT = INPUT + 3, V_START = OUTPUT + 3, VARIABLES };
enum { TOKEN_LETTERS = 64 };

typedef struct {
  berm_macro_element_state state;
  double time, input[3], V_start, F[3], K[3][3];
  int initialized;
} changing;

typedef void log2(void* environment, const char* instance, int status, const char* category, const char* message, ...);
typedef void log3(void* environment, int status, const char* category, const char* message);

typedef struct {
  berm_macro_element_parameters parameters;
  changing now;
  char* name;
  void* environment;
  log2* logger2;
  log3* logger3;
} instance;

static int fail(const instance* c, const char* words)
{
  if (c != NULL && c->logger2 != NULL) c->logger2(c->environment, c->name, ERROR, "logStatusError", "%s", words);
  if (c != NULL && c->logger3 != NULL) c->logger3(c->environment, ERROR, "logStatusError", words);
  return ERROR;
}

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

static int reset(instance* c)
{
  memset(&c->now, 0, sizeof c->now);
  return OK;
}

/* resources: a path, or where it is a URI its path. */
static instance* create(const char* name, const char* token, const char* resources, void* environment, log2* logger2, log3* logger3)
{
  instance* c = (instance*)calloc(1, sizeof *c);
  char* path;
  size_t k, n = 0;
  if (c == NULL || name == NULL || token == NULL || resources == NULL) return free(c), (instance*)NULL;
  c->environment = environment;
  c->logger2 = logger2;
  c->logger3 = logger3;
  c->name = (char*)malloc(strlen(name) + 1);
  path = (char*)malloc(strlen(resources) + sizeof "/parameters.txt");
  if (c->name == NULL || path == NULL) return free(c->name), free(path), free(c), (instance*)NULL;
  strcpy(c->name, name);
  if (strncmp(resources, "file:", 5) == 0) {
    unsigned int letter;
    resources += 5;
    if (strncmp(resources, "//", 2) == 0) resources = strchr(resources + 2, '/');
    for (k = 0; resources != NULL && resources[k] != 0; ++k) {
      if (resources[k] == '%' && sscanf(resources + k + 1, "%2x", &letter) == 1) path[n++] = (char)letter, k += 2;
      else path[n++] = resources[k];
    }
  } else {
    n = strlen(resources);
    memcpy(path, resources, n);
  }
  strcpy(path + n, "/parameters.txt");
  if (!read_parameters(path, token, &c->parameters)) {
    fail(c, "resources/parameters.txt cannot be read, is damaged, or is of another FMU than the token (GUID)");
    free(c->name), free(c), c = NULL;
  }
  free(path);
  return c;
}

static void destroy(instance* c)
{
  if (c != NULL) free(c->name);
  free(c);
}

static int move(instance* c)
{
  const int error = berm_macro_element_step(&c->parameters, &c->now.state, c->now.input, &c->now.state, c->now.F, c->now.K);
  return error == BERM_MACRO_ELEMENT_OK ? OK : fail(c, berm_macro_element_error(error));
}

static int initialize(instance* c)
{
  const int error = berm_macro_element_start(&c->parameters, c->now.input, c->now.V_start, &c->now.state);
  if (error != BERM_MACRO_ELEMENT_OK) return fail(c, berm_macro_element_error(error));
  c->now.initialized = 1;
  return move(c);
}

static int do_step(instance* c, double time, double step)
{
  if (!c->now.initialized) return fail(c, "a step before the end of initialization");
  if (move(c) != OK) return ERROR;
  c->now.time = time + step;
  return OK;
}

static int get(const instance* c, const unsigned int* variables, size_t n, double* values)
{
  size_t k;
  for (k = 0; k < n; ++k) {
    const unsigned int v = variables[k];
    if (v >= VARIABLES) return fail(c, "there is no such variable");
    values[k] = v == TIME ? c->now.time : v < OUTPUT ? c->now.input[v - INPUT] : v < V_START ? c->now.F[v - OUTPUT] : c->now.V_start;
  }
  return OK;
}

static int set(instance* c, const unsigned int* variables, size_t n, const double* values)
{
  size_t k;
  for (k = 0; k < n; ++k) {
    const unsigned int v = variables[k];
    if (v >= INPUT && v < OUTPUT) c->now.input[v - INPUT] = values[k];
    else if (v == V_START && !c->now.initialized) c->now.V_start = values[k];
    else return fail(c, "only x, u, w can be set, and before initialization V_start");
  }
  return OK;
}

/* Of outputs by inputs, in the last step. */
static int derive(const instance* c, const unsigned int* unknowns, size_t n_unknowns, const unsigned int* knowns, size_t n_knowns, const double* seed, double* result)
{
  size_t i, j;
  for (i = 0; i < n_unknowns; ++i) {
    result[i] = 0;
    for (j = 0; j < n_knowns; ++j) {
      if (unknowns[i] < OUTPUT || unknowns[i] >= V_START || knowns[j] < INPUT || knowns[j] >= OUTPUT) return fail(c, "derivatives are those of outputs by inputs");
      result[i] += c->now.K[unknowns[i] - OUTPUT][knowns[j] - INPUT] * seed[j];
    }
  }
  return OK;
}

static int save(const instance* c, void** saved)
{
  if (*saved == NULL) *saved = calloc(1, sizeof c->now);
  if (*saved == NULL) return fail(c, "no memory");
  memcpy(*saved, &c->now, sizeof c->now);
  return OK;
}

static int restore(instance* c, const void* saved)
{
  if (saved == NULL) return fail(c, "no state to go back to");
  memcpy(&c->now, saved, sizeof c->now);
  return OK;
}

static int serialize(const instance* c, const void* saved, void* bytes, size_t size)
{
  if (saved == NULL || size < sizeof c->now) return fail(c, "too little room for a state");
  memcpy(bytes, saved, sizeof c->now);
  return OK;
}

static int deserialize(const instance* c, const void* bytes, size_t size, void** saved)
{
  changing read;
  if (size != sizeof read) return fail(c, "bytes that are no state");
  memcpy(&read, bytes, sizeof read);
  if (read.initialized && read.state.version != BERM_MACRO_ELEMENT_VERSION) return fail(c, "a state of another version");
  *saved = malloc(sizeof read);
  if (*saved == NULL) return fail(c, "no memory");
  memcpy(*saved, bytes, sizeof read);
  return OK;
}

static int forget(void** saved)
{
  if (saved != NULL) free(*saved), *saved = NULL;
  return OK;
}

#if defined _WIN32
#define EXPORT __declspec(dllexport)
#else
#define EXPORT
#endif
/* A function and its declaration. */
#define FUNCTION(type, name, arguments) \
  EXPORT type name arguments;           \
  EXPORT type name arguments
/* A function that has nothing to do. It needs no name for the arguments behind the first: who calls takes them off the stack. */
#define DONE(name)               \
  FUNCTION(int, name, (void* c)) \
  {                              \
    (void)c;                     \
    return OK;                   \
  }
/* One of what this FMU does not have. */
#define NONE(name)                                                            \
  FUNCTION(int, name, (void* c))                                              \
  {                                                                           \
    return fail((const instance*)c, #name ": this FMU has nothing of the kind"); \
  }
/* Variables of a type that this FMU does not have: none of them can be asked for. */
#define NONE_OF_TYPE(name)                                                                                        \
  FUNCTION(int, name, (void* c, const unsigned int* variables, size_t n))                                         \
  {                                                                                                               \
    (void)variables;                                                                                              \
    return n == 0 ? OK : fail((const instance*)c, #name ": this FMU has no variable of the type"); \
  }

/* FMI 2.0 */
typedef struct {
  log2* logger;
  void *allocate, *release, *finished, *environment;
} callbacks2;

FUNCTION(const char*, fmi2GetTypesPlatform, (void))
{
  return "default";
}
FUNCTION(const char*, fmi2GetVersion, (void))
{
  return "2.0";
}
DONE(fmi2SetDebugLogging)
FUNCTION(void*, fmi2Instantiate, (const char* name, int type, const char* token, const char* resources, const callbacks2* callbacks, int visible, int logging))
{
  (void)visible, (void)logging;
  return type != 1 || callbacks == NULL ? NULL : create(name, token, resources, callbacks->environment, callbacks->logger, NULL);
}
FUNCTION(void, fmi2FreeInstance, (void* c))
{
  destroy((instance*)c);
}
FUNCTION(int, fmi2SetupExperiment, (void* c, int has_tolerance, double tolerance, double start, int has_stop, double stop))
{
  (void)has_tolerance, (void)tolerance, (void)has_stop, (void)stop;
  ((instance*)c)->now.time = start;
  return OK;
}
DONE(fmi2EnterInitializationMode)
FUNCTION(int, fmi2ExitInitializationMode, (void* c))
{
  return initialize((instance*)c);
}
DONE(fmi2Terminate)
FUNCTION(int, fmi2Reset, (void* c))
{
  return reset((instance*)c);
}
FUNCTION(int, fmi2GetReal, (void* c, const unsigned int* variables, size_t n, double* values))
{
  return get((const instance*)c, variables, n, values);
}
FUNCTION(int, fmi2SetReal, (void* c, const unsigned int* variables, size_t n, const double* values))
{
  return set((instance*)c, variables, n, values);
}
NONE_OF_TYPE(fmi2GetInteger)
NONE_OF_TYPE(fmi2GetBoolean)
NONE_OF_TYPE(fmi2GetString)
NONE_OF_TYPE(fmi2SetInteger)
NONE_OF_TYPE(fmi2SetBoolean)
NONE_OF_TYPE(fmi2SetString)
FUNCTION(int, fmi2GetFMUstate, (void* c, void** saved))
{
  return save((const instance*)c, saved);
}
FUNCTION(int, fmi2SetFMUstate, (void* c, void* saved))
{
  return restore((instance*)c, saved);
}
FUNCTION(int, fmi2FreeFMUstate, (void* c, void** saved))
{
  (void)c;
  return forget(saved);
}
FUNCTION(int, fmi2SerializedFMUstateSize, (void* c, void* saved, size_t* size))
{
  (void)c, (void)saved;
  *size = sizeof(changing);
  return OK;
}
FUNCTION(int, fmi2SerializeFMUstate, (void* c, void* saved, char* bytes, size_t size))
{
  return serialize((const instance*)c, saved, bytes, size);
}
FUNCTION(int, fmi2DeSerializeFMUstate, (void* c, const char* bytes, size_t size, void** saved))
{
  return deserialize((const instance*)c, bytes, size, saved);
}
FUNCTION(int, fmi2GetDirectionalDerivative,
         (void* c, const unsigned int* unknowns, size_t n_unknowns, const unsigned int* knowns, size_t n_knowns, const double* seed, double* result))
{
  return derive((const instance*)c, unknowns, n_unknowns, knowns, n_knowns, seed, result);
}
FUNCTION(int, fmi2DoStep, (void* c, double time, double step, int no_return))
{
  (void)no_return;
  return do_step((instance*)c, time, step);
}
NONE(fmi2SetRealInputDerivatives)
NONE(fmi2GetRealOutputDerivatives)
NONE(fmi2CancelStep)
NONE(fmi2GetStatus)
NONE(fmi2GetRealStatus)
NONE(fmi2GetIntegerStatus)
NONE(fmi2GetBooleanStatus)
NONE(fmi2GetStringStatus)

/* FMI 3.0 */
FUNCTION(const char*, fmi3GetVersion, (void))
{
  return "3.0";
}
DONE(fmi3SetDebugLogging)
FUNCTION(void*, fmi3InstantiateModelExchange, (void))
{
  return NULL;
}
FUNCTION(void*, fmi3InstantiateScheduledExecution, (void))
{
  return NULL;
}
FUNCTION(void*, fmi3InstantiateCoSimulation,
         (const char* name, const char* token, const char* resources, bool visible, bool logging, bool events, bool early, const unsigned int* intermediate,
          size_t n_intermediate, void* environment, log3* logger, void* update))
{
  (void)visible, (void)logging, (void)events, (void)early, (void)intermediate, (void)n_intermediate, (void)update;
  return create(name, token, resources, environment, NULL, logger);
}
FUNCTION(void, fmi3FreeInstance, (void* c))
{
  destroy((instance*)c);
}
FUNCTION(int, fmi3EnterInitializationMode, (void* c, bool has_tolerance, double tolerance, double start, bool has_stop, double stop))
{
  return fmi2SetupExperiment(c, has_tolerance, tolerance, start, has_stop, stop);
}
FUNCTION(int, fmi3ExitInitializationMode, (void* c))
{
  return initialize((instance*)c);
}
DONE(fmi3Terminate)
FUNCTION(int, fmi3Reset, (void* c))
{
  return reset((instance*)c);
}
FUNCTION(int, fmi3GetFloat64, (void* c, const unsigned int* variables, size_t n, double* values, size_t n_values))
{
  return n_values != n ? fail((const instance*)c, "each variable is one number") : get((const instance*)c, variables, n, values);
}
FUNCTION(int, fmi3SetFloat64, (void* c, const unsigned int* variables, size_t n, const double* values, size_t n_values))
{
  return n_values != n ? fail((const instance*)c, "each variable is one number") : set((instance*)c, variables, n, values);
}
#define NEITHER(type)           \
  NONE_OF_TYPE(fmi3Get##type)   \
  NONE_OF_TYPE(fmi3Set##type)
NEITHER(Float32)
NEITHER(Int8)
NEITHER(UInt8)
NEITHER(Int16)
NEITHER(UInt16)
NEITHER(Int32)
NEITHER(UInt32)
NEITHER(Int64)
NEITHER(UInt64)
NEITHER(Boolean)
NEITHER(String)
NEITHER(Binary)
NEITHER(Clock)
FUNCTION(int, fmi3GetFMUState, (void* c, void** saved))
{
  return save((const instance*)c, saved);
}
FUNCTION(int, fmi3SetFMUState, (void* c, void* saved))
{
  return restore((instance*)c, saved);
}
FUNCTION(int, fmi3FreeFMUState, (void* c, void** saved))
{
  (void)c;
  return forget(saved);
}
FUNCTION(int, fmi3SerializedFMUStateSize, (void* c, void* saved, size_t* size))
{
  return fmi2SerializedFMUstateSize(c, saved, size);
}
FUNCTION(int, fmi3SerializeFMUState, (void* c, void* saved, unsigned char* bytes, size_t size))
{
  return serialize((const instance*)c, saved, bytes, size);
}
FUNCTION(int, fmi3DeserializeFMUState, (void* c, const unsigned char* bytes, size_t size, void** saved))
{
  return deserialize((const instance*)c, bytes, size, saved);
}
FUNCTION(int, fmi3GetDirectionalDerivative,
         (void* c, const unsigned int* unknowns, size_t n_unknowns, const unsigned int* knowns, size_t n_knowns, const double* seed, size_t n_seed, double* result,
          size_t n_result))
{
  if (n_seed != n_knowns || n_result != n_unknowns) return fail((const instance*)c, "each variable is one number");
  return derive((const instance*)c, unknowns, n_unknowns, knowns, n_knowns, seed, result);
}
FUNCTION(int, fmi3DoStep,
         (void* c, double time, double step, bool no_return, bool* event, bool* terminate, bool* early, double* last_time))
{
  const int status = do_step((instance*)c, time, step);
  (void)no_return;
  *event = *terminate = *early = false;
  *last_time = status == OK ? time + step : time;
  return status;
}
NONE(fmi3EnterEventMode)
NONE(fmi3GetNumberOfVariableDependencies)
NONE(fmi3GetVariableDependencies)
NONE(fmi3GetAdjointDerivative)
NONE(fmi3EnterConfigurationMode)
NONE(fmi3ExitConfigurationMode)
NONE(fmi3GetIntervalDecimal)
NONE(fmi3GetIntervalFraction)
NONE(fmi3GetShiftDecimal)
NONE(fmi3GetShiftFraction)
NONE(fmi3SetIntervalDecimal)
NONE(fmi3SetIntervalFraction)
NONE(fmi3SetShiftDecimal)
NONE(fmi3SetShiftFraction)
NONE(fmi3EvaluateDiscreteStates)
NONE(fmi3UpdateDiscreteStates)
NONE(fmi3EnterContinuousTimeMode)
NONE(fmi3CompletedIntegratorStep)
NONE(fmi3SetTime)
NONE(fmi3SetContinuousStates)
NONE(fmi3GetContinuousStateDerivatives)
NONE(fmi3GetEventIndicators)
NONE(fmi3GetContinuousStates)
NONE(fmi3GetNominalsOfContinuousStates)
NONE(fmi3GetNumberOfEventIndicators)
NONE(fmi3GetNumberOfContinuousStates)
NONE(fmi3EnterStepMode)
NONE(fmi3GetOutputDerivatives)
NONE(fmi3ActivateModelPartition)

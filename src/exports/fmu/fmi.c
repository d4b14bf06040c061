/* SPDX-License-Identifier: BSD-3-Clause */
/* The functions of FMI 2.0 and 3.0 for co-simulation (fmi-standard.org), over those of a model (fmi.h): one library is a unit of both versions. C99. */
#include "fmi.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  fmi_teller teller;
  model* model;
} instance;

int fmi_fail(const fmi_teller* teller, const char* words)
{
  if (teller->logger2 != NULL) teller->logger2(teller->environment, teller->name, FMI_ERROR, "logStatusError", "%s", words);
  if (teller->logger3 != NULL) teller->logger3(teller->environment, FMI_ERROR, "logStatusError", words);
  return FMI_ERROR;
}

static int fail(const void* c, const char* words)
{
  return c == NULL ? FMI_ERROR : fmi_fail(&((const instance*)c)->teller, words);
}

static model* model_of(void* c)
{
  return ((instance*)c)->model;
}

static void destroy(instance* c)
{
  if (c == NULL) return;
  if (c->model != NULL) model_destroy(c->model);
  free(c->teller.name);
  free(c);
}

/* The path of a folder, which may be given as a URI; NULL where there is none, or no memory. */
static char* path_of(const char* resources)
{
  char* path = (char*)malloc(strlen(resources) + 1);
  unsigned int letter;
  size_t k, n = 0;
  if (path == NULL || strncmp(resources, "file:", 5) != 0) return path == NULL ? NULL : strcpy(path, resources);
  resources += 5;
  if (strncmp(resources, "//", 2) == 0) resources = strchr(resources + 2, '/');
  for (k = 0; resources != NULL && resources[k] != 0; ++k) {
    if (resources[k] == '%' && isxdigit((unsigned char)resources[k + 1]) && isxdigit((unsigned char)resources[k + 2])) {
      sscanf(resources + k + 1, "%2x", &letter);
      path[n++] = (char)letter, k += 2;
    }
    else path[n++] = resources[k];
  }
  path[n] = 0;
  return path;
}

static instance* create(const char* name, const char* token, const char* resources, fmi_teller teller)
{
  instance* c = name == NULL || token == NULL || resources == NULL ? NULL : (instance*)calloc(1, sizeof *c);
  char* path;
  if (c == NULL) return NULL;
  c->teller = teller;
  c->teller.name = (char*)malloc(strlen(name) + 1);
  path = path_of(resources);
  if (c->teller.name != NULL && path != NULL) {
    strcpy(c->teller.name, name);
    c->model = model_create(&c->teller, token, path);
  }
  free(path);
  if (c->model == NULL) destroy(c), c = NULL;
  return c;
}

#if defined _WIN32
#define EXPORT __declspec(dllexport)
#elif defined __GNUC__
#define EXPORT __attribute__((visibility("default")))
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
    return FMI_OK;                   \
  }
/* One of what this FMU does not have. */
#define NONE(name)                                                            \
  FUNCTION(int, name, (void* c))                                              \
  {                                                                           \
    return fail(c, #name ": this FMU has nothing of the kind"); \
  }
/* Variables of a type that this FMU does not have: none of them can be asked for. */
#define NONE_OF_TYPE(name)                                                                                        \
  FUNCTION(int, name, (void* c, const unsigned int* variables, size_t n))                                         \
  {                                                                                                               \
    (void)variables;                                                                                              \
    return n == 0 ? FMI_OK : fail(c, #name ": this FMU has no variable of the type"); \
  }

/* FMI 2.0 */
typedef struct {
  void (*logger)(void*, const char*, int, const char*, const char*, ...);
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
  return type != 1 || callbacks == NULL ? NULL : create(name, token, resources, (fmi_teller){NULL, callbacks->environment, callbacks->logger, NULL});
}
FUNCTION(void, fmi2FreeInstance, (void* c))
{
  destroy((instance*)c);
}
FUNCTION(int, fmi2SetupExperiment, (void* c, int has_tolerance, double tolerance, double start, int has_stop, double stop))
{
  (void)has_tolerance, (void)tolerance, (void)has_stop, (void)stop;
  model_begin(model_of(c), start);
  return FMI_OK;
}
DONE(fmi2EnterInitializationMode)
FUNCTION(int, fmi2ExitInitializationMode, (void* c))
{
  return model_initialize(model_of(c));
}
DONE(fmi2Terminate)
FUNCTION(int, fmi2Reset, (void* c))
{
  model_reset(model_of(c));
  return FMI_OK;
}
FUNCTION(int, fmi2GetReal, (void* c, const unsigned int* variables, size_t n, double* values))
{
  return model_get(model_of(c), variables, n, values);
}
FUNCTION(int, fmi2SetReal, (void* c, const unsigned int* variables, size_t n, const double* values))
{
  return model_set(model_of(c), variables, n, values);
}
NONE_OF_TYPE(fmi2GetInteger)
NONE_OF_TYPE(fmi2GetBoolean)
NONE_OF_TYPE(fmi2GetString)
NONE_OF_TYPE(fmi2SetInteger)
NONE_OF_TYPE(fmi2SetBoolean)
NONE_OF_TYPE(fmi2SetString)
FUNCTION(int, fmi2GetFMUstate, (void* c, void** saved))
{
  return model_save(model_of(c), saved);
}
FUNCTION(int, fmi2SetFMUstate, (void* c, void* saved))
{
  return model_restore(model_of(c), saved);
}
FUNCTION(int, fmi2FreeFMUstate, (void* c, void** saved))
{
  if (saved != NULL && *saved != NULL) model_forget(model_of(c), *saved), *saved = NULL;
  return FMI_OK;
}
FUNCTION(int, fmi2SerializedFMUstateSize, (void* c, void* saved, size_t* size))
{
  (void)saved;
  return model_size(model_of(c), size);
}
FUNCTION(int, fmi2SerializeFMUstate, (void* c, void* saved, char* bytes, size_t size))
{
  return model_serialize(model_of(c), saved, bytes, size);
}
FUNCTION(int, fmi2DeSerializeFMUstate, (void* c, const char* bytes, size_t size, void** saved))
{
  return model_deserialize(model_of(c), bytes, size, saved);
}
FUNCTION(int, fmi2GetDirectionalDerivative,
         (void* c, const unsigned int* unknowns, size_t n_unknowns, const unsigned int* knowns, size_t n_knowns, const double* seed, double* result))
{
  return model_derive(model_of(c), unknowns, n_unknowns, knowns, n_knowns, seed, result);
}
FUNCTION(int, fmi2DoStep, (void* c, double time, double step, int no_return))
{
  (void)no_return;
  return model_step(model_of(c), time, step);
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
          size_t n_intermediate, void* environment, void (*logger)(void*, int, const char*, const char*), void* update))
{
  (void)visible, (void)logging, (void)events, (void)early, (void)intermediate, (void)n_intermediate, (void)update;
  return create(name, token, resources, (fmi_teller){NULL, environment, NULL, logger});
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
  return model_initialize(model_of(c));
}
DONE(fmi3Terminate)
FUNCTION(int, fmi3Reset, (void* c))
{
  model_reset(model_of(c));
  return FMI_OK;
}
FUNCTION(int, fmi3GetFloat64, (void* c, const unsigned int* variables, size_t n, double* values, size_t n_values))
{
  return n_values != n ? fail(c, "each variable is one number") : model_get(model_of(c), variables, n, values);
}
FUNCTION(int, fmi3SetFloat64, (void* c, const unsigned int* variables, size_t n, const double* values, size_t n_values))
{
  return n_values != n ? fail(c, "each variable is one number") : model_set(model_of(c), variables, n, values);
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
  return model_save(model_of(c), saved);
}
FUNCTION(int, fmi3SetFMUState, (void* c, void* saved))
{
  return model_restore(model_of(c), saved);
}
FUNCTION(int, fmi3FreeFMUState, (void* c, void** saved))
{
  if (saved != NULL && *saved != NULL) model_forget(model_of(c), *saved), *saved = NULL;
  return FMI_OK;
}
FUNCTION(int, fmi3SerializedFMUStateSize, (void* c, void* saved, size_t* size))
{
  return fmi2SerializedFMUstateSize(c, saved, size);
}
FUNCTION(int, fmi3SerializeFMUState, (void* c, void* saved, unsigned char* bytes, size_t size))
{
  return model_serialize(model_of(c), saved, bytes, size);
}
FUNCTION(int, fmi3DeserializeFMUState, (void* c, const unsigned char* bytes, size_t size, void** saved))
{
  return model_deserialize(model_of(c), bytes, size, saved);
}
FUNCTION(int, fmi3GetDirectionalDerivative,
         (void* c, const unsigned int* unknowns, size_t n_unknowns, const unsigned int* knowns, size_t n_knowns, const double* seed, size_t n_seed, double* result,
          size_t n_result))
{
  if (n_seed != n_knowns || n_result != n_unknowns) return fail(c, "each variable is one number");
  return model_derive(model_of(c), unknowns, n_unknowns, knowns, n_knowns, seed, result);
}
FUNCTION(int, fmi3DoStep,
         (void* c, double time, double step, bool no_return, bool* event, bool* terminate, bool* early, double* last_time))
{
  const int status = model_step(model_of(c), time, step);
  (void)no_return;
  *event = *terminate = *early = false;
  *last_time = status == FMI_OK ? time + step : time;
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

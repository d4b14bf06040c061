/* SPDX-License-Identifier: BSD-3-Clause */
/* The macro-element as external functions of OrcaFlex: the soil's force on a node of a line on a level seabed, as three applied loads, global X, Y and Z (kN).

   Applied load of a line at the node: X = soil_force_x, Y = soil_force_y, Z = soil_force_z of this library, with implicit integration. Its parameters in order:
   length of line at the node (m), Z of the seabed (m), heading of the line (degrees), embedment at the start (m), V at the start (N/m), separated by blanks.
   Take the seabed's own normal and shear stiffness away there, or it acts besides.

   cc -O2 -shared orcaflex.c macro_element.c -o soil.dll -lm        (for Windows, where OrcaFlex runs)
   Written to the public documentation of OrcFxAPI (TExtFnInfo, TNodeInstantaneousCalculationData, RegisterCapabilities); a test calls it, OrcaFlex has not. */
#include "macro_element.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if defined _WIN32
#define EXPORT __declspec(dllexport)
#define CALL __stdcall
#else
#define EXPORT
#define CALL
#endif

/* What OrcaFlex hands over, up to the last member that is used here. */
typedef struct {
  int Size, Action;
  double SimulationTime, Value;
  int Successful;
  void* ObjectHandle;
  const void* lpObjectExtra;
  const char* lpObjectParameters;
  const void* lpWorkingDataHandle;
  void* lpData;
  const char* lpDataSourceName;
  void* lpStateData;
  int LengthOfStateData;
  const char* lpDataName;
  const void* lpInstantaneousCalculationData;
  const char* lpModelDirectory;
  int UpdateDuringStatics;
  void* lpLogData;
  int LengthOfLogData, ResultID, NewTimeStep;
} external_function;
typedef struct {
  int Size;
  double Position[3];
} node_now;
enum { INITIALISE = 0, FINALISE = 1, CALCULATE = 2, STORE_STATE = 3, FREE_STATE = 4 };
enum { IMPLICIT_INTEGRATION = 2 };

/* Of one data item. Each of the three has its own: all go the same way and have the same state. */
typedef struct {
  unsigned long long of; /* the parameters that it belongs to: parameters_now() */
  double length, seabed, heading, origin[2];
  int placed;                          /* whether origin is known, where the node was first */
  berm_macro_element_state done, tried; /* at the end of the last time step; of the last call */
} soil;

/* A number for the fitted parameters (FNV-1a): a state that was stored with others is none of this library. */
static unsigned long long parameters_now(void)
{
  const unsigned char* bytes = (const unsigned char*)&berm_macro_element_fitted;
  unsigned long long number = 14695981039346656037ull;
  size_t k;
  for (k = 0; k < sizeof berm_macro_element_fitted; ++k) number = (number ^ bytes[k]) * 1099511628211ull;
  return number;
}

/* The parameters of the load, from their text. */
static int read_parameters(const char* text, soil* s, double* embedment, double* V)
{
  double* const values[5] = {&s->length, &s->seabed, &s->heading, embedment, V};
  int k;
  for (k = 0; k < 5 && text != NULL; ++k) text = berm_macro_element_read_number(text, values[k]);
  return text != NULL;
}

static double force_on(soil* s, const external_function* info, int direction)
{
  const node_now* node = (const node_now*)info->lpInstantaneousCalculationData;
  const double c = cos(s->heading), sine = sin(s->heading);
  double d[3], F[3], dx, dy;
  if (node == NULL) return NAN;
  if (!s->placed) {
    memcpy(s->origin, node->Position, sizeof s->origin);
    s->placed = 1;
  }
  if (info->NewTimeStep) s->done = s->tried; /* else the step is tried once more */
  dx = node->Position[0] - s->origin[0];
  dy = node->Position[1] - s->origin[1];
  d[0] = c * dx + sine * dy;
  d[1] = c * dy - sine * dx;
  d[2] = s->seabed - (node->Position[2] - berm_macro_element_fitted.diameter / 2);
  if (berm_macro_element_step(&berm_macro_element_fitted, &s->done, d, &s->tried, F, NULL) != 0) return NAN; /* OrcaFlex stops at it */
  return s->length / 1000 * (direction == 0 ? -(c * F[0] - sine * F[1]) : direction == 1 ? -(sine * F[0] + c * F[1]) : F[2]);
}

static void call(external_function* info, int direction)
{
  soil* s = (soil*)info->lpData;
  double embedment, V, d[3] = {0, 0, 0};
  switch (info->Action) {
    case INITIALISE:
      info->lpData = s = (soil*)calloc(1, sizeof *s);
      info->UpdateDuringStatics = 1;
      info->Value = NAN;
      if (s == NULL || !read_parameters(info->lpObjectParameters, s, &embedment, &V)) break;
      s->of = parameters_now();
      s->heading *= atan(1) / 45;
      d[2] = embedment;
      if (berm_macro_element_start(&berm_macro_element_fitted, d, V, &s->done) != 0) break;
      s->tried = s->done;
      if (info->lpStateData != NULL) {
        if (info->LengthOfStateData != (int)sizeof *s || memcmp(info->lpStateData, &s->of, sizeof s->of) != 0) {
          memset(s, 0, sizeof *s); /* forces are no numbers then, and OrcaFlex stops */
          break;
        }
        memcpy(s, info->lpStateData, sizeof *s);
      }
      info->Value = direction == 2 ? s->length / 1000 * V : 0;
      break;
    case CALCULATE:
      info->Value = s == NULL ? NAN : force_on(s, info, direction);
      break;
    case STORE_STATE:
      info->lpStateData = s;
      info->LengthOfStateData = (int)sizeof *s;
      break;
    case FINALISE:
      free(s);
      info->lpData = NULL;
      break;
    default: /* FREE_STATE: what was handed out is still in use */
      break;
  }
}

#define FUNCTION(name, direction)                  \
  EXPORT void CALL name(external_function* info);  \
  EXPORT void CALL name(external_function* info)   \
  {                                                \
    call(info, direction);                         \
  }
FUNCTION(soil_force_x, 0)
FUNCTION(soil_force_y, 1)
FUNCTION(soil_force_z, 2)

/* Texts are not Unicode; a time step may be tried several times. */
EXPORT void CALL RegisterCapabilities(unsigned int* capabilities);
EXPORT void CALL RegisterCapabilities(unsigned int* capabilities)
{
  *capabilities = IMPLICIT_INTEGRATION;
}

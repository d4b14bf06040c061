/* SPDX-License-Identifier: BSD-3-Clause */
/* A line's node on the external functions of examples/macro_element/orcaflex.c, called as OrcaFlex calls them: statics, time steps that are tried several times, a state that is stored. */
#include "check.h"
#include "macro_element.h"

#include <stdlib.h>
#include <string.h>

/* The whole of TExtFnInfo, as OrcFxAPI documents it. */
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
  void *lpStructValue, *ModelHandle;
  const char* lpModelFileName;
  void* DataObjectHandle;
  int CanResumeSimulation;
} TExtFnInfo;
void soil_force_x(TExtFnInfo*);
void soil_force_y(TExtFnInfo*);
void soil_force_z(TExtFnInfo*);
void RegisterCapabilities(unsigned int*);

static void (*const functions[3])(TExtFnInfo*) = {soil_force_x, soil_force_y, soil_force_z};
static TExtFnInfo items[3];

static void act(int action, const double position[3], int new_step, double force[3])
{
  struct {
    int Size;
    double Position[3], more[80];
  } node = {0};
  int k;
  node.Size = sizeof node;
  if (position != NULL) memcpy(node.Position, position, sizeof node.Position);
  for (k = 0; k < 3; ++k) {
    items[k].Size = sizeof items[k];
    items[k].Action = action;
    items[k].NewTimeStep = new_step;
    items[k].lpInstantaneousCalculationData = &node;
    functions[k](&items[k]);
    if (force != NULL) force[k] = items[k].Value;
  }
}

int main(void)
{
  const double L = 3, seabed = -100, heading = atan(1) * 4 / 6, D = berm_macro_element_fitted.diameter, V = 700; /* 30 degrees */
  double position[3] = {12, -7, -100 + 0.25 - 0.04}, begin[3], force[3], again[3], d[3] = {0, 0, 0.04}, F[3], K[3][3];
  unsigned int capabilities = 0;
  berm_macro_element_state state;
  void* stored[3];
  int k, i;
  (void)seabed;
  take_locale();
  position[2] = seabed + D / 2 - 0.04;
  memcpy(begin, position, sizeof begin);
  RegisterCapabilities(&capabilities);
  CHECK(capabilities == 2);
  for (k = 0; k < 3; ++k) items[k].lpObjectParameters = "3 -100.0 30 0.04 7e2";
  act(0, NULL, 0, force);
  CHECK(force[0] == 0 && force[1] == 0 && items[0].UpdateDuringStatics);
  CHECK_NEAR(force[2], L * V / 1000, 1e-12);
  CHECK(berm_macro_element_start(&berm_macro_element_fitted, d, V, &state) == 0);
  act(2, position, 0, force); /* statics: no time step */
  CHECK_NEAR(force[2], L * V / 1000, 1e-9);
  for (k = 1; k <= 200; ++k) {
    const double along = 0.02 * D * sin(0.2 * k), across = 0.4 * D * sin(0.05 * k), sunk = 0.01 * k / 200;
    double wrong[3];
    position[0] = begin[0] + cos(heading) * along - sin(heading) * across;
    position[1] = begin[1] + sin(heading) * along + cos(heading) * across;
    position[2] = begin[2] - sunk;
    for (i = 0; i < 3; ++i) wrong[i] = position[i] + 0.01 * (i - 1);
    act(2, wrong, 1, NULL); /* the step's first try, then others */
    act(2, begin, 0, NULL);
    act(2, position, 0, force);
    d[0] = along, d[1] = across, d[2] = 0.04 + sunk;
    CHECK(berm_macro_element_step(&berm_macro_element_fitted, &state, d, &state, F, K) == 0);
    CHECK_NEAR(force[0], -L / 1000 * (cos(heading) * F[0] - sin(heading) * F[1]), 1e-6);
    CHECK_NEAR(force[1], -L / 1000 * (sin(heading) * F[0] + cos(heading) * F[1]), 1e-6);
    CHECK_NEAR(force[2], L / 1000 * F[2], 1e-6);
  }
  /* Stored, and resumed by another instance. */
  act(3, NULL, 0, NULL);
  for (k = 0; k < 3; ++k) {
    stored[k] = malloc((size_t)items[k].LengthOfStateData);
    memcpy(stored[k], items[k].lpStateData, (size_t)items[k].LengthOfStateData);
  }
  act(4, NULL, 0, NULL);
  position[0] += 0.003;
  act(2, position, 1, force);
  act(1, NULL, 0, NULL);
  /* A state of other parameters, and one that was cut, are none. */
  for (k = 0; k < 3; ++k) {
    items[k].lpStateData = stored[k];
    ((char*)stored[k])[0] ^= 1;
  }
  act(0, NULL, 0, NULL);
  act(2, position, 1, again);
  CHECK(again[0] != again[0] && again[2] != again[2]);
  act(1, NULL, 0, NULL);
  for (k = 0; k < 3; ++k) {
    ((char*)stored[k])[0] ^= 1;
    --items[k].LengthOfStateData;
  }
  act(0, NULL, 0, NULL);
  act(2, position, 1, again);
  CHECK(again[0] != again[0]);
  act(1, NULL, 0, NULL);
  for (k = 0; k < 3; ++k) {
    items[k].lpStateData = stored[k];
    ++items[k].LengthOfStateData;
  }
  act(0, NULL, 0, NULL);
  act(2, position, 1, again);
  CHECK(memcmp(force, again, sizeof force) == 0);
  act(1, NULL, 0, NULL);
  for (k = 0; k < 3; ++k) {
    items[k].lpStateData = NULL;
    items[k].lpObjectParameters = "3 -100";
    free(stored[k]);
  }
  act(0, NULL, 0, force);
  CHECK(force[0] != force[0]); /* no number: OrcaFlex stops */
  act(1, NULL, 0, NULL);
  for (k = 0; k < 3; ++k) items[k].lpObjectParameters = "3 -100 30 0,04 700"; /* whatever the locale */
  act(0, NULL, 0, force);
  CHECK(force[0] != force[0]);
  act(1, NULL, 0, NULL);
  return failures == 0 ? 0 : 1;
}

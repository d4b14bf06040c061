/* SPDX-License-Identifier: BSD-3-Clause */
/* slice CASE AXISYMMETRIC: lays a pipe, copies the slice, and drives the copies, as a program in C does. */
#include "check.h"

#include <berm/slice.h>
#include <string.h>

static const double dt = 2e-4;

/* Sideways for some steps; gives the last force, and the sum of the forces over time. */
static void drive(berm_slice* slice, double speed, int steps, double force[3], double* impulse)
{
  const double velocity[3] = {speed, NAN, NAN};
  int k;
  *impulse = 0;
  for (k = 0; k < steps; ++k) {
    CHECK(berm_slice_step(slice, velocity, dt, force) == BERM_SLICE_OK);
    *impulse += force[0] * dt;
  }
}

int main(int argc, char** argv)
{
  const char* longer[] = {"stage.follow.until.time=\"20 ms\""};
  const double fast[3] = {1, NAN, NAN}, wild[3] = {INFINITY, NAN, NAN};
  berm_slice *slice = NULL, *kept = NULL, *other = NULL;
  berm_slice_state laid, moved;
  double force[3], same[3], impulse, again;
  take_locale();
  if (argc != 3) return 1;
  CHECK(berm_slice_open("no_such.toml", 0, NULL, &slice) == BERM_SLICE_INPUT);
  CHECK(strstr(berm_slice_message(), "no_such.toml") != NULL);
  CHECK(berm_slice_open(argv[1], 1, longer, &slice) == BERM_SLICE_OK);
  if (slice == NULL) return fprintf(stderr, "%s\n", berm_slice_message()), 1;
  CHECK(berm_slice_step(slice, fast, dt, force) == BERM_SLICE_INPUT);
  CHECK(strstr(berm_slice_message(), "berm_slice_lay") != NULL);
  CHECK(berm_slice_lay(slice, "follow") == BERM_SLICE_OK);
  CHECK(berm_slice_now(slice, &laid) == BERM_SLICE_OK);
  CHECK(laid.force[1] > 0 && laid.w > 1e-3);
  CHECK(berm_slice_clone(slice, &kept) == BERM_SLICE_OK && berm_slice_clone(slice, &other) == BERM_SLICE_OK);

  drive(slice, 0.2, 20, force, &impulse);
  CHECK(force[0] < 0 && force[1] > 0); /* the soil holds it back and carries it */
  CHECK(berm_slice_now(slice, &moved) == BERM_SLICE_OK);
  CHECK_NEAR(moved.time, laid.time + 20 * dt, 1e-12);
  CHECK_NEAR(moved.centre[0] - laid.centre[0], 20 * dt * 0.2, 1e-9);
  CHECK_NEAR(moved.u - laid.u, 20 * dt * 0.2, 1e-9);
  CHECK_NEAR(moved.w - laid.w, laid.centre[1] - moved.centre[1], 1e-12);
  CHECK(moved.contact_mass > 0.01 && moved.contact_mass < 1); /* kg/m: the soil beside the pipe has some */

  /* From the state that was kept the same again, to the bit; another way in the other copy. */
  drive(kept, 0.2, 20, same, &again);
  CHECK(memcmp(force, same, sizeof force) == 0 && impulse == again);
  drive(other, -0.2, 20, same, &again);
  CHECK(same[0] > 0);
  berm_slice_close(kept);
  berm_slice_close(other);
  berm_slice_close(NULL);

  CHECK(berm_slice_step(slice, fast, -1, force) == BERM_SLICE_INPUT && strstr(berm_slice_message(), "dt") != NULL);
  CHECK(berm_slice_step(slice, wild, dt, force) == BERM_SLICE_INPUT && strstr(berm_slice_message(), "velocity") != NULL);
  CHECK(berm_slice_step(NULL, fast, dt, force) == BERM_SLICE_INPUT);
  CHECK(berm_slice_step(slice, fast, 1, force) == BERM_SLICE_FAILED && strstr(berm_slice_message(), "stage follow ended") != NULL);
  berm_slice_close(slice);
  CHECK(berm_slice_open(argv[1], 0, NULL, &slice) == BERM_SLICE_OK);
  CHECK(berm_slice_lay(slice, "folow") == BERM_SLICE_INPUT && strstr(berm_slice_message(), "folow") != NULL);
  berm_slice_close(slice);
  CHECK(berm_slice_open(argv[2], 0, NULL, &slice) == BERM_SLICE_INPUT && strstr(berm_slice_message(), "plane strain") != NULL);
  return failures == 0 ? 0 : 1;
}

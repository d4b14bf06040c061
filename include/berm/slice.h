/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef BERM_SLICE_H
#define BERM_SLICE_H

/* A slice of soil with a rigid body in it, in plane strain, as a partner of a program in C, Fortran or any language that calls C: the body is laid by the case, then moved by the
   caller, who gets the force of the soil. It is in libberm, over berm.hpp, which says more of what is possible. SI units, per metre: N/m, of moments N.

   Each function gives a code; where it is not BERM_SLICE_OK, berm_slice_message() has the message. No exception leaves them. A slice is called by one thread at a time; of several slices one works at a time, and the others wait. */

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

/* Codes, as the exit status of the program berm. */
enum { BERM_SLICE_OK = 0, BERM_SLICE_FAILED = 1, BERM_SLICE_INPUT = 2 };

typedef struct berm_slice berm_slice;

/* Reads and builds a case of plane strain with one rigid body, with `count` changes KEY=VALUE as in berm run --set. */
int berm_slice_open(const char* case_file, int count, const char* const* set, berm_slice** slice);

/* Runs the case up to its stage of this name, which must be of kind "drive". */
int berm_slice_lay(berm_slice* slice, const char* stage);

/* Moves the body for dt (s) at a velocity along x, along y (m/s) and about z (rad/s, counter-clockwise); NaN: as the stage or the step before has it. Gives the mean force of the
   soil on the body along x and y and its moment about the body's centre; times dt it is the impulse. A rest of the way that is less than 1e-9 of a time step is left to the next call. An error where the stage ends before: give it a long until.time. */
int berm_slice_step(berm_slice* slice, const double velocity[3], double dt, double force[3]);

typedef struct {
  double time;         /* s */
  double centre[2];    /* m, of the body */
  double u, w;         /* m: how far the body has gone along x since the start, and how deep its lowest point is below the first surface of the soil */
  double force[2];     /* N/m, of the soil on the body in the last time step, of which a berm_slice_step has many */
  double contact_mass; /* kg/m, of the soil at the nodes that the body touched in it: a partner that moves the body by these forces needs it to be stable. 0 before a first step */
} berm_slice_state;

int berm_slice_now(const berm_slice* slice, berm_slice_state* now);

/* A second slice in the state that this one is in: lay a slice once and take it for each place along a line, or keep one to go back to. */
int berm_slice_clone(berm_slice* slice, berm_slice** copy);

/* Null is nothing to close. */
void berm_slice_close(berm_slice* slice);

/* What the last code that was not BERM_SLICE_OK on this thread is about: file, key or place, and what to do. */
const char* berm_slice_message(void);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif

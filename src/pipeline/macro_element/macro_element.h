/* SPDX-License-Identifier: BSD-3-Clause */
/* The macro-element of a pipe on the seabed, for 1 m of pipe: the force between pipe and soil that a displacement makes. Strain-hardening plasticity in
   the plane of V and H, with a mobilisation, a residual and berms of soil on both sides of the pipe; friction along the pipe. C99, without anything but
   the C library. Its functions are pure: what they give depends on their arguments alone, and a state is plain data that the caller keeps.

   Units: N and m (forces in N per m of pipe). Displacements: x along the pipe, u across it, w the embedment of the invert below the original seabed,
   positive downwards. Forces: T and H are those of the pipe on the soil along x and u, V is the reaction of the soil on the pipe, positive upwards.
   T dx + H du + V dw is the work that the pipe does on the soil. Arrays of three have the order x, u, w and T, H, V. */
#ifndef BERM_MACRO_ELEMENT_H
#define BERM_MACRO_ELEMENT_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of the parameters and the state below. What it counts changes wherever one of them gains, loses or redefines a member. */
#define BERM_MACRO_ELEMENT_VERSION 2
#define BERM_MACRO_ELEMENT_MAX_POINTS 32

/* What does not change. v = V/V0 throughout. */
typedef struct berm_macro_element_parameters {
  int version; /* BERM_MACRO_ELEMENT_VERSION */
  double diameter;             /* D, m */
  double vertical_stiffness;   /* k_v, N/m per m: elastic */
  double horizontal_stiffness; /* k_h, N/m per m: elastic */

  /* Vertical resistance V0 (N/m) at H = 0 over the plastic embedment w_p: backbone_factor (w_p/D)^backbone_power from w_p = 0.01 D on, or where
     backbone_points > 0 straight lines between so many points (the first beyond w_p = 0) and on with the last slope. Straight to 0 before. */
  double backbone_factor, backbone_power; /* N/m, 1 */
  int backbone_points;
  double backbone_w[BERM_MACRO_ELEMENT_MAX_POINTS], backbone_V[BERM_MACRO_ELEMENT_MAX_POINTS]; /* m, N/m, ascending */

  /* Yield surface |H| = peak_ratio V0 y(v), y = s^b1 (1 - s)^b2 over its own maximum, s = (v + beta)/(1 + beta). */
  double peak_ratio, surface_beta, surface_b1, surface_b2; /* 1; b1 and b2 less than 1 */
  double uplift_ratio; /* pipe and soil part at V = -uplift_ratio V0; at most beta */

  /* Plastic flow dw_p/|du_p| = flow_slope (v - flow_zero - flow_climb |H|/V0)/sqrt(1 - v). */
  double flow_slope, flow_zero, flow_climb; /* 1 */

  /* Before the peak: H yields at first_yield (0.5 to 1) of the surface, and comes to it over plastic displacements of mobilisation_length; also after
     each reversal. After the peak the surface shrinks to residual_ratio of itself over softening_length of plastic displacement. */
  double first_yield, mobilisation_length; /* 1, m */
  double residual_ratio, softening_length; /* 1, m */

  /* Berm that the pipe heaps up ahead: dR/du = berm_rate w - R/berm_length. One that it left behind resists again from berm_reach before where it was
     left, in full from half of that on. */
  double berm_rate, berm_length, berm_reach; /* N/m^3, m, m */

  /* Along the pipe: R = axial_friction zeta V, V > 0; the wedge of soil around the pipe makes the normal force zeta V, zeta = 2 sin b/(b + sin b cos b),
     cos b = 1 - 2 w/D, b at most pi/2. T grows by R/axial_mobilisation dx up to R. Friction opposes the sliding of the pipe wherever it goes: with plastic
     displacements dx_p along and du_p across, T = R dx_p/sqrt(dx_p^2 + du_p^2). */
  double axial_friction, axial_mobilisation; /* 1, m */
} berm_macro_element_parameters;

/* A number among the parameters (all but the backbone's points and the version): where it lies, and its range, ends included. */
typedef struct berm_macro_element_member {
  const char *name, *unit;
  size_t offset;
  double least, most;
} berm_macro_element_member;
#define BERM_MACRO_ELEMENT_MEMBERS 22
extern const berm_macro_element_member berm_macro_element_members[BERM_MACRO_ELEMENT_MEMBERS];

/* Soil ahead of the pipe on one side; places count from u = 0 towards that side, m. */
typedef struct berm_macro_element_berm {
  double at, R;           /* where the heap that moves with the pipe would lose touch with it, its resistance, N/m */
  double left_at, left_R; /* where the pipe left an earlier one, its resistance; 0: there is none */
} berm_macro_element_berm;

/* What changes: the version and BERM_MACRO_ELEMENT_NUMBERS numbers without a gap, from x to V. */
#define BERM_MACRO_ELEMENT_NUMBERS 18
typedef struct berm_macro_element_state {
  int version;
  double x, u, w;                  /* m, of the pipe */
  double u_p, w_p;                 /* m, plastic parts: H of the surface is k_h (u - u_p), V is k_v (w - w_p) */
  double disturbed;                /* m, plastic displacement across, less what fresh embedment takes away: residual_ratio follows it */
  double mobilised;                /* -1 to 1, how far and in which direction the surface is mobilised */
  berm_macro_element_berm berm[2]; /* towards +u and towards -u */
  double T, H, V;                  /* N/m, now */
} berm_macro_element_state;

enum {
  BERM_MACRO_ELEMENT_OK = 0,
  BERM_MACRO_ELEMENT_NULL = 1,         /* a pointer is null */
  BERM_MACRO_ELEMENT_OTHER_VERSION = 2, /* parameters or state are of another version */
  BERM_MACRO_ELEMENT_PARAMETERS = 3,   /* a parameter is out of its range or no number */
  BERM_MACRO_ELEMENT_INPUT = 4,        /* displacement or force is no number, or a step longer than 100 D */
  BERM_MACRO_ELEMENT_NO_SOLUTION = 5   /* an increment did not converge */
};

/* In words. */
const char* berm_macro_element_error(int code);

/* Whether the parameters make sense: 0 or an error. With BERM_MACRO_ELEMENT_PARAMETERS `wrong` gets the name of the first that does not; it may be null. */
int berm_macro_element_check(const berm_macro_element_parameters* p, const char** wrong);

/* A pipe at this displacement that was pushed straight down to w (negative: it is above the seabed), where V acts on it (0 to V0), on undisturbed soil.
   Gives an error, or 0. */
int berm_macro_element_start(const berm_macro_element_parameters* p, const double displacement[3], double V, berm_macro_element_state* state);

/* The pipe moves straight from where it is in the state `before` to a displacement: in increments of at most D/250 across and down, each by implicit
   return to the surface. Gives the state after it, F = (T, H, V), N/m, and K[i][j] = dF[i]/d(displacement[j]), N/m per m, consistent with the increments.
   K is not symmetric: the flow is not normal to the surface, and T depends on V and on the sliding across, but neither H nor V on x. `after` may be
   `before`; K may be null. With an error nothing is written. */
int berm_macro_element_step(const berm_macro_element_parameters* p, const berm_macro_element_state* before, const double displacement[3],
                            berm_macro_element_state* after, double F[3], double K[3][3]);

/* A number in a text, with a point whatever decimal sign the program's locale has. Gives where the text goes on; NULL where there is no such number. */
const char* berm_macro_element_read_number(const char* text, double* value);

/* Fitted to runs; macro_element.json has how well. */
extern const berm_macro_element_parameters berm_macro_element_fitted;

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: BSD-3-Clause */
/* The macro-element of a pipe on the seabed, for 1 m of pipe: the force between pipe and soil that a displacement makes. Strain-hardening plasticity in
   the plane of V and H, with a mobilisation, a residual and berms of soil on both sides of the pipe. C99, without anything but <math.h>.

   Units: N and m (forces in N per m of pipe). Signs: u is the horizontal displacement along x, w the embedment of the invert below the original seabed,
   positive downwards; H is the force of the pipe on the soil along x, V the reaction of the soil on the pipe, positive upwards. H du + V dw is the work
   that the pipe does on the soil. */
#ifndef BERM_MACRO_ELEMENT_H
#define BERM_MACRO_ELEMENT_H

#ifdef __cplusplus
extern "C" {
#endif

/* Of the parameters and the state below. What it counts changes wherever one of them gains, loses or redefines a member. */
#define BERM_MACRO_ELEMENT_VERSION 1
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
} berm_macro_element_parameters;

/* Soil ahead of the pipe on one side; x counts towards that side, m. */
typedef struct berm_macro_element_berm {
  double x, R;           /* where the heap that moves with the pipe would lose touch with it, its resistance, N/m */
  double left_x, left_R; /* where the pipe left an earlier one, its resistance; 0: there is none */
} berm_macro_element_berm;

/* What changes. */
typedef struct berm_macro_element_state {
  int version;
  double u, w;                     /* m, of the pipe */
  double u_p, w_p;                 /* m, plastic parts: H of the surface is k_h (u - u_p), V is k_v (w - w_p) */
  double disturbed;                /* m, plastic horizontal displacement, less what fresh embedment takes away: residual_ratio follows it */
  double mobilised;                /* -1 to 1, how far and in which direction the surface is mobilised */
  berm_macro_element_berm berm[2]; /* towards +x and towards -x */
  double H, V;                     /* N/m, now */
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

/* Whether the parameters make sense: 0 or an error. */
int berm_macro_element_check(const berm_macro_element_parameters* p);

/* A pipe that was pushed straight down to w (negative: it is above the seabed), where V acts on it (0 to V0), on undisturbed soil. Gives an error, or 0. */
int berm_macro_element_start(const berm_macro_element_parameters* p, double u, double w, double V, berm_macro_element_state* state);

/* Moves the pipe by du = (du, dw), m, in increments of at most D/250, each by implicit return to the surface. Gives F = (H, V), N/m, and
   K[i][j] = dF[i]/d(du[j]), N/m per m, consistent with the increments; K may be null. With an error the state stays as it was. */
int berm_macro_element_step(const berm_macro_element_parameters* p, berm_macro_element_state* state, const double du[2], double F[2], double K[2][2]);

/* Fitted to runs; macro_element.json has how well. */
extern const berm_macro_element_parameters berm_macro_element_fitted;

#ifdef __cplusplus
}
#endif
#endif

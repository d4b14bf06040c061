/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef BERM_LAW_H
#define BERM_LAW_H

/* A soil law of your own for berm: a shared library with the function berm_law below, named in the input by law = "user". docs/how_to/user_law.md
   shows a whole one. */

#ifdef __cplusplus
extern "C" {
#endif

#define BERM_LAW_VERSION 1

/* An increment at one point. Components are xx yy zz xy yz zx (yz and zx are 0 in plane strain); tension is positive; shear strains are engineering
   strains, gamma = 2 e. The stress has already been rotated with the soil. SI units, but for the properties, which are what you say. */
struct berm_law_increment {
  int version;              /* BERM_LAW_VERSION of the program */
  int dimension;            /* 2: plane strain; 3: space */
  const char* material;     /* name of its table in the input */
  int property_count;
  const double* properties; /* `properties` of the input */
  double dt, time;          /* s; time at the beginning. dt is 0 where finite elements release forces at rest: no rate is defined then */
  double strain[6];         /* increment */
  double stress[6];         /* Pa; in: before, out: after */
  int state_count;
  double* state;            /* `state_variables` numbers; in: before, out: after. Nobody rotates them */
  double* tangent;          /* null: not wanted. Otherwise room for d stress[i] / d strain[j], Pa, at [6 * i + j] */
  int tangent_given;        /* set it to 1 where you filled `tangent`; otherwise berm takes differences, with six more calls (four in plane strain) */
};

enum berm_law_answer {
  berm_law_done = 0,
  berm_law_smaller = 1, /* the increment is too large: berm halves it and calls again from the old stress and state */
  berm_law_failed = 2   /* ends the run with an error */
};

/* Must give the same for the same arguments: what it keeps in static variables would be shared by all points. It is called by several threads at a time
   unless thread_safe = "no", or a trial shows that it cannot be. Returns a berm_law_answer. */
int berm_law(struct berm_law_increment* increment);

#ifdef __cplusplus
}
#endif
#endif

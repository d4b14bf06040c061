/* SPDX-License-Identifier: BSD-3-Clause */
/* What the drivers share: a check that counts and names what failed, and the locale of a host. */
#ifndef BERM_CHECK_H
#define BERM_CHECK_H

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

#define CHECK(what)                                                    \
  do {                                                                 \
    if (!(what)) {                                                     \
      ++failures;                                                      \
      fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #what); \
    }                                                                  \
  } while (0)

#define CHECK_NEAR(a, b, tolerance)                                                                     \
  do {                                                                                                  \
    const double a_ = (a), b_ = (b);                                                                    \
    if (!(fabs(a_ - b_) <= (tolerance))) {                                                              \
      ++failures;                                                                                       \
      fprintf(stderr, "%s:%d: %s is %.17g, not %.17g within %g\n", __FILE__, __LINE__, #a, a_, b_, (double)(tolerance)); \
    }                                                                                                   \
  } while (0)

/* Takes the user's locale, as programs with windows do: with COMMA_LOCALE set one of a decimal comma. */
static void take_locale(void)
{
  setlocale(LC_ALL, "");
  CHECK(strcmp(localeconv()->decimal_point, getenv("COMMA_LOCALE") == NULL ? "." : ",") == 0);
}

#endif

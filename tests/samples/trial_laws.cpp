// SPDX-License-Identifier: BSD-3-Clause
// A shared library of laws with which the loading of users' laws is tried.
#include <berm/law.h>

#include <cmath>
#include <csignal>
#include <cstdlib>

extern "C" {

/// Linear elasticity; properties: E, nu. The first state variable counts the calls.
int berm_law(berm_law_increment* i)
{
  const double e = i->properties[0], nu = i->properties[1], shear = e / (2 * (1 + nu)), lame = e * nu / ((1 + nu) * (1 - 2 * nu));
  const double trace = i->strain[0] + i->strain[1] + i->strain[2];
  for (int k = 0; k < 6; ++k) i->stress[k] += k < 3 ? lame * trace + 2 * shear * i->strain[k] : shear * i->strain[k];
  if (i->state_count > 0) i->state[0] += 1;
  return berm_law_done;
}

/// The same, and asks for strain increments below 1e-3.
int patient(berm_law_increment* i)
{
  for (const double strain : i->strain)
    if (std::abs(strain) > 1e-3) {
      i->stress[0] = 1e9;  // must not be kept
      return berm_law_smaller;
    }
  return berm_law(i);
}

int never_content(berm_law_increment*)
{
  return berm_law_smaller;
}

int fails(berm_law_increment*)
{
  return berm_law_failed;
}

/// From the tenth of a second on.
int not_a_number(berm_law_increment* i)
{
  berm_law(i);
  if (i->time > 0.1) i->stress[1] = std::nan("");
  return berm_law_done;
}

/// During a run, but not in trials.
int fails_later(berm_law_increment* i)
{
  berm_law(i);
  if (i->time > 1e-3 && i->dt < 1e-4) i->stress[1] = std::nan("");
  return berm_law_done;
}

/// Keeps a variable from one call to the next.
int remembers(berm_law_increment* i)
{
  static double total = 0;
  total += i->strain[0];
  i->stress[0] += 1e6 * total;
  return berm_law_done;
}

/// Works in static memory, which each call fills anew.
int works_in_static_memory(berm_law_increment* i)
{
  static volatile double strain[6];
  for (int k = 0; k < 6; ++k) strain[k] = i->strain[k];
  for (int round = 0; round < 100; ++round)
    for (int k = 0; k < 6; ++k) i->stress[k] += 1e4 * strain[k];
  return berm_law_done;
}

int uses_foreign_memory(berm_law_increment* i)
{
  *reinterpret_cast<volatile double*>(8) = i->dt;
  return berm_law_done;
}

int crashes_later(berm_law_increment* i)
{
  return i->time > 1e-3 && i->dt < 1e-4 ? uses_foreign_memory(i) : berm_law(i);
}

int aborts(berm_law_increment*)
{
  std::abort();
}

int stops(berm_law_increment*)
{
  std::exit(0);
}

int uses_up_the_stack(berm_law_increment* i)  // NOLINT(misc-no-recursion)
{
  volatile double room[10000];
  room[0] = i->dt;
  i->dt += 1;
  const int deeper = uses_up_the_stack(i);
  i->stress[0] += room[0];
  return deeper;
}

int divides_by_zero(berm_law_increment*)
{
  return std::raise(SIGFPE);
}
}

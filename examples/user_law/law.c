/* SPDX-License-Identifier: BSD-3-Clause */
/* Linear elasticity with von Mises strength, perfectly plastic: |s| = sqrt(3/2 s:s) <= strength, s the deviator of the stress. */
/* properties: Young's modulus, Pa; Poisson's ratio; strength in uniaxial compression, Pa. State variable: accumulated plastic strain. */
#include <berm/law.h>

#include <math.h>

int berm_law(struct berm_law_increment* i)
{
  const double young = i->properties[0], poisson = i->properties[1], strength = i->properties[2];
  const double shear = young / (2 * (1 + poisson)), bulk = young / (3 * (1 - 2 * poisson));
  const double volumetric = i->strain[0] + i->strain[1] + i->strain[2];
  const double mean = (i->stress[0] + i->stress[1] + i->stress[2]) / 3;
  double deviator[6], size = 0;
  for (int k = 0; k < 6; ++k) {
    /* Engineering shear strains: twice the tensor's. */
    deviator[k] = k < 3 ? i->stress[k] - mean + 2 * shear * (i->strain[k] - volumetric / 3) : i->stress[k] + shear * i->strain[k];
    size += (k < 3 ? 1 : 2) * deviator[k] * deviator[k];
  }
  size = sqrt(1.5 * size);
  const double kept = size > strength ? strength / size : 1;
  for (int k = 0; k < 6; ++k) i->stress[k] = kept * deviator[k] + (k < 3 ? mean + bulk * volumetric : 0);
  i->state[0] += (1 - kept) * size / (3 * shear);
  return berm_law_done; /* without a tangent of its own */
}

// SPDX-License-Identifier: MIT
// Feet: whether they have to be put flat at all.

#ifndef DEMO_SF_STAND_FEET_H
#define DEMO_SF_STAND_FEET_H

#include "stand_model.h"

// Centre of mass of the solid as it was given, densities and masses included.
sf_status stand_weigh(cli_job *job, const model *m, double com_mm[3]);

// Judge the solid as it was modelled, and where every stance is safe so leave its feet as they are.
exit_status stand_feet(cli_job *job, model *m);

#endif

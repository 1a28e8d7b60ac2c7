// SPDX-License-Identifier: MIT
// The layers of a model that was made to stand, and the certificate of them.

#ifndef DEMO_SF_STAND_LAYERS_H
#define DEMO_SF_STAND_LAYERS_H

#include "stand_model.h"

// What has no name yet; NULL where it was not asked for.
typedef struct stand_layers {
    sf_directory *folder;
    sf_save *certificate;
} stand_layers;

// Refuse, before any work is done, what cannot be written, or certified.
exit_status stand_layers_check(cli_job *job);

// Write the layers of the carved shape, holes included, and certify them.
exit_status stand_layers_begin(cli_job *job, const model *m, stand_layers *made);

// Give both their names, or forget them.
exit_status stand_layers_commit(cli_job *job, stand_layers *made);
void stand_layers_abort(stand_layers *made);

#endif

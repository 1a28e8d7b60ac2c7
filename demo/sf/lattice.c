// SPDX-License-Identifier: MIT
// The lattice that a mesh is put on.
//
// A part that is a whole number of voxels long gets just that many: what sticks out of the last one
// by less than a millionth of a voxel is rounding, and no centre of a voxel lies in it.

#include "lattice.h"

#include <math.h>

#define ROUNDING_VX 1e-6

static double voxels_along(double length_mm, double pitch_mm)
{
    double count = ceil(length_mm / pitch_mm - ROUNDING_VX);
    return count < 1 ? 1 : count;
}

static void choose_pitch(const cli_options *asked, const double size_mm[3], double pitch_mm[3])
{
    double longest = fmax(size_mm[0], fmax(size_mm[1], size_mm[2]));
    for (int i = 0; i < 3; i++) {
        pitch_mm[i] =
            (asked->given & OPTION_PITCH) ? asked->pitch_mm[i] : longest / asked->resolution;
    }
}

exit_status lattice_check_memory(cli_job *job, const sf_lattice *lattice, double below)
{
    double mib = 8.0 * (double)sf_slice_stride(lattice->nx) * lattice->ny * lattice->nz / 1048576;
    if (mib <= job->options.memory_mib) {
        return EXIT_GOOD;
    }
    return job_fail(
        job, EXIT_RESOURCE,
        "A grid of %u x %u x %u voxels takes %.0f MiB, and --memory allows %.0f; take %sa "
        "coarser --pitch, a lower --resolution, or --memory %.0f.",
        lattice->nx, lattice->ny, lattice->nz, ceil(mib), job->options.memory_mib,
        2 * below > lattice->nz ? "a --bed nearer to the part, " : "", ceil(mib));
}

exit_status lattice_check_given(cli_job *job, const sf_lattice *lattice)
{
    double mib = 8.0 * (double)sf_slice_stride(lattice->nx) * lattice->ny * lattice->nz / 1048576;
    return mib <= job->options.memory_mib
               ? EXIT_GOOD
               : job_fail(job, EXIT_RESOURCE,
                          "A grid of %u x %u x %u voxels takes %.0f MiB, and --memory allows "
                          "%.0f; say --memory %.0f.",
                          lattice->nx, lattice->ny, lattice->nz, ceil(mib), job->options.memory_mib,
                          ceil(mib));
}

// How many layers a bed adds that lies below the part.
static double layers_below(const cli_job *job, double low_mm, double layer_mm)
{
    return (job->options.given & OPTION_BED) && job->options.bed_mm < low_mm
               ? ceil((low_mm - job->options.bed_mm) / layer_mm - ROUNDING_VX)
               : 0;
}

exit_status lattice_fit(cli_job *job, const double low_mm[3], const double high_mm[3],
                        sf_lattice *lattice, uint32_t *lift)
{
    double size_mm[3], pitch_mm[3], counts[3];
    for (int i = 0; i < 3; i++) {
        size_mm[i] = high_mm[i] - low_mm[i];
    }
    choose_pitch(&job->options, size_mm, pitch_mm);
    for (int i = 0; i < 3; i++) {
        counts[i] = voxels_along(size_mm[i], pitch_mm[i]) + (i < 2 ? 2 : 0);
    }
    double below = layers_below(job, low_mm[2], pitch_mm[2]);
    counts[2] += below;
    if (below > 0 && counts[2] > SF_LAYER_MAX && counts[2] - below <= SF_LAYER_MAX) {
        return job_fail(job, EXIT_USAGE,
                        "--bed %g lies %.4g mm below the part, which is %.4g layers; take a bed "
                        "that is nearer.",
                        job->options.bed_mm, low_mm[2] - job->options.bed_mm, below);
    }
    if (!(pitch_mm[0] > 0) || counts[0] > SF_EXTENT_MAX || counts[1] > SF_EXTENT_MAX ||
        counts[2] > SF_LAYER_MAX) {
        return job_fail(job, EXIT_USAGE,
                        "A lattice of %.6g x %.6g x %.6g voxels is too large (at most %u x %u in a "
                        "layer); take a coarser --pitch or a lower --resolution.",
                        counts[0], counts[1], counts[2], SF_EXTENT_MAX, SF_EXTENT_MAX);
    }
    *lift = (uint32_t)below;
    lattice->nx = (uint32_t)counts[0];
    lattice->ny = (uint32_t)counts[1];
    lattice->nz = (uint32_t)counts[2];
    lattice->pitch_x_mm = pitch_mm[0];
    lattice->pitch_y_mm = pitch_mm[1];
    lattice->layer_mm = pitch_mm[2];
    lattice->heights_mm = NULL;
    lattice->origin_mm[0] = low_mm[0] - pitch_mm[0];
    lattice->origin_mm[1] = low_mm[1] - pitch_mm[1];
    lattice->origin_mm[2] = low_mm[2] - below * pitch_mm[2];
    if (sf_lattice_validate(lattice) != SF_OK) {
        return job_fail(job, EXIT_USAGE,
                        "Voxels of %g x %g x %g mm are no size for a part of %g x %g x %g mm; "
                        "check --pitch, --size, --scale and --units.",
                        pitch_mm[0], pitch_mm[1], pitch_mm[2], size_mm[0], size_mm[1], size_mm[2]);
    }
    return EXIT_GOOD;
}

exit_status lattice_choose(cli_job *job, const double low_mm[3], const double high_mm[3],
                           sf_lattice *lattice, uint32_t *lift)
{
    exit_status status = lattice_fit(job, low_mm, high_mm, lattice, lift);
    return status == EXIT_GOOD ? lattice_check_memory(job, lattice, *lift) : status;
}

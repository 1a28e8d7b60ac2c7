// SPDX-License-Identifier: MIT
// Writes one period of a halftone of constant tones as pictures, for tests/unit/grade/spectrum.py,
// which knows nothing of this library, to measure: FOLDER/0000.pgm and so on, a byte a voxel, 0 for
// nothing and material + 1 else.
//
// usage: unit-grade-layers FOLDER slice|isotropic|diffuse PX PY PZ NX NY NZ TONE...

#include <sf/halftone.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void must(sf_status status)
{
    if (status != SF_OK) {
        fprintf(stderr, "%s\n", sf_status_message(status));
        exit(1);
    }
}

static void write_layer(const char *folder, uint32_t k, const uint8_t *ids, uint32_t nx,
                        uint32_t ny)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%04u.pgm", folder, (unsigned)k);
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        must(SF_ERR_IO);
        return;
    }
    fprintf(file, "P5\n%u %u\n255\n", (unsigned)nx, (unsigned)ny);
    size_t written = fwrite(ids, 1, (size_t)nx * ny, file);
    if (fclose(file) != 0 || written != (size_t)nx * ny) {
        must(SF_ERR_IO);
    }
}

int main(int argc, char **argv)
{
    if (argc < 10 || argc - 9 >= (int)SF_MATERIAL_MAX) {
        fputs("usage: unit-grade-layers FOLDER slice|isotropic|diffuse PX PY PZ NX NY NZ TONE...\n",
              stderr);
        return 2;
    }
    sf_mask_options o = sf_mask_options_default();
    uint32_t materials = (uint32_t)(argc - 9) + 1;
    o.kind = strcmp(argv[2], "isotropic") == 0 ? SF_MASK_ISOTROPIC : SF_MASK_SLICE;
    for (int n = 0; n < 3; n++) {
        o.pitch_mm[n] = atof(argv[3 + n]);
    }
    o.nx = (uint32_t)atoi(argv[6]);
    o.ny = (uint32_t)atoi(argv[7]);
    o.nz = (uint32_t)atoi(argv[8]);
    sf_mask *mask = NULL;
    sf_halftone *halftone = NULL;
    sf_diffuser *diffuser = NULL;
    must(sf_mask_create(&o, NULL, NULL, &mask));
    must(sf_halftone_create(mask, materials, NULL, &halftone));
    must(sf_diffuser_create(o.nx, o.ny, materials, o.pitch_mm, NULL, &diffuser));
    size_t area = (size_t)o.nx * o.ny;
    double *values = malloc(sizeof *values * area * (materials - 1));
    uint8_t *ids = malloc(area);
    if (values == NULL || ids == NULL) {
        must(SF_ERR_MEMORY);
        return 1;
    }
    sf_tone_plane planes[SF_MATERIAL_MAX];
    for (uint32_t j = 0; j + 1 < materials; j++) {
        for (size_t i = 0; i < area; i++) {
            values[area * j + i] = atof(argv[9 + j]);
        }
        planes[j].values = values + area * j;
        planes[j].stride = o.nx;
    }
    sf_tones tones = {.struct_size = sizeof tones, .width = o.nx, .height = o.ny};
    sf_materials out = {.ids = ids, .ids_stride = o.nx};
    tones.type = SF_TONE_F64;
    tones.planes = planes;
    for (uint32_t k = 0; k < o.nz; k++) {
        tones.layer = k;
        must(strcmp(argv[2], "diffuse") == 0 ? sf_diffuser_slice(diffuser, &tones, &out)
                                             : sf_halftone_slice(halftone, &tones, &out, NULL));
        write_layer(argv[1], k, ids, o.nx, o.ny);
    }
    sf_diffuser_destroy(diffuser);
    sf_halftone_destroy(halftone);
    sf_mask_destroy(mask);
    free(values);
    free(ids);
    return 0;
}

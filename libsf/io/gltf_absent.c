// SPDX-License-Identifier: MIT
// What a build without tinygltf says to glTF.

#include "io/gltf_model.h"

#include "base/status.h"

#ifndef SF_HAVE_TINYGLTF
sf_status sfi_gltf_parse(const unsigned char *bytes, size_t size, int is_binary,
                         sfi_gltf_files *files, sfi_gltf_model *model, sf_fault *fault)
{
    (void)bytes;
    (void)size;
    (void)is_binary;
    (void)files;
    (void)model;
    return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                         "this is glTF, which this build does not read: it was made without "
                         "tinygltf; save the part as STL, OBJ, PLY or OFF");
}

void sfi_gltf_release(sfi_gltf_model *model)
{
    (void)model;
}
#endif

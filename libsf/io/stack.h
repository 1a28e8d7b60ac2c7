// SPDX-License-Identifier: MIT
// Names and words that the writer and the reader of stacks share.

#ifndef SF_IO_STACK_H
#define SF_IO_STACK_H

#include "io/emitter.h"
#include "io/picture.h"

#define SFI_STACK_DOCUMENT "stack.json"
#define SFI_STACK_FORMAT "libsf-stack"
// A reader of version 1 would pass over bridges, which it does not know, and judge without them.
#define SFI_STACK_VERSION 1
#define SFI_STACK_VERSION_BRIDGED 2
// Pictures have a palette, and a reader of version 2 takes them for grey.
#define SFI_STACK_VERSION_MATERIALS 3
#define SFI_STACK_BRIDGE_MAX 1e12
#define SFI_STACK_PATTERN_PNG "layer_%05u.png"
#define SFI_STACK_PATTERN_PBM "layer_%05u.pbm"

// Room for the name of any layer.
#define SFI_STACK_NAME_SIZE 32

void sfi_stack_layer_name(sfi_picture_kind kind, uint32_t layer, char name[SFI_STACK_NAME_SIZE]);

// Whether a file of this name is part of a stack.
int sfi_stack_owns(const char *name);

// A list of numbers; the line of a document that says where its grid lies, comma and all.
void sfi_stack_emit_numbers(sfi_emitter *out, const double *values, size_t count);
void sfi_stack_emit_lattice(sfi_emitter *out, const sf_lattice *lattice);

// Report `done` layers of `total`.
void sfi_stack_progress(sf_task *task, uint32_t done, uint32_t total);

#endif

// SPDX-License-Identifier: MIT
// A twin of the editor's model in the memory of the graphics card, which does all that the model
// does by its own compute shaders. The view draws it where it lies; the model on the processor is
// what places are picked on and what is saved.

#ifndef SCULPT_APP_CARD_H
#define SCULPT_APP_CARD_H

#include "editor.h"
#include "gpu/gpu_sculpt.h"

typedef struct card card;

// A twin of what the editor's model is, which from now on follows it. NULL where the card cannot;
// and `why` gets a sentence. A context of OpenGL 4.5 must be current, here and whenever the editor
// takes an event.
card *card_create(editor *e, char why[APP_WHY_SIZE]);
void card_destroy(card *c);

// Its buffers, for a view.
gpu_view card_view(const card *c);

// A number for what the card holds, as app_hash() of a model. 0 where there is no memory.
uint64_t card_hash(const card *c);

#endif

// SPDX-License-Identifier: MIT
// Where a part lies, for a sentence that tells a person that some place does not lie there.

#ifndef DEMO_SF_EXTENT_H
#define DEMO_SF_EXTENT_H

#include "part.h"

// "x 0 to 40, y -3 to 8, z 0 to 12.5 mm": axes of the input, mm of the part as it is printed.
#define EXTENT_WORDS_SIZE 128
void extent_words(const cli_job *job, const part *p, char words[EXTENT_WORDS_SIZE]);

#endif

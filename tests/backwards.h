// SPDX-License-Identifier: MIT
// A host's parallel_for that runs pieces from the last to the first: whoever counts on their order
// is found out.

#ifndef SF_TEST_BACKWARDS_H
#define SF_TEST_BACKWARDS_H

#include <sf/base.h>

static inline void backwards(void *user, size_t count, sf_task_body body, void *context)
{
    (void)user;
    while (count > 0) {
        body(context, --count);
    }
}

#endif

// SPDX-License-Identifier: MIT
// Filling a fault with a sentence.

#include "base/status.h"

#include <stdarg.h>
#include <stdio.h>

sf_status sfi_fault_set(sf_fault *fault, sf_status status, uint32_t line, uint64_t offset,
                        const char *format, ...)
{
    if (fault != NULL) {
        va_list arguments;
        va_start(arguments, format);
        fault->status = status;
        fault->line = line;
        fault->offset = offset;
        int length = vsnprintf(fault->message, sizeof fault->message, format, arguments);
        va_end(arguments);
        if (length < 0) {
            fault->message[0] = '\0';
        }
    }
    return status;
}

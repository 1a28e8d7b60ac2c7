// SPDX-License-Identifier: MIT
// Passing a failure up, inside the library.

#ifndef SF_BASE_STATUS_H
#define SF_BASE_STATUS_H

#include <sf/base.h>

// Leave the function with the status of `call` unless it is SF_OK. Only where nothing needs
// undoing.
#define SF_TRY(call)                                                                               \
    do {                                                                                           \
        sf_status sfi_status_ = (call);                                                            \
        if (sfi_status_ != SF_OK) {                                                                \
            return sfi_status_;                                                                    \
        }                                                                                          \
    } while (0)

// Fill a fault, where there is one, and return its status, so that a reader of the code sees the
// sentence at the place of the failure. The format knows %s, %d, %u, %lld, %llu, %zu; never a
// float, because the decimal point would follow the locale.
#if defined(__MINGW32__)
__attribute__((format(gnu_printf, 5, 6)))
#elif defined(__GNUC__)
__attribute__((format(printf, 5, 6)))
#endif
sf_status
sfi_fault_set(sf_fault *fault, sf_status status, uint32_t line, uint64_t offset, const char *format,
              ...);

#endif

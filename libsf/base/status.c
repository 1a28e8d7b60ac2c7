// SPDX-License-Identifier: MIT
// Names and sentences of the status codes. Freestanding.

#include <sf/base.h>

typedef struct status_text {
    const char *name;
    const char *message;
} status_text;

// Indexed by code; tests/unit/base/status.c holds this table and the enum together.
static const status_text texts[SF_STATUS_COUNT] = {
    {"SF_OK", "Done."},
    {"SF_ERR_ARGUMENT", "A pointer is NULL or a value lies outside its documented range."},
    {"SF_ERR_SHAPE", "Two objects that must agree in size or lattice do not."},
    {"SF_ERR_CAPACITY", "The buffer that was given is too small."},
    {"SF_ERR_OVERFLOW", "A size does not fit this machine or the limits of the library."},
    {"SF_ERR_MEMORY", "There is not enough memory."},
    {"SF_ERR_IO", "Reading or writing failed."},
    {"SF_ERR_FORMAT", "The bytes are not what the format allows."},
    {"SF_ERR_UNSUPPORTED", "This is well-formed, but not served by this rule, build or version."},
    {"SF_ERR_CANCELLED", "The task was cancelled."},
    {"SF_ERR_INTERNAL", "A promise of the library was broken; please report it."},
    {"SF_ERR_INFEASIBLE", "What must stay cannot be carried within what may be there."},
};

const char *sf_version(void)
{
    return SF_VERSION_STRING;
}

static int is_code(sf_status status)
{
    return (unsigned)status < (unsigned)SF_STATUS_COUNT;
}

const char *sf_status_name(sf_status status)
{
    return is_code(status) ? texts[status].name : "SF_STATUS_UNKNOWN";
}

const char *sf_status_message(sf_status status)
{
    return is_code(status) ? texts[status].message : "This is not a status code of libsf.";
}

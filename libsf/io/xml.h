// SPDX-License-Identifier: MIT
// XML out of an entry of an archive: elements as they begin and end, and nothing else.
//
// Text between elements is not looked at. Names are "namespace\nlocal", or "local" where they have
// no namespace, which holds for most attributes. A document with a DOCTYPE is refused, so that no
// entity can unfold, and so is a word of more than a million bytes, which takes expat quadratic
// time.

#ifndef SF_IO_XML_H
#define SF_IO_XML_H

#include "io/zip_read.h"

typedef struct sfi_xml_state sfi_xml;

// What to call; a status other than SF_OK ends the reading and is passed on. `attributes` are names
// and values in turn, and last NULL. `prefix` hears of namespaces before the element that declares
// them, and may be NULL.
typedef struct sfi_xml_hearer {
    sf_status (*begin)(void *user, const char *name, const char **attributes);
    sf_status (*end)(void *user);
    sf_status (*prefix)(void *user, const char *prefix, const char *space);
    void *user;
} sfi_xml_hearer;

// Read an entry whole. Faults have the line. Elements are at most 64 deep.
sf_status sfi_xml_read(sfi_zip *zip, const char *name, const sfi_xml_hearer *hearer,
                       const sfi_xml **place, sf_fault *fault);

// The value of an attribute, or NULL.
const char *sfi_xml_value(const char **attributes, const char *name);

// The line that is being read; `place` is what sfi_xml_read() leaves there while it runs.
uint32_t sfi_xml_line(const sfi_xml *place);

#endif

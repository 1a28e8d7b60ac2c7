// SPDX-License-Identifier: MIT
// XML out of an entry of an archive, by expat, which takes its memory from the C library.

#include "io/xml.h"

#include "base/status.h"

#ifdef SF_HAVE_THREEMF

#include <expat.h>
#include <string.h>

enum { BLOCK = 32768, WORD_MAX_SIZE = 1048576, DEPTH = 64 };
// A model is text that repeats itself, at most so much.
static const uint64_t RATIO = 250;

struct sfi_xml_state {
    XML_Parser parser;
    const sfi_xml_hearer *hearer;
    const char *name;
    sf_fault *fault;
    sf_status status;
    int depth;
    uint64_t fed; // bytes
};

uint32_t sfi_xml_line(const sfi_xml *place)
{
    XML_Size line = XML_GetCurrentLineNumber(place->parser);
    return line < UINT32_MAX ? (uint32_t)line : UINT32_MAX;
}

const char *sfi_xml_value(const char **attributes, const char *name)
{
    for (; attributes[0] != NULL; attributes += 2) {
        if (strcmp(attributes[0], name) == 0) {
            return attributes[1];
        }
    }
    return NULL;
}

static void stop(sfi_xml *x, sf_status status)
{
    if (status != SF_OK && x->status == SF_OK) {
        x->status = status;
        XML_StopParser(x->parser, XML_FALSE);
    }
}

static void on_begin(void *user, const XML_Char *name, const XML_Char **attributes)
{
    sfi_xml *x = user;
    if (x->status != SF_OK) {
        return; // expat goes on to the end of the element that it was stopped in
    }
    if (++x->depth > DEPTH) {
        stop(x, sfi_fault_set(x->fault, SF_ERR_FORMAT, sfi_xml_line(x), 0,
                              "%.100s: elements are more than %d deep", x->name, DEPTH));
        return;
    }
    stop(x, x->hearer->begin(x->hearer->user, name, attributes));
}

static void on_end(void *user, const XML_Char *name)
{
    sfi_xml *x = user;
    (void)name;
    if (x->status == SF_OK) {
        x->depth--;
        stop(x, x->hearer->end(x->hearer->user));
    }
}

static void on_prefix(void *user, const XML_Char *prefix, const XML_Char *space)
{
    sfi_xml *x = user;
    if (x->status == SF_OK && prefix != NULL && space != NULL) {
        stop(x, x->hearer->prefix(x->hearer->user, prefix, space));
    }
}

static void on_doctype(void *user, const XML_Char *name, const XML_Char *system,
                       const XML_Char *public, int has_internal)
{
    sfi_xml *x = user;
    (void)name, (void)system, (void)public, (void)has_internal;
    stop(x, sfi_fault_set(x->fault, SF_ERR_FORMAT, sfi_xml_line(x), 0,
                          "%.100s has a DOCTYPE, which 3MF forbids and attackers use; export the "
                          "file again",
                          x->name));
}

static sf_status tell(const sfi_xml *x)
{
    enum XML_Error error = XML_GetErrorCode(x->parser);
    if (x->status != SF_OK) {
        return x->status;
    }
    if (error == XML_ERROR_NO_MEMORY) {
        return SF_ERR_MEMORY;
    }
    return sfi_fault_set(x->fault, SF_ERR_FORMAT, sfi_xml_line(x), 0,
                         "%.100s is no XML that can be read: %s; export the file again", x->name,
                         XML_ErrorString(error));
}

// How far the parser lags behind what it was fed: the word that it waits for the end of.
static sf_status check_word(const sfi_xml *x)
{
    XML_Index at = XML_GetCurrentByteIndex(x->parser);
    uint64_t done = at > 0 ? (uint64_t)at : 0;
    return x->fed > done && x->fed - done > WORD_MAX_SIZE
               ? sfi_fault_set(x->fault, SF_ERR_FORMAT, sfi_xml_line(x), 0,
                               "%.100s has an element of more than a million bytes", x->name)
               : SF_OK;
}

static sf_status feed(sfi_xml *x, sfi_zip_entry *entry)
{
    for (size_t got = 1; got > 0;) {
        void *block = XML_GetBuffer(x->parser, BLOCK);
        if (block == NULL) {
            return SF_ERR_MEMORY;
        }
        SF_TRY(sfi_zip_next(entry, block, BLOCK, &got, x->fault));
        x->fed += got;
        if (XML_ParseBuffer(x->parser, (int)got, got == 0) != XML_STATUS_OK) {
            return tell(x);
        }
        SF_TRY(check_word(x));
    }
    return SF_OK;
}

sf_status sfi_xml_read(sfi_zip *zip, const char *name, const sfi_xml_hearer *hearer,
                       const sfi_xml **place, sf_fault *fault)
{
    sfi_zip_entry *entry = NULL;
    sfi_xml x = {NULL, hearer, name, fault, SF_OK, 0, 0};
    SF_TRY(sfi_zip_begin(zip, name, RATIO, &entry, fault));
    x.parser = XML_ParserCreateNS(NULL, '\n');
    sf_status status = SF_ERR_MEMORY;
    if (x.parser != NULL) {
        XML_SetUserData(x.parser, &x);
        XML_SetElementHandler(x.parser, on_begin, on_end);
        XML_SetStartDoctypeDeclHandler(x.parser, on_doctype);
        if (hearer->prefix != NULL) {
            XML_SetStartNamespaceDeclHandler(x.parser, on_prefix);
        }
        *place = &x;
        status = feed(&x, entry);
        *place = NULL;
        XML_ParserFree(x.parser);
    }
    sfi_zip_end(entry);
    return status;
}

#endif

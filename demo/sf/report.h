// SPDX-License-Identifier: MIT
// What a verb found out: fields for machines, sentences for people, printed by one code path.

#ifndef DEMO_SF_REPORT_H
#define DEMO_SF_REPORT_H

#include <sf/base.h>

typedef struct report report;

report *report_create(void);
void report_destroy(report *r);

// Fields, in the order in which they are added. A key is NULL inside a list. A number that is not
// finite becomes null.
void report_number(report *r, const char *key, double value);
void report_count(report *r, const char *key, uint64_t value);
void report_flag(report *r, const char *key, int value);
void report_text(report *r, const char *key, const char *value);
void report_null(report *r, const char *key);
void report_numbers(report *r, const char *key, const double *values, size_t count);

// An object or a list: everything up to the matching report_end() lies in it.
void report_begin(report *r, const char *key);
void report_begin_list(report *r, const char *key);
void report_end(report *r);

// A sentence for people: one line of the text form, one string of "summary".
void report_say(report *r, const char *format, ...)
#if defined(__GNUC__) && !defined(__MINGW32__) // whose printf is another
    __attribute__((format(printf, 2, 3)))
#endif
    ;

// A warning: standard error in the text form, one string of "warnings".
void report_warn(report *r, const char *sentence);

// Print the report to a sink. Returns what the sink returns, or SF_ERR_MEMORY where the report
// could not be held.
sf_status report_print_json(const report *r, sf_sink sink);
sf_status report_print_text(const report *r, sf_sink sink);
sf_status report_print_warnings(const report *r, sf_sink sink);

#endif

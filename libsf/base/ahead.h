// SPDX-License-Identifier: MIT
// Memory that is asked for before it is needed.
//
// Where addresses are known some dozens of steps before what lies there is, asking for all of it
// first lets the machine fetch many lines of its cache at once, instead of waiting for each. One of
// the two rooms where compiler extensions are allowed; others do without.
//
// Ask in a function that also does something: gcc takes one that only asks for one without effect,
// and leaves out its calls.

#ifndef SF_BASE_AHEAD_H
#define SF_BASE_AHEAD_H

// The line that holds *p will soon be read and written.
static inline void sfi_ask_for(const void *p)
{
#if defined(__GNUC__)
    __builtin_prefetch(p, 1);
#else
    (void)p;
#endif
}

#endif

// SPDX-License-Identifier: MIT
// Fuzz target: any bytes, read as a session.
//
// Whatever comes in, a session comes out or a refusal with a sentence; and a session that came out,
// written and read again, is written as the same bytes. Small ones are played as well.

#include "target.h"

#include <sf/session.h>

static sf_session *read_bytes(const void *data, size_t size)
{
    sf_memory_cursor cursor = {data, size, 0};
    sf_session *session = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_session_read(sf_memory_source(&cursor), 0, NULL, &session, &fault);
    must((status == SF_OK) == (session != NULL), "a session exactly on success");
    must(status == SF_OK || (fault.status == status && fault.message[0] != '\0'), "a sentence");
    return session;
}

static buffer write_bytes(const sf_session *session)
{
    buffer t = {NULL, 0, 0};
    sf_sink sink = {put, &t};
    must(sf_session_write(session, sink) == SF_OK, "what was read can be written");
    return t;
}

static void play(const sf_session *session)
{
    sf_lattice l = sf_session_options_of(session).lattice;
    sf_sculpt *model = NULL;
    if ((uint64_t)l.nx * l.ny * l.nz <= 40000 && sf_session_count(session).dabs < 50) {
        (void)!sf_session_replay(session, NULL, NULL, &model);
        sf_sculpt_destroy(model);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    sf_session *session = read_bytes(data, size);
    if (session != NULL) {
        buffer first = write_bytes(session);
        sf_session *again = read_bytes(first.bytes, first.size);
        must(again != NULL, "what was written can be read");
        buffer second = write_bytes(again);
        must(first.size == second.size && memcmp(first.bytes, second.bytes, first.size) == 0,
             "and is written as it was");
        play(session);
        free(first.bytes);
        free(second.bytes);
        sf_session_destroy(again);
        sf_session_destroy(session);
    }
    return 0;
}

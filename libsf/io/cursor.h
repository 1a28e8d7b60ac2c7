// SPDX-License-Identifier: MIT
// A buffered cursor over a byte source: what every reader reads through.
//
// It counts lines and bytes for the fault's sake, never reads past the limit, never seeks, and
// keeps the first failure: after one, everything reads as the end, and sfi_cursor_failed() says
// why. Text is read in tokens of bounded length, so no token of a hostile file can be too long for
// a buffer.

#ifndef SF_IO_CURSOR_H
#define SF_IO_CURSOR_H

#include <sf/io.h>

#define SFI_CURSOR_BYTES 65536
// Bytes that can be looked at ahead.
#define SFI_CURSOR_PEEK 4096
// Longest token kept, its final zero included. The rest of a longer one is read and dropped, and
// what is kept ends in '?', so that it is neither a number nor a word that anybody knows.
#define SFI_TOKEN_SIZE 512

typedef struct sfi_cursor {
    sf_allocator allocator;
    sf_source source;
    unsigned char *buffer; // SFI_CURSOR_BYTES
    size_t position, end;  // unread bytes are buffer[position..end)
    uint64_t offset;       // of buffer[0] in the file
    uint64_t left;         // bytes that may still be asked of the source
    uint32_t line;         // from 1
    sf_status failure;     // SF_OK, or why the source ended early
    int at_end;            // the source has said so
} sfi_cursor;

sf_status sfi_cursor_begin(sfi_cursor *cursor, sf_source source, uint64_t bytes_max,
                           const sf_allocator *allocator);
void sfi_cursor_end(sfi_cursor *cursor);

// Up to `need` bytes ahead (at most SFI_CURSOR_PEEK) without taking them; fewer at the end.
const unsigned char *sfi_cursor_peek(sfi_cursor *cursor, size_t need, size_t *have);

// Whether no control characters stand ahead but blanks and line ends.
int sfi_cursor_at_text(sfi_cursor *cursor);

// The next byte of text, or -1 at the end; taken, or only looked at. A return without a line feed
// behind it reads as a line feed, so that a line ends in any of the three ways.
int sfi_cursor_next(sfi_cursor *cursor);
int sfi_cursor_look(sfi_cursor *cursor);

// Exactly `size` bytes; returns how many there were.
size_t sfi_cursor_read(sfi_cursor *cursor, void *data, size_t size);

// Skip blanks (and line ends, when `lines`), then read a token into text; returns its length, 0
// when there is none before the end (of the line, when not `lines`).
size_t sfi_cursor_token(sfi_cursor *cursor, char text[SFI_TOKEN_SIZE], int lines);

// Skip the rest of the line, its end included.
void sfi_cursor_skip_line(sfi_cursor *cursor);

// Offset of the next byte in the file.
uint64_t sfi_cursor_offset(const sfi_cursor *cursor);

// Skip the mark that some editors put in front of text (U+FEFF in UTF-8).
void sfi_cursor_skip_mark(sfi_cursor *cursor);

// A fault about the place where the cursor stands; a source that failed is told of instead.
sf_status sfi_cursor_fault(const sfi_cursor *cursor, sf_fault *fault, const char *sentence);

// The same about the file as a whole, such as one of another format: it has no line or byte.
sf_status sfi_cursor_fault_whole(const sfi_cursor *cursor, sf_fault *fault, const char *sentence);

// The first for a token that should have been something else.
sf_status sfi_cursor_fault_token(const sfi_cursor *cursor, sf_fault *fault, const char *expected,
                                 const char *token);

#endif

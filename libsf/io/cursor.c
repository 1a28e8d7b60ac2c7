// SPDX-License-Identifier: MIT
// Reading bytes, tokens and lines from a source through one buffer.

#include "io/cursor.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

sf_status sfi_cursor_begin(sfi_cursor *cursor, sf_source source, uint64_t bytes_max,
                           const sf_allocator *allocator)
{
    memset(cursor, 0, sizeof *cursor);
    cursor->allocator = sfi_allocator_or_default(allocator);
    cursor->source = source;
    cursor->left = bytes_max;
    cursor->line = 1;
    if (source.read == NULL) {
        return SF_ERR_ARGUMENT;
    }
    cursor->buffer = sfi_alloc_array(&cursor->allocator, SFI_CURSOR_BYTES, 1);
    return cursor->buffer != NULL ? SF_OK : SF_ERR_MEMORY;
}

void sfi_cursor_end(sfi_cursor *cursor)
{
    sfi_free_array(&cursor->allocator, cursor->buffer, SFI_CURSOR_BYTES, 1);
    cursor->buffer = NULL;
}

// Move what is unread to the front and ask the source for more. Returns 0 when nothing came.
static int refill(sfi_cursor *cursor)
{
    if (cursor->at_end || cursor->failure != SF_OK) {
        return 0;
    }
    size_t unread = cursor->end - cursor->position;
    memmove(cursor->buffer, cursor->buffer + cursor->position, unread);
    cursor->offset += cursor->position;
    cursor->position = 0;
    cursor->end = unread;
    size_t room = SFI_CURSOR_BYTES - unread, got = 0;
    if (cursor->left == 0) {
        unsigned char beyond;
        cursor->failure = cursor->source.read(cursor->source.user, &beyond, 1, &got);
        if (cursor->failure == SF_OK && got > 0) {
            cursor->failure = SF_ERR_OVERFLOW;
        }
        cursor->at_end = 1;
        return 0;
    }
    room = room < cursor->left ? room : (size_t)cursor->left;
    sf_status status =
        cursor->source.read(cursor->source.user, cursor->buffer + unread, room, &got);
    if (status != SF_OK) {
        cursor->failure = status;
        return 0;
    }
    if (got > room) { // a source that breaks its promise has written past the buffer's end
        cursor->failure = SF_ERR_IO;
        return 0;
    }
    if (got == 0) {
        cursor->at_end = 1;
        return 0;
    }
    cursor->end += got;
    cursor->left -= got;
    return 1;
}

const unsigned char *sfi_cursor_peek(sfi_cursor *cursor, size_t need, size_t *have)
{
    while (cursor->end - cursor->position < need && refill(cursor)) {
    }
    size_t unread = cursor->end - cursor->position;
    *have = unread < need ? unread : need;
    return cursor->buffer + cursor->position;
}

int sfi_cursor_at_text(sfi_cursor *cursor)
{
    size_t have;
    const unsigned char *bytes = sfi_cursor_peek(cursor, SFI_CURSOR_PEEK, &have);
    for (size_t i = 0; i < have; i++) {
        if (bytes[i] < ' ' && (bytes[i] < '\t' || bytes[i] > '\r')) {
            return 0;
        }
    }
    return 1;
}

// Whether the return that stands ahead ends its line alone, as it did on old machines.
static int is_line_end(sfi_cursor *cursor)
{
    size_t have;
    const unsigned char *bytes = sfi_cursor_peek(cursor, 2, &have);
    return have < 2 || bytes[1] != '\n';
}

int sfi_cursor_look(sfi_cursor *cursor)
{
    if (cursor->position == cursor->end && !refill(cursor)) {
        return -1;
    }
    int byte = cursor->buffer[cursor->position];
    return byte == '\r' && is_line_end(cursor) ? '\n' : byte;
}

int sfi_cursor_next(sfi_cursor *cursor)
{
    int byte = sfi_cursor_look(cursor);
    if (byte >= 0) {
        cursor->position++;
        cursor->line += byte == '\n' && cursor->line < UINT32_MAX;
    }
    return byte;
}

size_t sfi_cursor_read(sfi_cursor *cursor, void *data, size_t size)
{
    size_t done = 0;
    while (done < size) {
        size_t unread = cursor->end - cursor->position;
        if (unread == 0) {
            if (!refill(cursor)) {
                break;
            }
            continue;
        }
        size_t taken = size - done < unread ? size - done : unread;
        memcpy((unsigned char *)data + done, cursor->buffer + cursor->position, taken);
        cursor->position += taken;
        done += taken;
    }
    return done;
}

static int is_blank(int byte)
{
    return byte == ' ' || byte == '\t' || byte == '\r' || byte == '\v' || byte == '\f';
}

size_t sfi_cursor_token(sfi_cursor *cursor, char text[SFI_TOKEN_SIZE], int lines)
{
    int byte = sfi_cursor_look(cursor);
    while (is_blank(byte) || (lines && byte == '\n')) {
        sfi_cursor_next(cursor);
        byte = sfi_cursor_look(cursor);
    }
    size_t length = 0;
    while (byte >= 0 && byte != '\n' && !is_blank(byte)) {
        if (length + 1 < SFI_TOKEN_SIZE) {
            text[length++] = byte == 0 ? '?' : (char)byte;
        } else {
            text[SFI_TOKEN_SIZE - 2] = '?'; // a number that is not whole must not pass for one
        }
        sfi_cursor_next(cursor);
        byte = sfi_cursor_look(cursor);
    }
    text[length] = '\0';
    return length;
}

void sfi_cursor_skip_line(sfi_cursor *cursor)
{
    int byte;
    do {
        byte = sfi_cursor_next(cursor);
    } while (byte >= 0 && byte != '\n');
}

void sfi_cursor_skip_mark(sfi_cursor *cursor)
{
    static const unsigned char mark[3] = {0xef, 0xbb, 0xbf};
    unsigned char dropped[3];
    size_t have;
    const unsigned char *bytes = sfi_cursor_peek(cursor, sizeof mark, &have);
    if (have == sizeof mark && memcmp(bytes, mark, sizeof mark) == 0 &&
        sfi_cursor_at_text(cursor)) {
        sfi_cursor_read(cursor, dropped, sizeof dropped);
    }
}

uint64_t sfi_cursor_offset(const sfi_cursor *cursor)
{
    return cursor->offset + cursor->position;
}

sf_status sfi_cursor_fault(const sfi_cursor *cursor, sf_fault *fault, const char *sentence)
{
    uint64_t offset = sfi_cursor_offset(cursor);
    if (cursor->failure == SF_ERR_OVERFLOW) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, cursor->line, offset,
                             "the file is longer than the limit that was set; raise bytes_max");
    }
    if (cursor->failure != SF_OK) {
        return sfi_fault_set(fault, cursor->failure, cursor->line, offset,
                             "reading failed at byte %llu: %s", (unsigned long long)offset,
                             sf_status_message(cursor->failure));
    }
    return sfi_fault_set(fault, SF_ERR_FORMAT, cursor->line, offset, "%s", sentence);
}

sf_status sfi_cursor_fault_whole(const sfi_cursor *cursor, sf_fault *fault, const char *sentence)
{
    return cursor->failure != SF_OK ? sfi_cursor_fault(cursor, fault, sentence)
                                    : sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0, "%s", sentence);
}

sf_status sfi_cursor_fault_token(const sfi_cursor *cursor, sf_fault *fault, const char *expected,
                                 const char *token)
{
    if (cursor->failure != SF_OK || token[0] == '\0') {
        return sfi_cursor_fault(
            cursor, fault, "the file or line ends where a value should stand; it is cut short");
    }
    // What a file holds may be anything; show it only as far as it is plain text.
    char shown[25];
    size_t n = 0;
    for (; n < sizeof shown - 1 && token[n] != '\0'; n++) {
        shown[n] = token[n] >= ' ' && token[n] <= '~' ? token[n] : '?';
    }
    shown[n] = '\0';
    return sfi_fault_set(fault, SF_ERR_FORMAT, cursor->line, sfi_cursor_offset(cursor),
                         "expected %s, found \"%s\"; correct that line or export the file again",
                         expected, shown);
}

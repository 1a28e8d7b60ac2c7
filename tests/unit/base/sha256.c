// SPDX-License-Identifier: MIT
// Why: a certificate is worth what its fingerprints are. SHA-256 is held against the examples that
// its standard publishes (FIPS 180-2 appendix B; the empty message and the bytes 0xbd from the
// examples of the Cryptographic Standards program), and cut into pieces of any size it must give
// what it gives in one. Guards issue 3, certificate.

#include "base/sha256.h"
#include "test.h"

// Digest of a text, in pieces of `piece` bytes.
static const char *digest_of(const char *data, size_t size, size_t piece)
{
    static char text[2 * SFI_SHA256_SIZE + 1];
    uint8_t digest[SFI_SHA256_SIZE];
    sfi_sha256 hash;
    sfi_sha256_begin(&hash);
    for (size_t at = 0; at < size; at += piece) {
        sfi_sha256_add(&hash, data + at, size - at < piece ? size - at : piece);
    }
    sfi_sha256_end(&hash, digest);
    for (int i = 0; i < SFI_SHA256_SIZE; i++) {
        snprintf(text + 2 * i, 3, "%02x", digest[i]);
    }
    return text;
}

static void published_examples(void)
{
    static const char abc[] = "abc",
                      two[] = "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq";
    CHECK_STR(digest_of(abc, 3, 64),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK_STR(digest_of(two, 56, 64),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    CHECK_STR(digest_of("", 0, 1),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    CHECK_STR(digest_of("\xbd", 1, 1),
              "68325720aabd7c82f30f554b313d0570c95accbb7dc4b5aae11204c08ffe732b");
}

static void a_million_letters(void)
{
    char *letters = malloc(1000000);
    memset(letters, 'a', 1000000);
    CHECK_STR(digest_of(letters, 1000000, 1000000),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    free(letters);
}

// Every length around the places where padding changes.
static void pieces_do_not_matter(void)
{
    char data[300], whole[2 * SFI_SHA256_SIZE + 1];
    for (size_t i = 0; i < sizeof data; i++) {
        data[i] = (char)test_random_below(256);
    }
    for (size_t size = 0; size <= sizeof data; size++) {
        strcpy(whole, digest_of(data, size, sizeof data));
        for (size_t piece = 1; piece < 80; piece += 1 + piece / 4) {
            CHECK_STR(digest_of(data, size, piece), whole);
        }
    }
}

int main(void)
{
    TEST(published_examples);
    TEST(a_million_letters);
    TEST(pieces_do_not_matter);
    return test_finish();
}

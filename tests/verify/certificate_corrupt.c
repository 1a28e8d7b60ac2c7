// SPDX-License-Identifier: MIT
// Why: a certificate that would pass for another shape, or after somebody changed a number in it,
// would certify nothing. Ten thousand changes of single fields, ten thousand more whose author also
// made the digest anew, and ten thousand one-voxel edits of certified stacks are shown to
// sf-verify, under every rule. It refuses all of the first and the third. Of the second it refuses
// all but those of what nothing in the stack can contradict: the fingerprint of an input that is
// not at hand, which of two operations made the change, and the order in which witnesses are
// listed. And it does not only trust fingerprints: it judges edited stacks as brute force does.
// Guards issue 3, certificate.

#include "verified.h"

#include "naive.h"

#define CASES 6
#define CHANGES 10000

// What is certified, once for all of the campaign.
typedef struct certified {
    sf_grid *grid, *exempt;
    made_rule made;
    double thick[16];
    text t;
} certified;

static certified cases[CASES];

static void fill(sf_grid *grid, int beams)
{
    static stack s;
    sf_lattice l = sf_grid_lattice(grid);
    stack_random_boxes(&s, (int)l.nx, (int)l.ny, (int)l.nz, 6);
    for (int i = 0; i < beams; i++) {
        int z = (int)test_random_below(l.nz), y = (int)test_random_below(l.ny);
        for (int x = 0; x < s.nx; x++) {
            *stack_at(&s, x, y, z) = 1;
        }
    }
    for (int i = 0; i < stack_count(&s); i++) {
        s.solid[i] |= test_random_below(30) == 0;
    }
    stack_write(&s, grid);
}

static sf_grid *mask_on(const sf_lattice *lattice)
{
    static stack s;
    sf_grid *mask = NULL;
    CHECK_EQ(sf_grid_create(lattice, NULL, &mask), SF_OK);
    stack_random(&s, (int)lattice->nx, (int)lattice->ny, (int)lattice->nz, 0.04);
    stack_write(&s, mask);
    return mask;
}

// Rules in turn; the odd ones have bridges and exempt voxels, and some layers of many heights.
static void certify(int i)
{
    static const sf_rule_kind kinds[CASES] = {SF_RULE_BOX3,  SF_RULE_OCTAGON, SF_RULE_DISK,
                                              SF_RULE_SLACK, SF_RULE_SLACK,   SF_RULE_OCTAGON};
    certified *c = &cases[i];
    sf_lattice lattice = stack_lattice(13, 11, 9);
    sf_grid *before = NULL;
    for (int k = 0; k < 9; k++) {
        c->thick[k] = 0.08 + 0.05 * test_random_unit();
    }
    lattice.heights_mm = i > 3 ? c->thick : NULL;
    CHECK_EQ(make_rule(&c->made, &lattice, kinds[i], 50.0, i % 2 ? 0.45 : 0.0, i == 1 ? 0.0 : 0.2,
                       i == 2 || i == 5 ? 1 : SF_BED_AUTO),
             SF_OK);
    c->exempt = i % 2 ? mask_on(&lattice) : NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &before), SF_OK);
    fill(before, i % 2 ? 5 : 0);
    CHECK_EQ(sf_grid_clone(before, NULL, &c->grid), SF_OK);
    sf_terms terms = terms_of(&c->made, c->exempt);
    CHECK_EQ(sf_grid_trim_on(c->grid, &terms, NULL, NULL, NULL, NULL), SF_OK);
    sf_claim claim = claim_of(&c->made, &terms, SF_OPERATION_TRIM, before);
    sf_certificate *made = NULL;
    CHECK_EQ(sf_certificate_make(c->grid, &claim, NULL, NULL, &made, NULL), SF_OK);
    c->t = certificate_text(made);
    sf_certificate_destroy(made);
    sf_grid_destroy(before);
    show_grid(c->grid, &c->made.info);
    CHECK(accepts(&c->t));
}

static text copy_of(const text *t)
{
    text copy = {NULL, 0, 0};
    CHECK_EQ(text_add(&copy, t->bytes, t->size), SF_OK);
    return copy;
}

// ---------------------------------------------------------------------------------------------
// Changes of the text
// ---------------------------------------------------------------------------------------------

// Change one token, where it stands, or one byte; returns 0 where nothing changed.
static int scribble(text *t)
{
    static const char signs[] = "0123456789abcdef.,-[]{}\" \n";
    size_t at = test_random_below((uint32_t)t->size);
    char old = t->bytes[at], is = signs[test_random_below(sizeof signs - 1)];
    switch (test_random_below(3)) {
    case 0: // a digit for a digit, wherever the next one stands
        while (at + 1 < t->size && (t->bytes[at] < '0' || t->bytes[at] > '9')) {
            at++;
        }
        old = t->bytes[at];
        is = (char)('0' + test_random_below(10));
        break;
    case 1: // a byte less
        memmove(t->bytes + at, t->bytes + at + 1, t->size - at);
        t->size--;
        return 1;
    default:
        break;
    }
    t->bytes[at] = is;
    return is != old;
}

static void ten_thousand_changed_texts_are_refused(void)
{
    int tried = 0;
    for (int i = 0; i < CASES; i++) {
        show_grid(cases[i].grid, &cases[i].made.info);
        for (int n = 0; n < CHANGES / CASES + 1;) {
            text t = copy_of(&cases[i].t);
            if (scribble(&t)) {
                n++;
                tried++;
                CHECK(!accepts(&t));
            }
            free(t.bytes);
        }
    }
    CHECK(tried >= CHANGES);
}

// ---------------------------------------------------------------------------------------------
// Changes of single fields, with the digest made anew
// ---------------------------------------------------------------------------------------------

static text text_with_digest(json_t *document)
{
    text t = {NULL, 0, 0};
    char tail[128];
    json_object_del(document, "digest");
    char *body = json_dumps(document, JSON_INDENT(2) | JSON_REAL_PRECISION(17));
    size_t size = strlen(body); // which ends with a line for the last brace
    CHECK_EQ(text_add(&t, body, size > 2 ? size - 2 : 0), SF_OK);
    CHECK_EQ(text_add(&t, ",\n", 2), SF_OK);
    snprintf(tail, sizeof tail, "  \"digest\": \"%s\"\n}\n",
             sha256((const unsigned char *)t.bytes, t.size));
    CHECK_EQ(text_add(&t, tail, strlen(tail)), SF_OK);
    free(body);
    return t;
}

static json_t *changed_integer(json_int_t old)
{
    switch (test_random_below(6)) {
    case 0:
        return json_integer(old + 1);
    case 1:
        return json_integer(old - 1);
    case 2:
        return json_integer(old ^ (1 << test_random_below(20)));
    case 3:
        return json_real((double)old);
    case 4:
        return json_null();
    default:
        return json_string("0");
    }
}

static json_t *changed_value(const json_t *old)
{
    static const char *const words[] = {"",     "box3",  "octagon",  "disk",   "slack", "trim",
                                        "grow", "check", "preserve", "repair", "other"};
    char copy[80];
    if (json_is_integer(old)) {
        return changed_integer(json_integer_value(old));
    }
    if (json_is_real(old)) {
        double value = json_real_value(old);
        return test_random_below(2) ? json_real(nextafter(value, 1e9)) : json_real(value * 1.01);
    }
    if (json_is_string(old) && json_string_length(old) == 64) {
        snprintf(copy, sizeof copy, "%s", json_string_value(old));
        copy[test_random_below(64)] ^= 1;
        return json_string(copy);
    }
    return test_random_below(6) ? json_string(words[test_random_below(11)]) : json_integer(1);
}

// Change something in an array: its entries, their number or their order.
static void change_array(json_t *array, size_t i)
{
    size_t other = test_random_below((uint32_t)json_array_size(array));
    json_t *p = json_incref(json_array_get(array, i)), *q = json_array_get(array, other);
    switch (test_random_below(4)) {
    case 0:
        json_array_remove(array, i);
        break;
    case 1:
        json_array_insert(array, other, p);
        break;
    case 2:
        json_array_set(array, i, q);
        json_array_set(array, other, p);
        break;
    default:
        json_array_set_new(array, i, changed_value(p));
    }
    json_decref(p);
}

static void change_object(json_t *object, const char *key)
{
    json_t *old = json_object_get(object, key);
    switch (test_random_below(4)) {
    case 0:
        json_object_del(object, key);
        break;
    case 1:
        json_object_set_new(object, "more", json_integer(1));
        break;
    default:
        json_object_set_new(object, key, changed_value(old));
    }
}

// Walk down from the top to something to change; `path` gets the keys.
static void change_one(json_t *node, char path[128])
{
    path[0] = '\0';
    for (;;) {
        size_t size = json_is_array(node) ? json_array_size(node) : json_object_size(node);
        size_t i = size > 0 ? test_random_below((uint32_t)size) : 0;
        const char *key = NULL;
        json_t *inner = NULL;
        if (size == 0) {
            json_is_array(node) ? json_array_append_new(node, json_integer(0)) : 0;
            return;
        }
        if (json_is_object(node)) {
            void *place = json_object_iter(node);
            for (size_t n = 0; n < i; n++) {
                place = json_object_iter_next(node, place);
            }
            key = json_object_iter_key(place);
            inner = json_object_iter_value(place);
            snprintf(path + strlen(path), 128 - strlen(path), "/%s", key);
        } else {
            inner = json_array_get(node, i);
        }
        int deeper = (json_is_array(inner) || json_is_object(inner)) && test_random_below(8) > 0;
        if (!deeper) {
            json_is_object(node) ? change_object(node, key) : change_array(node, i);
            return;
        }
        node = inner;
    }
}

// What nothing in a stack can contradict.
static int may_pass(const char *path)
{
    return strcmp(path, "/input/sha256") == 0 || strcmp(path, "/operation/name") == 0 ||
           strcmp(path, "/rule/tangent") == 0 || strcmp(path, "/exempt") == 0 ||
           strcmp(path, "/bridges") == 0;
}

static void ten_thousand_forged_fields(void)
{
    int tried = 0, passed = 0;
    for (int i = 0; i < CASES; i++) {
        show_grid(cases[i].grid, &cases[i].made.info);
        json_t *document = json_loadb(cases[i].t.bytes, cases[i].t.size, 0, NULL);
        text same = text_with_digest(document);
        CHECK(accepts(&same));
        free(same.bytes);
        for (int n = 0; n < CHANGES / CASES + 1;) {
            char path[128];
            json_t *changed = json_deep_copy(document);
            change_one(changed, path);
            if (!json_equal(changed, document)) {
                text t = text_with_digest(changed);
                int good = accepts(&t);
                n++;
                tried++;
                passed += good;
                if (good && !may_pass(path)) {
                    printf("# case %d: %s was changed and passed\n", i, path);
                    CHECK(!"a forged field is refused");
                }
                free(t.bytes);
            }
            json_decref(changed);
        }
        json_decref(document);
    }
    CHECK(tried >= CHANGES);
    printf("# %d of %d forged fields pass: input, operation, order\n", passed, tried);
    CHECK(passed < tried / 20);
}

// ---------------------------------------------------------------------------------------------
// Changes of the stack
// ---------------------------------------------------------------------------------------------

// Whether the library certifies an edited grid and the verifier accepts that; both must agree.
static int is_certified(const certified *c)
{
    sf_terms terms = terms_of(&c->made, c->exempt);
    sf_claim claim = claim_of(&c->made, &terms, SF_OPERATION_CHECK, NULL);
    sf_certificate *made = NULL;
    sf_status status = sf_certificate_make(c->grid, &claim, NULL, NULL, &made, NULL);
    CHECK(status == SF_OK || status == SF_ERR_INFEASIBLE);
    if (status != SF_OK) {
        return 0;
    }
    text t = certificate_text(made);
    CHECK(accepts(&t));
    free(t.bytes);
    sf_certificate_destroy(made);
    return 1;
}

// What the verifier itself makes of the voxels and the witnesses, fingerprints left aside.
static int verifier_judges(const certified *c)
{
    json_t *document = json_loadb(c->t.bytes, c->t.size, 0, NULL);
    long v = 0;
    while (v < area * nz && codes[v] == 0) {
        v++;
    }
    bed = c->made.info.bed_layer == SF_BED_AUTO ? (int)(v / area) : (int)c->made.info.bed_layer;
    for (v = 0; v < area * nz; v++) {
        codes[v] = (short)(codes[v] != 0 ? WAITS : 0);
    }
    layers = json_array();
    int good = judge(json_object_get(document, "exempt"), json_object_get(document, "bridges"));
    json_decref(layers);
    layers = NULL;
    json_decref(document);
    return good;
}

static void flip(sf_grid *grid, uint32_t x, uint32_t y, uint32_t z)
{
    sf_slice slice = sf_grid_slice(grid, z);
    CHECK_EQ(sf_slice_set(slice, x, y, !sf_slice_get(slice, x, y)), SF_OK);
    short *code = at((int)x, (int)y, (int)z);
    *code = (short)!*code;
    bits[(long)z * layer + (ny - 1 - (long)y) * row + (long)x / 8] ^= (unsigned char)(128 >> x % 8);
}

// The edited stack is refused; and it is support-free or not to the library, the verifier and to
// brute force alike. Witnesses that no longer hold prove nothing, so there only one way is certain.
static void edit(certified *c, int n, int counts[2])
{
    static stack s, free_voxels;
    uint32_t x = test_random_below((uint32_t)nx), y = test_random_below((uint32_t)ny);
    uint32_t z = test_random_below((uint32_t)nz);
    flip(c->grid, x, y, z);
    CHECK(!accepts(&c->t));
    if (n % 4 == 0) {
        stack_read(&s, c->grid);
        if (c->exempt != NULL) {
            stack_read(&free_voxels, c->exempt);
        }
        int expected = naive_is_free(&s, c->exempt != NULL ? &free_voxels : NULL, &c->made.rule,
                                     c->made.info.bed_layer);
        int judged = verifier_judges(c);
        CHECK(c->exempt == NULL ? judged == expected : judged <= expected);
        CHECK_EQ(is_certified(c), expected);
        counts[expected]++;
    }
    flip(c->grid, x, y, z);
}

static void ten_thousand_edited_voxels(void)
{
    int counts[2] = {0, 0}, tried = 0;
    for (int i = 0; i < CASES; i++) {
        show_grid(cases[i].grid, &cases[i].made.info);
        CHECK(accepts(&cases[i].t));
        for (int n = 0; n < CHANGES / CASES + 1; n++, tried++) {
            edit(&cases[i], n, counts);
        }
        CHECK(accepts(&cases[i].t));
    }
    CHECK(tried >= CHANGES && counts[0] > 500 && counts[1] > 500);
}

int main(void)
{
    for (int i = 0; i < CASES; i++) {
        certify(i);
    }
    TEST(ten_thousand_changed_texts_are_refused);
    TEST(ten_thousand_forged_fields);
    TEST(ten_thousand_edited_voxels);
    for (int i = 0; i < CASES; i++) {
        sf_grid_destroy(cases[i].grid);
        sf_grid_destroy(cases[i].exempt);
        free(cases[i].t.bytes);
    }
    forget();
    return test_finish();
}

// SPDX-License-Identifier: MIT
// A stack that is cut, changed or lies is refused with a sentence, before memory is taken for what
// it claims; a write that fails at any byte leaves no stack behind. Guards: TRUST B4, B5, the
// strong guarantee, issue 2 (nothing leaves half a file).

#include "stack_files.h"

#include "failing_allocator.h"

static sf_grid *small_grid(uint32_t nz)
{
    sf_lattice lattice = {10, 7, nz, 0.1, 0.1, 0.1, NULL, {0, 0, 0}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    for (uint32_t k = 0; k < nz; k++) {
        CHECK_EQ(sf_slice_set(sf_grid_slice(grid, k), k % 10, k % 7, 1), SF_OK);
    }
    return grid;
}

static sf_status read_it(sf_folder files, sf_fault *fault)
{
    failing_allocator memory;
    failing_begin(&memory, -1);
    sf_grid *grid = NULL;
    memset(fault, 0, sizeof *fault);
    sf_status status = sf_stack_read(files, &memory.allocator, NULL, &grid, NULL, fault);
    CHECK((status == SF_OK) == (grid != NULL));
    CHECK(status == SF_OK || (fault->status == status && strlen(fault->message) > 20));
    sf_grid_destroy(grid);
    CHECK(memory.live == 0 && memory.faults == 0);
    return status;
}

static int reading_works(void)
{
    memory_folder folder;
    sf_folder files = memory_begin_folder(&folder);
    sf_fault fault;
    return read_it(files, &fault) != SF_ERR_UNSUPPORTED;
}

static const struct {
    const char *from, *to;
    sf_status status;
} change[] = {
    {"libsf-stack", "other-stack", SF_ERR_FORMAT},
    {"\"version\": 1", "\"version\": 3", SF_ERR_UNSUPPORTED},
    {"\"mm\"", "\"in\"", SF_ERR_UNSUPPORTED},
    {"\"white\"", "\"black\"", SF_ERR_UNSUPPORTED},
    {"top_is_max_y", "top_is_min_y", SF_ERR_UNSUPPORTED},
    {"\"nx\": 10", "\"nx\": 11", SF_ERR_FORMAT},
    {"\"nx\": 10", "\"nx\": -1", SF_ERR_FORMAT},
    {"\"nx\": 10", "\"nx\": 1.5", SF_ERR_FORMAT},
    {"\"nx\": 10", "\"nx\": 0", SF_ERR_FORMAT},
    {"\"nx\": 10", "\"nx\": 99999999", SF_ERR_FORMAT},
    {"\"nz\": 3", "\"nz\": 4", SF_ERR_FORMAT},
    {"\"nz\": 3", "\"nz\": 0", SF_ERR_FORMAT},
    {"\"count\": 3", "\"count\": 2", SF_ERR_FORMAT},
    {"[0.1, 0.1]", "[0.1, 0]", SF_ERR_FORMAT},
    {"[0.1, 0.1]", "[0.1]", SF_ERR_FORMAT},
    {"[0.1, 0.1]", "0.1", SF_ERR_FORMAT},
    {"[0.1, 0.1]", "[0.1, 1e999]", SF_ERR_FORMAT},
    {"[0.1, 0.1]", "[0.1, \"1\"]", SF_ERR_FORMAT},
    {"layer_mm\": 0.1", "layer_mm\": -0.1", SF_ERR_FORMAT},
    {"layer_mm\": 0.1", "heights_mm\": [0.1, 0.1]", SF_ERR_FORMAT},
    {"layer_mm\": 0.1", "heights_mm\": [0.1, 0.1, null]", SF_ERR_FORMAT},
    {"layer_mm\": 0.1", "nx\": 10", SF_ERR_FORMAT},
    {"\"octagon\"", "\"cross\"", SF_ERR_UNSUPPORTED},
    {"\"angle_rad\": ", "\"angle_rad\": 9", SF_ERR_FORMAT},
    {"\"bed_layer\": 1", "\"bed_layer\": 3", SF_ERR_FORMAT},
    {"\"bed_layer\": 1", "\"bed\": 1", SF_ERR_FORMAT},
    {"\"phase_layer\": 0", "\"phase_layer\": 1", SF_ERR_UNSUPPORTED},
    {",\n    \"phase_layer\": 0", "", SF_OK}, // as stacks were written before
    {"\"phase_layer\": 0", "\"phase_layer\": null", SF_ERR_UNSUPPORTED},
    {"layer_%05u", "../../%05u", SF_ERR_UNSUPPORTED},
    {"layer_%05u", "%n%s%s", SF_ERR_UNSUPPORTED},
};

static void refuses_damaged_documents(void)
{
    if (!reading_works()) {
        SKIP("this build has no jansson");
    }
    memory_folder folder;
    sf_folder files = memory_begin_folder(&folder);
    sf_grid *grid = small_grid(3);
    sf_stack_info info = {1, SF_RULE_OCTAGON, 0.7853981633974483, 1, 0, 0};
    sf_fault fault;
    CHECK_EQ(sf_stack_write(grid, &info, files, NULL, NULL), SF_OK);
    char original[2048] = {0}, changed[4096];
    memcpy(original, folder.files[3].bytes, folder.files[3].size);
    CHECK_EQ(read_it(files, &fault), SF_OK);
    for (size_t i = 0; i < sizeof change / sizeof change[0]; i++) {
        const char *at = strstr(original, change[i].from);
        CHECK(at != NULL);
        if (at != NULL) {
            snprintf(changed, sizeof changed, "%.*s%s%s", (int)(at - original), original,
                     change[i].to, at + strlen(change[i].from));
            memory_put(&folder, "stack.json", changed, strlen(changed));
            sf_status status = read_it(files, &fault);
            CHECK_EQ(status, change[i].status);
            if (status != change[i].status) {
                printf("# %s -> %s\n", change[i].from, change[i].to);
            }
        }
    }
    for (size_t size = 0; size + 2 < strlen(original); size++) {
        memory_put(&folder, "stack.json", original, size);
        CHECK_EQ(read_it(files, &fault), SF_ERR_FORMAT);
    }
    memset(changed, '[', sizeof changed); // deep
    memory_put(&folder, "stack.json", changed, sizeof changed);
    CHECK_EQ(read_it(files, &fault), SF_ERR_FORMAT);
    memory_end_folder(&folder);
    sf_grid_destroy(grid);
}

static void refuses_missing_pictures_before_taking_memory(void)
{
    if (!reading_works()) {
        SKIP("this build has no jansson");
    }
    // 65535 x 65535 x 2147483647 voxels claimed by some hundred bytes, and one picture of that
    // size.
    static const char text[] =
        "{\"format\":\"libsf-stack\",\"version\":1,\"units\":\"mm\",\"lattice\":{\"nx\":65535,"
        "\"ny\":"
        "65535,\"nz\":2147483647,\"pitch_mm\":[1,1],\"layer_mm\":1,\"origin_mm\":[0,0,0]},\"rule\":"
        "null,"
        "\"layers\":{\"pattern\":\"layer_%05u.pbm\",\"count\":2147483647},\"solid\":\"white\","
        "\"row_order\":\"top_is_max_y\"}";
    memory_folder folder;
    sf_folder files = memory_begin_folder(&folder);
    sf_fault fault;
    CHECK_EQ(read_it(files, &fault), SF_ERR_IO);
    memory_put(&folder, "stack.json", text, sizeof text - 1);
    CHECK_EQ(read_it(files, &fault), SF_ERR_IO);
    CHECK(strstr(fault.message, "layer_00000.pbm") != NULL);
    memory_put(&folder, "layer_00000.pbm", "P4 65535 65535 ", 15);
    CHECK_EQ(read_it(files, &fault), SF_ERR_IO);
    CHECK(strstr(fault.message, "layer_00001.pbm") != NULL);
    memory_end_folder(&folder);
}

static void survives_every_refused_allocation(void)
{
    if (!reading_works()) {
        SKIP("this build has no jansson");
    }
    memory_folder folder;
    sf_folder files = memory_begin_folder(&folder);
    sf_grid *grid = small_grid(3), *back = NULL;
    CHECK_EQ(sf_stack_write(grid, NULL, files, NULL, NULL), SF_OK);
    sf_status status = SF_ERR_MEMORY;
    for (long k = 0; status != SF_OK && k < 100; k++) {
        failing_allocator memory;
        sf_fault fault = {SF_OK, 0, 0, ""};
        failing_begin(&memory, k);
        status = sf_stack_read(files, &memory.allocator, NULL, &back, NULL, &fault);
        CHECK(status == SF_OK || (status == SF_ERR_MEMORY && back == NULL &&
                                  fault.status == SF_ERR_MEMORY && !folder.is_open));
        sf_grid_destroy(back);
        CHECK(memory.live == 0 && memory.faults == 0);
        back = NULL;
    }
    CHECK_EQ(status, SF_OK);
    sf_grid_destroy(grid);
    memory_end_folder(&folder);
}

static void a_failing_write_leaves_no_stack(void)
{
    sf_grid *grid = small_grid(3);
    for (long budget = 0;; budget += 7) {
        memory_folder folder;
        sf_folder files = memory_begin_folder(&folder);
        sf_fault fault = {SF_OK, 0, 0, ""};
        folder.budget = budget;
        sf_status status = sf_stack_write(grid, NULL, files, NULL, &fault);
        CHECK((status == SF_OK) == (memory_find(&folder, "stack.json") != NULL));
        CHECK(status == SF_OK || (status == SF_ERR_IO && strstr(fault.message, "writing") != NULL));
        CHECK(folder.draft.bytes == NULL && folder.faults == 0);
        memory_end_folder(&folder);
        if (status == SF_OK) {
            break;
        }
    }
    sf_grid_destroy(grid);
}

static void note_progress(void *user, double fraction)
{
    double *seen = user; // the last fraction, and how often
    CHECK(fraction >= seen[0] && fraction <= 1.0);
    seen[0] = fraction;
    seen[1] += 1;
}

static void tells_progress_and_can_be_cancelled(void)
{
    memory_folder folder;
    sf_folder files = memory_begin_folder(&folder);
    sf_grid *grid = small_grid(5), *back = NULL;
    double seen[2] = {0, 0};
    sf_task task = sf_task_default();
    task.progress = note_progress;
    task.user = seen;
    CHECK_EQ(sf_stack_write(grid, NULL, files, &task, NULL), SF_OK);
    CHECK(seen[0] == 1.0 && seen[1] == 5);
    sf_task_cancel(&task);
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_stack_write(grid, NULL, files, &task, &fault), SF_ERR_CANCELLED);
    if (reading_works()) {
        CHECK_EQ(sf_stack_read(files, NULL, &task, &back, NULL, &fault), SF_ERR_CANCELLED);
        CHECK(back == NULL && fault.status == SF_ERR_CANCELLED);
    }
    sf_grid_destroy(grid);
    memory_end_folder(&folder);
}

static void refuses_wrong_arguments(void)
{
    memory_folder folder;
    sf_folder files = memory_begin_folder(&folder), none;
    sf_grid *grid = small_grid(2), *back = NULL;
    memset(&none, 0, sizeof none);
    CHECK_EQ(sf_stack_write(NULL, NULL, files, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stack_write(grid, NULL, none, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stack_read(none, NULL, NULL, &back, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stack_read(files, NULL, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    sf_stack_info wrong[] = {
        {1, (sf_rule_kind)7, 0.7, 0, 0, 0}, {1, SF_RULE_DISK, 0.0, 0, 0, 0},
        {1, SF_RULE_DISK, NAN, 0, 0, 0},    {1, SF_RULE_OCTAGON, 1.6, 0, 0, 0},
        {1, SF_RULE_BOX3, 0.0, 2, 0, 0},    {1, SF_RULE_BOX3, 0.0, 0, -1, 0},
        {1, SF_RULE_SLACK, 0.7, 0, NAN, 0}, {1, SF_RULE_SLACK, 0.7, 0, 1, HUGE_VAL}};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        CHECK_EQ(sf_stack_write(grid, &wrong[i], files, NULL, NULL), SF_ERR_ARGUMENT);
    }
    CHECK_EQ(folder.count, 0);
    sf_grid_destroy(grid);
}

// A folder in which one file's source says that it read more than it was asked for.
typedef struct boaster {
    sf_folder honest;
    const char *name;
    sf_source source;
} boaster;

static sf_status boast(void *user, void *data, size_t capacity, size_t *size)
{
    boaster *b = user;
    sf_status status = b->source.read(b->source.user, data, capacity, size);
    *size = capacity + 1;
    return status;
}

static sf_status open_boasting(void *user, const char *name, sf_source *source)
{
    boaster *b = user;
    sf_status status = b->honest.open(b->honest.user, name, source);
    if (status == SF_OK && strcmp(name, b->name) == 0) {
        b->source = *source;
        source->read = boast;
        source->user = b;
    }
    return status;
}

static void close_boasting(void *user, sf_source source)
{
    boaster *b = user;
    b->honest.close(b->honest.user, source.user == b ? b->source : source);
}

static void a_source_that_gives_too_much_is_refused(void)
{
    memory_folder folder;
    sf_folder files = memory_begin_folder(&folder);
    sf_grid *grid = small_grid(3);
    sf_fault fault;
    CHECK_EQ(sf_stack_write(grid, NULL, files, NULL, NULL), SF_OK);
    for (int i = 0; i < folder.count && reading_works(); i++) {
        boaster b = {files, folder.files[i].name, {NULL, NULL}};
        sf_folder boasting = {open_boasting, close_boasting, NULL, NULL, &b};
        CHECK_EQ(read_it(boasting, &fault), SF_ERR_IO);
        CHECK(strstr(fault.message, folder.files[i].name) != NULL);
    }
    CHECK_EQ(folder.faults, 0);
    sf_grid_destroy(grid);
    memory_end_folder(&folder);
}

int main(void)
{
    TEST(refuses_damaged_documents);
    TEST(refuses_missing_pictures_before_taking_memory);
    TEST(survives_every_refused_allocation);
    TEST(a_failing_write_leaves_no_stack);
    TEST(tells_progress_and_can_be_cancelled);
    TEST(a_source_that_gives_too_much_is_refused);
    TEST(refuses_wrong_arguments);
    return test_finish();
}

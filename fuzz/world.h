// SPDX-License-Identifier: MIT
// A small world in which any function of the library can be called with arguments made of bytes.
//
// It keeps objects of every kind, makes those that are asked for and not there (recipes.c), hands
// out memory whose ends a sanitizer can see, files and folders that are memory, tasks that cancel,
// and an allocator that may refuse. Around each call it holds what every function promises: the
// status is one of those that are documented, a call that fails has changed no object and no output
// and has said why, what was only to be read was only read, progress never falls, nothing leaks.
//
// Who calls: world_begin(), then for each call its arguments, world_arm(), the function itself,
// world_judge(); at last world_end(), which frees all. calls.py writes that for each function.

#ifndef SF_FUZZ_WORLD_H
#define SF_FUZZ_WORLD_H

#include "draw.h"

#include <sf/cage_io.h>
#include <sf/exchange.h>
#include <sf/io.h>
#include <sf/layers.h>
#include <sf/session.h>
#include <sf/sf.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORLD_OBJECTS = 192, WORLD_OUTPUTS = 48, WORLD_FILES = 24 };

/** Something that the world owns. What is hidden is never picked again, only freed at the end. */
typedef struct world_object {
    const char *kind;
    void *object;
    uint64_t hash;
    int hidden, changes, culprits;
} world_object;

/** Memory that a call may write to, and what it held before. */
typedef struct world_output {
    void *place, *before;
    size_t size;
    int counts; // SF_ERR_CAPACITY and SF_ERR_INFEASIBLE may leave a number there
} world_output;

/** A file that is memory. */
typedef struct world_file {
    char name[40];
    unsigned char *bytes;
    size_t size, capacity;
} world_file;

typedef struct world {
    draw in;
    const char *function; // that is being called
    sf_lattice lattice;
    sf_rule rule;
    sf_terms terms;

    sf_allocator allocator;
    long requests, fail_at; // since the call began; the first request that is refused, or -1
    int fail_once;          // only that one is
    long refusals, live, faults;
    size_t bytes;
    uint32_t chance; // of 256 that a request is refused; 0: never
    uint64_t dice;
    int armed, called; // called: the call was made, its arguments were there

    sf_task task;
    double progress;
    long ticks, cancel_at;
    long cancel_wanted; // a test's: every call gets a task, which is cancelled at that tick; or -1

    sf_fault fault;
    sf_fault *fault_given;

    long transfers, break_at; // reads and writes since the call began; which fails, or -1
    long breaks, missing;
    world_file files[WORLD_FILES];
    size_t file_count;
    world_file *writing;
    sf_memory_cursor cursor; // of the file that is read

    world_object objects[WORLD_OBJECTS];
    size_t object_count;
    world_output outputs[WORLD_OUTPUTS];
    size_t output_count;
    void **scratch;
    size_t scratch_count, scratch_capacity;
} world;

/** A function of the library, called in a world. */
typedef struct world_call {
    const char *name, *header;   // header: "grid" of <sf/grid.h>
    sf_status (*call)(world *w); // SF_OK where it returns no status
    int has_status;
    uint32_t rarity; // slow ones are called one time in so many
} world_call;

extern const world_call world_calls[];
extern const size_t world_call_count;

/** Say what is broken, and stop. */
void world_fail(const world *w, const char *what);

void world_begin(world *w, const void *bytes, size_t size, int sane);

/** Free everything; stops where something leaked. */
void world_end(world *w);

/** From here to world_judge() the call runs: allocations count and may be refused. */
void world_arm(world *w, const char *function);

/** Hold a call's promises. `codes` has a bit for each status that is documented for it. */
void world_judge(world *w, sf_status status, uint32_t codes);

/** A function that returns no status: only what may be changed was changed. */
void world_judge_quiet(world *w);

// --- objects -------------------------------------------------------------------------------------

/** One of a kind, made where there is none; NULL where that fails, or now and then for no reason.
 */
void *world_pick(world *w, const char *kind);

/** One of a kind that the call may change. */
void *world_change(world *w, const char *kind);

/** The same, where SF_ERR_INFEASIBLE leaves what cannot be carried. */
void *world_culprits(world *w, const char *kind);

/** A new one that nothing else uses; it is picked by nobody. */
void *world_own(world *w, const char *kind);

/** A new one that the call frees, so the world does not. */
void *world_give(world *w, const char *kind);

/** Take what a call made. */
void world_keep(world *w, const char *kind, void *object);

/** Never NULL, also where things are odd: for functions that take no NULL. */
void *world_need(world *w, const char *kind);

/** A new object of a kind, out of bytes, or NULL: recipes.c. */
void *world_make(world *w, const char *kind);
void world_destroy(const char *kind, void *object);

/** A number that says what an object holds, as far as can be seen; 0 for kinds that cannot be seen
 * into. Stops where an object breaks what is always true of its kind: look.c. */
uint64_t world_look(const world *w, const char *kind, const void *object);

// --- memory --------------------------------------------------------------------------------------

/** Memory that lives until the world ends, zeroed. */
void *world_scratch(world *w, size_t size);

/** Memory that the call may write to, unless it fails. */
void *world_room(world *w, size_t size, int counts);

/** The same, which holds something. */
void *world_inout(world *w, const void *held, size_t size);

// --- arguments -----------------------------------------------------------------------------------

size_t world_few(world *w);
const double *world_doubles(world *w, size_t count);
const double *world_places(world *w, size_t count);
const float *world_floats(world *w, size_t count);
const uint32_t *world_words(world *w, size_t count);
const uint8_t *world_bytes(world *w, size_t count);
const char *world_text(world *w);
const char *world_path(world *w);

/** Of something that is there, most of the time. */
const char *world_path_of(world *w, const char *kind);
const sf_allocator *world_allocator(world *w);
sf_task *world_task(world *w);
sf_fault *world_fault(world *w);
sf_sink world_sf_sink(world *w);
sf_source world_sf_source(world *w);
sf_folder world_sf_folder(world *w);
sf_folder world_folder_of_stack(world *w);

/** A source of what a writer wrote of an object of the kind, now and then with some other bytes. */
sf_source world_source_of_scene(world *w);
sf_source world_source_of(world *w, const char *kind);

sf_slice world_sf_slice(world *w);
sf_slice world_layer(world *w);
sf_rect world_sf_rect(world *w);
sf_lattice world_sf_lattice(world *w);
sf_mesh_view world_sf_mesh_view(world *w);
sf_contours world_sf_contours(world *w);
sf_cage_view world_sf_cage_view(world *w);
sf_tets_view world_sf_tets_view(world *w);
sf_channel world_sf_channel(world *w);
sf_property world_sf_property(world *w);
sf_blend world_sf_blend(world *w);
sf_rule world_sf_rule(world *w);
sf_terms world_sf_terms(world *w);
sf_terms world_own_terms(world *w);
sf_element world_sf_element(world *w);
sf_handle world_sf_handle(world *w);
sf_pose world_sf_pose(world *w);
sf_run *world_runs(world *w, size_t count);
sf_box world_sf_box(world *w);
sf_voxel world_sf_voxel(world *w);
sf_dab world_sf_dab(world *w);
sf_material world_sf_material(world *w);
sf_tones world_sf_tones(world *w);
sf_materials world_sf_materials(world *w);
sf_stroke world_sf_stroke(world *w);
uint32_t world_bed(world *w);
uint32_t world_index(world *w);
uint32_t world_sectors(world *w);
double world_angle(world *w);

// --- arguments that keep.c makes -----------------------------------------------------------------

/** The world's own callbacks. */
int world_sf_cage_place_function(void *user, const double at_mm[3], double moved_mm[3]);
int world_sf_cage_value_function(void *user, const double at_mm[3], double *value);

/** Stops where a call with a status made something and failed, or did not and was good. */
void world_made(const world *w, sf_status status, int wanted, int made);

sf_mesh_view world_own_view(world *w);
const sf_stance *const *world_stances(world *w);
sf_rule *world_rule_to_change(world *w);
size_t world_checker_size(world *w, const sf_check_options *options);
const sf_finding *world_findings(world *w, const sf_grid *grid, const sf_terms *terms,
                                 size_t *count);
const sf_terms *world_terms_to_keep(world *w);
const double *world_shares(world *w, size_t count);
const double *world_pattern(world *w, size_t count);
const sf_place *world_where(world *w, const sf_limit *limit, size_t count);
const size_t *world_channels(world *w, size_t count);
const uint32_t *world_ranks(world *w, size_t count);
sf_folder world_folder_to_keep(world *w);
sf_cage *world_faces(world *w);
const sf_grid *world_wall(world *w, const sf_grid *solid);
const double *world_fractions(world *w, size_t materials, size_t count);
double **world_planes(world *w);
const uint8_t *world_ids(world *w, size_t count);

// --- how many numbers a call looks at ------------------------------------------------------------

/** Voxels of the world's lattice, which is that of most of its grids; none has more. */
size_t world_voxels(const world *w);

/** Voxels of a grid; 0 for NULL. */
size_t voxels_of(const sf_grid *grid);
size_t handles_of(const sf_weights *weights);
size_t points_of(const sf_cage *cage);
size_t points_of_refinement(const sf_refinement *refinement);

#endif

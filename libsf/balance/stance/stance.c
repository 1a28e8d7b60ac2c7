// SPDX-License-Identifier: MIT
// Stances: how a body is to come to rest, and what that asks of its centre of mass.
//
// This file makes, keeps and shows them. What touches the ground is found in contact.c; what
// standing, hanging and rocking ask for is said in tip.c, hang.c and rock.c, as half-spaces and as
// a verdict. The two must agree: a centre of mass in all half-spaces stands, and tests hold that.

#include "balance/stance/stance.h"

#include "base/math.h"
#include "base/memory.h"
#include "base/status.h"
#include "mesh/vector.h"

#include <math.h>
#include <string.h>

#define DEGREE_RAD 0.017453292519943295
#define TOLERANCE_MAX (45 * DEGREE_RAD)
#define COORDINATE_MAX 1e12
#define LEVER_SHARE 1e-2
#define SAFE_SHARE 1e-9

// ---------------------------------------------------------------------------------------------
// Directions and lengths
// ---------------------------------------------------------------------------------------------

double sfi_length(const double a[3])
{
    return sqrt(sfi_dot(a, a));
}

void sfi_normalize(double a[3])
{
    double length = sfi_length(a);
    for (int i = 0; i < 3 && length > 0; i++) {
        a[i] /= length;
    }
}

// W. Kahan, "How Futile are Mindless Assessments of Roundoff in Floating-Point Computation?", 2006,
// section 12: well-conditioned for all angles.
double sfi_tilt(const double a[3], const double b[3])
{
    double u[3], v[3], sum[3], difference[3];
    memcpy(u, a, sizeof u);
    memcpy(v, b, sizeof v);
    sfi_normalize(u);
    sfi_normalize(v);
    for (int i = 0; i < 3; i++) {
        sum[i] = u[i] + v[i];
    }
    sfi_subtract(u, v, difference);
    double along = sfi_length(sum);
    return along > 0 ? 2 * sfi_atan(sfi_length(difference) / along) : 2 * SFI_HALF_PI;
}

double sfi_cosine(int i)
{
    static const double quarter[9] = {1,
                                      0.98078528040323044913,
                                      0.92387953251128675613,
                                      0.83146961230254523708,
                                      0.70710678118654752440,
                                      0.55557023301960222474,
                                      0.38268343236508977173,
                                      0.19509032201612826785,
                                      0};
    i = (i % 32 + 32) % 32;
    i = i > 16 ? 32 - i : i;
    return i <= 8 ? quarter[i] : -quarter[16 - i];
}

// From the axis that up leans to least, so that an up along an axis gets axes.
void sfi_frame_around(const double up[3], double east[3], double north[3])
{
    int axis = 0;
    for (int i = 1; i < 3; i++) {
        axis = fabs(up[i]) < fabs(up[axis]) ? i : axis;
    }
    for (int i = 0; i < 3; i++) {
        east[i] = (i == axis) - up[axis] * up[i];
    }
    sfi_normalize(east);
    sfi_cross(up, east, north);
}

// ---------------------------------------------------------------------------------------------
// Half-spaces
// ---------------------------------------------------------------------------------------------

sf_status sfi_stance_reserve(sf_stance *s, size_t count)
{
    s->halfspaces = sfi_alloc_array(&s->allocator, count, sizeof *s->halfspaces);
    s->halfspace_capacity = s->halfspaces != NULL ? count : 0;
    return s->halfspaces != NULL ? SF_OK : SF_ERR_MEMORY;
}

void sfi_stance_bound(sf_stance *s, const double normal[3], const double through[3], double least)
{
    sf_halfspace *made = &s->halfspaces[s->halfspace_count++];
    memcpy(made->normal, normal, sizeof made->normal);
    double length = sfi_length(normal);
    for (int i = 0; i < 3; i++) {
        made->normal[i] /= length;
    }
    made->offset_mm = sfi_dot(made->normal, through) + least / length;
}

// ---------------------------------------------------------------------------------------------
// Options
// ---------------------------------------------------------------------------------------------

sf_stance_options sf_stance_options_default(void)
{
    sf_stance_options options = {.struct_size = sizeof options,
                                 .up = {0, 0, 1},
                                 .gamma_rad = 4 * DEGREE_RAD,
                                 .tolerance_rad = DEGREE_RAD,
                                 .range_rad = 20 * DEGREE_RAD,
                                 .region_low_mm = {-INFINITY, -INFINITY, -INFINITY},
                                 .region_high_mm = {INFINITY, INFINITY, INFINITY}};
    return options;
}

int sfi_is_place(const double v[3])
{
    return fabs(v[0]) <= COORDINATE_MAX && fabs(v[1]) <= COORDINATE_MAX &&
           fabs(v[2]) <= COORDINATE_MAX;
}

int sfi_is_direction(const double v[3])
{
    double length = sfi_length(v);
    return length > 1e-100 && length < 1e100;
}

// What is wrong with options, or NULL.
static const char *find_fault(const sf_stance_options *o)
{
    int is_region = 1;
    for (int i = 0; i < 3; i++) {
        is_region = is_region && o->region_low_mm[i] <= o->region_high_mm[i];
    }
    if (o->struct_size < sizeof *o) {
        return "the options of a stance have no struct_size; make them with "
               "sf_stance_options_default()";
    }
    if ((int)o->kind < SF_STANCE_STAND || o->kind > SF_STANCE_ROCK) {
        return "there is no such kind of stance";
    }
    if (!sfi_is_direction(o->up)) {
        return "up is no direction: it has no length, or one that is no number";
    }
    if (!(o->gamma_rad >= 0 && o->gamma_rad <= SFI_TILT_MAX)) {
        return "the tilt to survive must be 0 to 80 degrees";
    }
    if (!(o->tolerance_rad > 0 && o->tolerance_rad <= TOLERANCE_MAX)) {
        return "the tolerance must be more than 0 and at most 45 degrees";
    }
    if (!(o->range_rad > 0 && o->range_rad <= SFI_TILT_MAX)) {
        return "the range must be more than 0 and at most 80 degrees";
    }
    if (o->kind == SF_STANCE_ROCK && !(o->range_rad > o->tolerance_rad)) {
        return "the range from which it rolls back must be more than the tolerance";
    }
    if (!(o->contact_mm >= 0 && o->contact_mm <= COORDINATE_MAX && o->lever_mm >= 0 &&
          o->lever_mm <= COORDINATE_MAX)) {
        return "contact and lever must be lengths of 0 to 1e12 mm";
    }
    if (!is_region) {
        return "the region of contacts is empty: its lower corner lies above its upper one";
    }
    if (!sfi_is_place(o->point_mm)) {
        return "the point it hangs from must be numbers within 1e12 mm";
    }
    return NULL;
}

// Keep the options, with what their zeros stand for.
static void resolve(sf_stance *s, const sf_stance_options *options)
{
    memcpy(&s->options, options, sizeof s->options);
    s->options.struct_size = sizeof s->options;
    sfi_normalize(s->options.up);
    if (s->options.contact_mm == 0) {
        s->options.contact_mm = SFI_CONTACT_SHARE * s->diagonal_mm;
    }
    if (s->options.lever_mm == 0) {
        s->options.lever_mm = LEVER_SHARE * s->diagonal_mm;
    }
}

// ---------------------------------------------------------------------------------------------
// Making and freeing
// ---------------------------------------------------------------------------------------------

sf_status sfi_mesh_box(sf_mesh_view mesh, double low[3], double extent[3], sf_fault *fault)
{
    double high[3];
    SF_TRY(sf_mesh_validate(mesh, fault));
    if (mesh.triangle_count == 0) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "the mesh has no triangles");
    }
    SF_TRY(sf_mesh_bounds(mesh, low, high));
    if (!sfi_is_place(low) || !sfi_is_place(high)) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "the mesh reaches beyond 1e12 mm; check its units");
    }
    sfi_subtract(high, low, extent);
    return SF_OK;
}

static sf_status fill(sf_stance *s, sf_mesh_view mesh, sf_fault *fault)
{
    sf_status status = sfi_stance_touch(s, mesh, fault);
    if (status == SF_OK) {
        status = s->options.kind == SF_STANCE_HANG   ? sfi_hang_bound(s)
                 : s->options.kind == SF_STANCE_ROCK ? sfi_rock_bound(s, mesh, fault)
                                                     : sfi_stand_bound(s);
    }
    return status == SF_ERR_MEMORY
               ? sfi_fault_set(fault, status, 0, 0, "there is not enough memory for the stance")
               : status;
}

sf_status sf_stance_create(sf_mesh_view mesh, const sf_stance_options *options,
                           const sf_allocator *allocator, sf_stance **stance, sf_fault *fault)
{
    if (options == NULL || stance == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "a pointer is missing");
    }
    const char *wrong = find_fault(options);
    if (wrong != NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "%s", wrong);
    }
    sf_stance made;
    memset(&made, 0, sizeof made);
    made.allocator = sfi_allocator_or_default(allocator);
    SF_TRY(sfi_mesh_box(mesh, made.low, made.extent, fault));
    made.diagonal_mm = sfi_length(made.extent);
    made.vertex_count = mesh.vertex_count;
    resolve(&made, options);
    sfi_frame_around(made.options.up, made.east, made.north);
    sf_stance *kept = sfi_alloc_array(&made.allocator, 1, sizeof *kept);
    if (kept == NULL) {
        return sfi_fault_set(fault, SF_ERR_MEMORY, 0, 0,
                             "there is not enough memory for the stance");
    }
    *kept = made;
    sf_status status = fill(kept, mesh, fault);
    if (status != SF_OK) {
        sf_stance_destroy(kept);
        return status;
    }
    *stance = kept;
    return SF_OK;
}

void sf_stance_destroy(sf_stance *stance)
{
    if (stance != NULL) {
        sf_allocator from = stance->allocator;
        sfi_free_array(&from, stance->contacts, stance->contact_count, sizeof *stance->contacts);
        sfi_free_array(&from, stance->corners, stance->corner_count, 3 * sizeof(double));
        sfi_free_array(&from, stance->polygon, stance->polygon_capacity, 3 * sizeof(double));
        sfi_free_array(&from, stance->halfspaces, stance->halfspace_capacity,
                       sizeof *stance->halfspaces);
        sfi_free_array(&from, stance, 1, sizeof *stance);
    }
}

// ---------------------------------------------------------------------------------------------
// Showing
// ---------------------------------------------------------------------------------------------

sf_stance_options sf_stance_get_options(const sf_stance *stance)
{
    return stance->options;
}

double sf_stance_ground(const sf_stance *stance)
{
    return stance->ground_mm;
}

// Copy a list out, or say how long it is.
static sf_status hand_out(const void *list, size_t length, size_t element_size, void *to,
                          size_t capacity, size_t *count)
{
    if (count == NULL || (to == NULL && capacity > 0)) {
        return SF_ERR_ARGUMENT;
    }
    *count = length;
    if (length > capacity) {
        return SF_ERR_CAPACITY;
    }
    if (length > 0) {
        memcpy(to, list, length * element_size);
    }
    return SF_OK;
}

sf_status sf_stance_polygon(const sf_stance *stance, double *xyz, size_t capacity, size_t *count)
{
    return stance == NULL ? SF_ERR_ARGUMENT
                          : hand_out(stance->polygon, stance->polygon_count, 3 * sizeof(double),
                                     xyz, capacity, count);
}

sf_status sf_stance_contacts(const sf_stance *stance, uint32_t *vertices, size_t capacity,
                             size_t *count)
{
    return stance == NULL ? SF_ERR_ARGUMENT
                          : hand_out(stance->contacts, stance->contact_count, sizeof *vertices,
                                     vertices, capacity, count);
}

sf_status sf_stance_halfspaces(const sf_stance *stance, sf_halfspace *halfspaces, size_t capacity,
                               size_t *count)
{
    return stance == NULL ? SF_ERR_ARGUMENT
                          : hand_out(stance->halfspaces, stance->halfspace_count,
                                     sizeof *halfspaces, halfspaces, capacity, count);
}

sf_status sf_stance_judge(const sf_stance *stance, const double com_mm[3],
                          sf_stance_verdict *verdict)
{
    sf_stance_verdict found;
    if (stance == NULL || com_mm == NULL || verdict == NULL || !sfi_is_place(com_mm)) {
        return SF_ERR_ARGUMENT;
    }
    memset(&found, 0, sizeof found);
    found.slack_mm = INFINITY;
    for (size_t i = 0; i < stance->halfspace_count; i++) {
        const sf_halfspace *h = &stance->halfspaces[i];
        double slack = sfi_dot(h->normal, com_mm) - h->offset_mm;
        found.slack_mm = slack < found.slack_mm ? slack : found.slack_mm;
    }
    found.safe = found.slack_mm >= -SAFE_SHARE * stance->diagonal_mm;
    if (stance->options.kind == SF_STANCE_HANG) {
        sfi_hang_judge(stance, com_mm, &found);
    } else if (stance->options.kind == SF_STANCE_ROCK) {
        SF_TRY(sfi_rock_judge(stance, com_mm, &found));
    } else {
        sfi_stand_judge(stance, com_mm, &found);
    }
    *verdict = found;
    return SF_OK;
}

// SPDX-License-Identifier: MIT
// Recipes from a file (docs/paint.schema.json): a list of steps.
//
// A step creates a property, or selects points and does one thing to them. Lengths and places are
// mm of the cage as it is worked on, after --units, --scale and --size.

#include "recipes.h"

#include "expression.h"
#include "json_read.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef SF_HAVE_JANSSON

// The step that is being done.
typedef struct step {
    cli_job *job;
    sf_cage *cage;
    const json_t *says;
    size_t number;
    double *weights; // of each point
} step;

static const char *const selections[] = {"all", "points", "ball", "capsule"};
static const char *const actions[] = {"set", "add", "smooth", "expression", "move", "smooth_shape"};
static const char *const keys[] = {"create", "value",  "low",  "high",         "property",
                                   "all",    "points", "ball", "capsule",      "set",
                                   "add",    "smooth", "move", "smooth_shape", "expression"};
static const char *const brush_keys[] = {"at_mm",   "from_mm",  "to_mm", "radius_mm",
                                         "falloff", "strength", "where"};

static exit_status fail(const step *s, const char *what)
{
    char words[512];
    snprintf(words, sizeof words, "step %zu: %.400s", s->number + 1, what);
    return json_fail(s->job, EXIT_INPUT, "--paint", s->job->options.paint, words);
}

// Which one of some keys a step has; -1 for none, -2 for several.
static int which_key(const json_t *says, const char *const *names, int count)
{
    int found = -1;
    for (int i = 0; i < count; i++) {
        if (json_object_get(says, names[i]) != NULL) {
            found = found == -1 ? i : -2;
        }
    }
    return found;
}

// ---------------------------------------------------------------------------------------------
// Properties
// ---------------------------------------------------------------------------------------------

static exit_status name_property(const step *s, const char *name, sf_property *p)
{
    const sf_property known[3] = {sf_property_density(), sf_property_young(),
                                  sf_property_poisson()};
    if (sf_property_named(name, p) != SF_OK) {
        return fail(s, "a property has a name of 1 to 47 bytes.");
    }
    for (int i = 0; i < 3; i++) {
        *p = strcmp(name, known[i].name) == 0 ? known[i] : *p;
    }
    if (!json_get_number(s->says, "low", &p->low) || !json_get_number(s->says, "high", &p->high)) {
        return fail(s, "low and high are numbers.");
    }
    return EXIT_GOOD;
}

static exit_status create(const step *s)
{
    sf_cage_view v = sf_cage_get_view(s->cage);
    sf_channel channel;
    sf_fault fault = {SF_OK, 0, 0, ""};
    double value = 0;
    memset(&channel, 0, sizeof channel);
    exit_status status =
        name_property(s, json_string_value(json_object_get(s->says, "create")), &channel.property);
    if (status != EXIT_GOOD) {
        return status;
    }
    if (!json_get_number(s->says, "value", &value)) {
        return fail(s, "value is a number.");
    }
    double *values = malloc(v.point_count * sizeof *values);
    if (values == NULL) {
        return job_fail(s->job, EXIT_RESOURCE, "There is no memory for a property.");
    }
    for (size_t i = 0; i < v.point_count; i++) {
        values[i] = value;
    }
    channel.value_count = v.point_count;
    channel.values = values;
    sf_status added = sf_cage_add_property(s->cage, &channel, &fault);
    free(values);
    return added == SF_OK ? EXIT_GOOD : fail(s, fault.message);
}

static exit_status find_property(const step *s, size_t *channel)
{
    sf_cage_view v = sf_cage_get_view(s->cage);
    const char *name = json_string_value(json_object_get(s->says, "property"));
    for (*channel = 0; name != NULL && *channel < v.channel_count; (*channel)++) {
        if (strcmp(v.channels[*channel].property.name, name) == 0) {
            return EXIT_GOOD;
        }
    }
    if (name == NULL) {
        return fail(s, "set, add, smooth and expression need a property.");
    }
    char what[400] = "";
    snprintf(what, sizeof what, "there is no property '%.47s'; ", name);
    for (size_t i = 0; i < v.channel_count && strlen(what) < 300; i++) {
        size_t used = strlen(what);
        snprintf(what + used, sizeof what - used, "%s'%s'", i > 0 ? ", " : "there is ",
                 v.channels[i].property.name);
    }
    size_t used = strlen(what);
    snprintf(what + used, sizeof what - used, "%s\"create\" it first.",
             v.channel_count > 0 ? ", or " : "");
    return fail(s, what);
}

// ---------------------------------------------------------------------------------------------
// Selections
// ---------------------------------------------------------------------------------------------

static exit_status select_points(const step *s, const json_t *list)
{
    size_t count = sf_cage_get_view(s->cage).point_count;
    if (!json_is_array(list) || json_array_size(list) == 0) {
        return fail(s, "points is a list of numbers of points.");
    }
    for (size_t i = 0; i < json_array_size(list); i++) {
        const json_t *item = json_array_get(list, i);
        if (!json_is_integer(item) || json_integer_value(item) < 0 ||
            (uint64_t)json_integer_value(item) >= count) {
            return fail(s, "points are whole numbers from 0 to one less than there are points.");
        }
        s->weights[json_integer_value(item)] = 1;
    }
    return EXIT_GOOD;
}

// A brush that meets no point does nothing, and the points of a cage are few and far apart.
static void warn_of_air(const step *s, size_t touched)
{
    if (touched == 0) {
        job_warn(s->job,
                 "%.300s: step %zu touches no point of the cage, so it changes nothing; see where "
                 "its points are, and take a larger radius_mm.",
                 s->job->options.paint, s->number + 1);
    }
}

static exit_status select_brush(const step *s, const json_t *says, int is_ball)
{
    size_t touched = 0;
    static const char *const falloffs[] = {"constant", "linear", "smooth", "gaussian"};
    static const char *const wheres[] = {"all", "outside", "inside"};
    sf_paint_brush b = sf_paint_brush_default();
    int falloff = json_get_choice(says, "falloff", falloffs, 4, SF_FALLOFF_SMOOTH);
    int where = json_get_choice(says, "where", wheres, 3, SF_PAINT_ALL);
    int good = json_has_only(says, brush_keys, sizeof brush_keys / sizeof brush_keys[0]) &&
               json_object_get(says, "radius_mm") != NULL &&
               json_get_number(says, "radius_mm", &b.radius_mm) &&
               json_get_number(says, "strength", &b.strength) && falloff >= 0 && where >= 0;
    if (is_ball) {
        good = good && json_object_get(says, "at_mm") != NULL &&
               json_get_triple(says, "at_mm", b.from_mm);
        memcpy(b.to_mm, b.from_mm, sizeof b.to_mm);
    } else {
        good = good && json_object_get(says, "from_mm") != NULL &&
               json_object_get(says, "to_mm") != NULL &&
               json_get_triple(says, "from_mm", b.from_mm) &&
               json_get_triple(says, "to_mm", b.to_mm);
    }
    b.falloff = good ? (sf_falloff)falloff : SF_FALLOFF_SMOOTH;
    b.where = good ? (sf_paint_where)where : SF_PAINT_ALL;
    if (!good || sf_paint_select(s->cage, &b, s->weights, &touched) != SF_OK) {
        return fail(
            s, "a ball has at_mm, a capsule from_mm and to_mm, both a radius_mm above 0, and may "
               "have a strength (above 0, at most 1), a falloff (constant, linear, smooth, "
               "gaussian) and "
               "where (all, outside, inside).");
    }
    warn_of_air(s, touched);
    return EXIT_GOOD;
}

static exit_status select_what(const step *s)
{
    size_t count = sf_cage_get_view(s->cage).point_count;
    int which = which_key(s->says, selections, 4);
    for (size_t i = 0; i < count; i++) {
        s->weights[i] = which == 0 ? 1 : 0;
    }
    switch (which) {
    case 0:
        return json_is_true(json_object_get(s->says, "all")) ? EXIT_GOOD : fail(s, "all is true.");
    case 1:
        return select_points(s, json_object_get(s->says, "points"));
    case 2:
    case 3:
        return select_brush(s, json_object_get(s->says, selections[which]), which == 2);
    default:
        return fail(s, "it needs one selection: all, points, ball or capsule.");
    }
}

// ---------------------------------------------------------------------------------------------
// Actions
// ---------------------------------------------------------------------------------------------

static exit_status paint(const step *s, sf_paint_operation operation, const char *key)
{
    size_t channel = 0, changed = 0;
    double amount = 0;
    exit_status status = find_property(s, &channel);
    if (status != EXIT_GOOD) {
        return status;
    }
    if (!json_get_number(s->says, key, &amount) ||
        sf_paint_values(s->cage, channel, s->weights, operation, amount, NULL, &changed) != SF_OK) {
        return fail(s, operation == SF_PAINT_SMOOTH ? "smooth is a number from 0 to 1."
                                                    : "set and add are numbers.");
    }
    return EXIT_GOOD;
}

// A formula takes the place of a value as far as its point is selected. It is of places, so it
// wants a property that has a value at each.
static exit_status evaluate(const step *s)
{
    size_t channel = 0;
    char why[400];
    const char *text = json_string_value(json_object_get(s->says, "expression"));
    exit_status status = find_property(s, &channel);
    if (status != EXIT_GOOD) {
        return status;
    }
    sf_cage_view v = sf_cage_get_view(s->cage);
    if (text == NULL || v.channels[channel].indices != NULL) {
        return fail(s, "expression is a text, and of a property that jumps nowhere.");
    }
    expression *e = expression_read(text, why, sizeof why);
    if (e == NULL) {
        return fail(s, why);
    }
    double *values = malloc(v.point_count * sizeof *values);
    for (size_t i = 0; values != NULL && i < v.point_count; i++) {
        double old = v.channels[channel].values[i];
        double fresh = s->weights[i] > 0 ? expression_at(e, v.positions + 3 * i, old) : old;
        values[i] = old + s->weights[i] * (fresh - old);
    }
    sf_status set = values == NULL ? SF_ERR_MEMORY
                                   : sf_cage_set_values(s->cage, channel, 0, v.point_count, values);
    free(values);
    expression_free(e);
    return set == SF_OK
               ? EXIT_GOOD
               : fail(s, "the formula has no value at a point, or one outside the property's "
                         "bounds.");
}

// What became of points that were to move, by numbers that are good as such.
static exit_status moved(const step *s, sf_status status)
{
    switch (status) {
    case SF_OK:
        return EXIT_GOOD;
    case SF_ERR_MEMORY:
        return job_fail(s->job, EXIT_RESOURCE, "There is no memory for a step.");
    default:
        return fail(s, "it moves a point farther than 10^12 mm from 0, 0, 0.");
    }
}

static exit_status move(const step *s)
{
    double vector[3] = {0, 0, 0};
    if (!json_get_triple(s->says, "move", vector)) {
        return fail(s, "move is three numbers, mm.");
    }
    return moved(s, sf_paint_move(s->cage, s->weights, vector, NULL, NULL));
}

static exit_status smooth_shape(const step *s)
{
    double amount = 0;
    if (!json_get_number(s->says, "smooth_shape", &amount) || amount < 0 || amount > 1) {
        return fail(s, "smooth_shape is a number from 0 to 1.");
    }
    return moved(s, sf_paint_smooth(s->cage, s->weights, amount, NULL, NULL));
}

static exit_status act(const step *s)
{
    switch (which_key(s->says, actions, 6)) {
    case 0:
        return paint(s, SF_PAINT_SET, "set");
    case 1:
        return paint(s, SF_PAINT_ADD, "add");
    case 2:
        return paint(s, SF_PAINT_SMOOTH, "smooth");
    case 3:
        return evaluate(s);
    case 4:
        return move(s);
    case 5:
        return smooth_shape(s);
    default:
        return fail(s,
                    "it does one thing: set, add, smooth or expression to a property, or move or "
                    "smooth_shape.");
    }
}

static exit_status do_step(const step *s)
{
    if (!json_has_only(s->says, keys, sizeof keys / sizeof keys[0])) {
        return fail(s, "it has a key that is not known.");
    }
    if (json_object_get(s->says, "create") != NULL) {
        return create(s);
    }
    exit_status status = select_what(s);
    return status == EXIT_GOOD ? act(s) : status;
}

exit_status recipes_apply(cli_job *job, sf_cage *cage)
{
    json_t *root = NULL;
    const json_t *items = NULL;
    step s = {job, cage, NULL, 0, NULL};
    exit_status status = json_read_list(job, "--paint", job->options.paint, "libsf-paint", "steps",
                                        10000, &root, &items);
    if (status != EXIT_GOOD) {
        return status;
    }
    s.weights = malloc(sf_cage_get_view(cage).point_count * sizeof *s.weights);
    if (s.weights == NULL) {
        status = job_fail(job, EXIT_RESOURCE, "There is no memory for a selection.");
    }
    for (; status == EXIT_GOOD && s.number < json_array_size(items); s.number++) {
        s.says = json_array_get(items, s.number);
        status = do_step(&s);
    }
    free(s.weights);
    json_decref(root);
    return status;
}

#else

exit_status recipes_apply(cli_job *job, sf_cage *cage)
{
    (void)cage;
    return json_fail(job, EXIT_INPUT, "--paint", job->options.paint,
                     "this program reads no recipes; build it with jansson.");
}

#endif

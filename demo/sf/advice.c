// SPDX-License-Identifier: MIT
// How to look again at what was written. What hangs is a matter of voxels and of a rule, so whoever
// checks a mesh on others finds something else; and of two meshes the outer one alone is solid. The
// sentence has the whole command, to be copied.

#include "advice.h"

#include "output.h"
#include "stand_say.h"
#include "turned.h"
#include "values.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { WORDS_SIZE = 9000 };

static void add(char words[WORDS_SIZE], const char *before, const char *word)
{
    const char *quote = strpbrk(word, " \t\"'$&();<>|*?[]#~`\\") != NULL ? "\"" : "";
    size_t used = strlen(words);
    snprintf(words + used, WORDS_SIZE - used, "%s%s%s%s", before, quote, word, quote);
}

static void add_number(char words[WORDS_SIZE], const char *before, double number)
{
    char text[32];
    snprintf(text, sizeof text, "%.9g", number);
    add(words, before, text);
}

static void add_pitch(char words[WORDS_SIZE], const sf_lattice *l)
{
    double layer = sf_lattice_layer_height(l, 0);
    add_number(words, " --pitch ", l->pitch_x_mm);
    if (fabs(l->pitch_y_mm - l->pitch_x_mm) > 0 || fabs(layer - l->pitch_x_mm) > 0) {
        add_number(words, ",", l->pitch_y_mm);
        add_number(words, ",", layer);
    }
}

// What differs from what `sf check` does by itself.
static void add_rule(char words[WORDS_SIZE], const cli_options *asked, const part *p)
{
    sf_lattice lattice = sf_grid_lattice(p->grid);
    int is_oblong = fabs(lattice.pitch_y_mm - lattice.pitch_x_mm) > 0;
    double angle = values_angle_deg(asked);
    if (p->rule.kind != (is_oblong ? SF_RULE_SLACK : SF_RULE_OCTAGON)) {
        add(words, " --rule ", sf_rule_kind_name(p->rule.kind));
    }
    if (p->rule.kind != SF_RULE_BOX3 && fabs(angle - 45) > 0) {
        add_number(words, " --angle ", angle);
    }
    if (asked->bridge_mm[0] > 0) {
        add_number(words, " --bridge ", asked->bridge_mm[0]);
        add_number(words, ",", asked->bridge_mm[1]);
    }
    if (asked->given & OPTION_BED) {
        add_number(words, " --bed ", asked->bed_mm);
    }
}

void advice_check(cli_job *job, const part *p, const char *path, const char *inner)
{
    char words[WORDS_SIZE] = "", way[STAND_DIRECTION_SIZE];
    sf_lattice lattice = sf_grid_lattice(p->grid);
    add(words, "sf check ", path);
    if (output_kind_of(path) == OUTPUT_MESH) { // layers bring all of this
        if (inner != NULL) {
            add(words, " --inner ", inner);
        }
        if (job->options.up != AXIS_Z) {
            double up[3];
            turned_axis(job->options.up, up);
            add(words, " --up ", stand_direction(up, way));
        }
        add_pitch(words, &lattice);
        add_rule(words, &job->options, p);
    }
    report_text(job->report, "check", words);
    report_say(job->report, "To check it: %s", words);
}

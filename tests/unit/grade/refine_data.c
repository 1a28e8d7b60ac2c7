// SPDX-License-Identifier: MIT
// Why: another program's results. OpenSubdiv's regression baselines hold the surfaces of a cube and
// of a tent, with and without half sharp creases, after one to three steps, as points in an order
// of their own. The cube is refined here as a solid of one cell, whose boundary is compared, and as
// faces; the tent as faces. Asked: the same sets of points within 2e-6 (they are printed with nine
// digits of single precision).

#include "cages.h"

#include <sf/refine.h>

typedef struct obj {
    size_t points, faces;
    double xyz[2000][3];
    uint32_t corners[2000][4];
    size_t creases;
    sf_crease crease[16];
} obj;

static int obj_read(const char *name, obj *o)
{
    char path[1024], line[512];
    snprintf(path, sizeof path, "%s/cages/%s.obj", getenv("SF_DATA"), name);
    FILE *file = fopen(path, "rb");
    memset(o, 0, sizeof *o);
    if (file == NULL) {
        printf("# %s cannot be read\n", path);
        return 0;
    }
    while (fgets(line, sizeof line, file) != NULL) {
        double *p = o->xyz[o->points];
        uint32_t *c = o->corners[o->faces];
        sf_crease *t = &o->crease[o->creases];
        if (sscanf(line, "v %lf %lf %lf", &p[0], &p[1], &p[2]) == 3) {
            o->points++;
        } else if (sscanf(line, "f %u/%*u/%*u %u/%*u/%*u %u/%*u/%*u %u", &c[0], &c[1], &c[2],
                          &c[3]) == 4) {
            o->faces++;
        } else if (sscanf(line, "t crease 2/1/0 %u %u %lf", &t->points[0], &t->points[1],
                          &t->sharpness) == 3) {
            o->creases++;
        }
    }
    fclose(file);
    return 1;
}

// The cage of an OBJ's faces. Corners of an open mesh are sharp: the files ask for that.
static test_cage faces_of(const obj *o)
{
    test_cage c = test_cage_begin(2, o->points, o->faces, 4);
    int uses[2000] = {0};
    memcpy(c.positions, o->xyz, 3 * o->points * sizeof(double));
    for (size_t i = 0; i < 4 * o->faces; i++) {
        c.corners[i] = o->corners[i / 4][i % 4] - 1;
        uses[c.corners[i]]++;
    }
    for (uint32_t i = 0; i < o->points; i++) {
        if (uses[i] == 1) {
            c.sharp[c.sharps].point = i;
            c.sharp[c.sharps++].sharpness = SF_SHARP;
        }
    }
    c.creases = o->creases;
    memcpy(c.crease, o->crease, sizeof o->crease);
    return c;
}

static test_cage solid_of(const obj *o)
{
    static const uint32_t corners[8] = {6, 7, 5, 4, 0, 1, 3, 2};
    test_cage c = test_cage_begin(3, 8, 1, 8);
    memcpy(c.positions, o->xyz, 24 * sizeof(double));
    memcpy(c.corners, corners, sizeof corners);
    c.creases = o->creases;
    memcpy(c.crease, o->crease, sizeof o->crease);
    return c;
}

// Mark the points of a view that lie on its boundary; in dimension 2 all.
static size_t mark_outside(const sf_cage_view *v, unsigned char *outside)
{
    memset(outside, v->dimension == 2, v->point_count);
    if (v->dimension == 2) {
        return v->point_count;
    }
    // Of one cell cut into pieces: a face is inside where its four points are another piece's, too.
    static const int faces[6][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                    {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    size_t count = 0;
    for (size_t i = 0; i < 6 * v->cell_count; i++) {
        const int *f = faces[i % 6];
        const uint32_t *cell = v->corners + 8 * (i / 6);
        int others = 0;
        for (size_t j = 0; j < v->cell_count; j++) {
            int found = 0;
            for (int k = 0; k < 32; k++) {
                found += v->corners[8 * j + (size_t)(k % 8)] == cell[f[k / 8]];
            }
            others += j != i / 6 && found == 4;
        }
        for (int k = 0; others == 0 && k < 4; k++) {
            count += !outside[cell[f[k]]];
            outside[cell[f[k]]] = 1;
        }
    }
    return count;
}

// The farthest that a point of one set is from the other's nearest.
static double farthest(size_t count, const double *from, const unsigned char *used, const obj *to)
{
    double worst = 0;
    for (size_t i = 0; i < count; i++) {
        double best = INFINITY;
        for (size_t j = 0; used[i] && j < to->points; j++) {
            best = fmin(best, fmax(fmax(fabs(from[3 * i] - to->xyz[j][0]),
                                        fabs(from[3 * i + 1] - to->xyz[j][1])),
                                   fabs(from[3 * i + 2] - to->xyz[j][2])));
        }
        worst = used[i] ? fmax(worst, best) : worst;
    }
    return worst;
}

static void compare(const test_cage *c, const char *name)
{
    static obj expected;
    sf_cage *cage = test_cage_make(c);
    sf_refine_options options = sf_refine_options_default();
    options.steps = 3;
    sf_refinement *r = NULL;
    CHECK_EQ(sf_refine(cage, &options, NULL, NULL, &r), SF_OK);
    for (uint32_t step = 1; step <= 3; step++) {
        char file[64];
        sf_cage_view v;
        static unsigned char outside[10000];
        snprintf(file, sizeof file, "%s_level%u", name, step - 1);
        CHECK_EQ(sf_refinement_get_view(r, step, &v), SF_OK);
        CHECK(obj_read(file, &expected));
        CHECK_EQ(mark_outside(&v, outside), expected.points);
        double worst = farthest(v.point_count, v.positions, outside, &expected);
        printf("# %s as %s: %zu points, at most %.2g apart\n", file,
               c->dimension == 3 ? "a solid" : "faces", expected.points, worst);
        CHECK(worst <= 2e-6);
    }
    sf_refinement_destroy(r);
    sf_cage_destroy(cage);
}

static void a_cube_is_opensubdivs(void)
{
    static const char *names[2] = {"catmark_cube", "catmark_cube_creases0"};
    static obj o;
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA does not name the folder of models");
    }
    for (int i = 0; i < 2; i++) {
        CHECK(obj_read(names[i], &o));
        test_cage solid = solid_of(&o), faces = faces_of(&o);
        compare(&solid, names[i]);
        compare(&faces, names[i]);
        test_cage_free(&solid);
        test_cage_free(&faces);
    }
}

static void a_tent_is_opensubdivs(void)
{
    static obj o;
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA does not name the folder of models");
    }
    CHECK(obj_read("catmark_tent_creases0", &o));
    test_cage faces = faces_of(&o);
    CHECK(faces.sharps == 4 && faces.creases == 2);
    compare(&faces, "catmark_tent_creases0");
    test_cage_free(&faces);
}

int main(void)
{
    TEST(a_cube_is_opensubdivs);
    TEST(a_tent_is_opensubdivs);
    return test_finish();
}

// SPDX-License-Identifier: MIT
// verify: is a stack of pictures support-free? Judged voxel by voxel, without code of libsf.
//     verify STACK_DIR [--corrupt N --seed S]  exit 0 support-free, 1 not, 3 no such stack; flip N
// different voxels, each alone, judge by what is near and by whole layers, print x y z and 1 or 0.
// Layers are layer_00000.png ... (1-bit grey, not black is solid, top row largest y), the rule is
// in stack.json. A voxel must have one in the layer below that may carry it: one of nine (box3),
// within the step's ellipse (disk), or within its octagon: with P_k the reach from layer 0 to k,
//     |dx| <= A, |dy| <= A, |dx| + |dy| <= A + B,  A = a_{k+1} - a_k, B = b_{k+1} - b_k, where
//     a_k = floor(cos(22.5 degrees) P_k + 1/2)   b_k = floor(a_k / (1 + sqrt 2) + 1/2)
// A reach is height * tan(angle) / pitch, forgiven a part in 2^40, rounded down to 1/2^24 voxel.
// The bed layer, the first with matter unless the rule names one, needs nothing below.
#include <jansson.h>
#include <math.h>
#include <spng.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static long layer;                                 // voxels of a picture
static int nx, ny, nz, bed_given = -1, widest = 1; // no step reaches farther, in voxels
static char kind;                                  // 'b'ox3, 'o'ctagon, 'd'isk
static double (*step)[4];     // from each layer: reach along x, along y; A and A + B
static unsigned char *voxels; // pictures, one after the other; then: which were drawn to flip

static int solid(int x, int y, int z)
{
    int inside = x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz;
    return inside && voxels[z * layer + (ny - 1 - y) * nx + x] != 0;
}

// Whether a voxel of layer k may carry one of layer k + 1 that lies (dx, dy) beside it.
static int reaches(int dx, int dy, int k)
{
    double *s = step[k], u = dx * s[1], v = dy * s[0], r = s[0] * s[1];
    return kind == 'd' ? u * u + v * v <= r * r
                       : abs(dx) <= s[2] && abs(dy) <= s[2] && abs(dx) + abs(dy) <= s[3];
}

static int carried(int x, int y, int z)
{
    int side = 2 * widest + 1, found = solid(x, y, z - 1);
    for (int i = 0; z > 0 && !found && i < side * side; i++) {
        int dx = i % side - widest, dy = i / side - widest;
        found = solid(x + dx, y + dy, z - 1) && reaches(dx, dy, z - 1);
    }
    return found;
}

static int bed(void)
{
    long v = 0;
    for (; v < layer * nz && !voxels[v]; v++) {
    }
    return bed_given < 0 ? (int)(v / layer) : bed_given;
}

// Place of the first voxel of z0 <= z < z1 within r of column (x, y) that nothing carries, or -1.
static long first_fault(int x, int y, int r, int z0, int z1)
{
    for (int z = z0, rests = bed(); z < z1 && z < nz; z++) {
        for (int v = y > r ? y - r : 0; v < ny && v <= y + r && z != rests; v++) {
            for (int u = x > r ? x - r : 0; u < nx && u <= x + r; u++) {
                if (solid(u, v, z) && !carried(u, v, z)) {
                    return z * layer + (ny - 1 - v) * nx + u;
                }
            }
        }
    }
    return -1;
}

static int corrupt(long count, unsigned long long seed)
{
    long end = layer * nz, wrong = 0;
    for (long i = 0; i < count && i < end; i++) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        long v = (long)((seed >> 8) % (unsigned long long)end), stride = seed >> 63 ? layer : 1;
        while (voxels[end + v] ||
               (seed >> 59 && v + stride < end && !voxels[v] == !voxels[v + stride])) {
            v = voxels[end + v] ? (v + 1) % end : v + stride; // mostly to a surface: it matters
        }
        voxels[end + v] = 1;
        int x = (int)(v % nx), y = ny - 1 - (int)(v / nx % ny), z = (int)(v / layer), old = bed();
        int before = voxels[v], top = (z > old ? z : old) + 2, all = nx + ny;
        voxels[v] = !before;
        int same = bed() == old;
        int good = first_fault(x, y, same ? widest : all, z, same ? z + 2 : top) < 0;
        wrong += good != (first_fault(x, y, all, z, top) < 0);
        voxels[v] = (unsigned char)before;
        printf("%d %d %d %d\n", x, y, z, good);
    }
    return wrong > 0;
}

static json_t *document;

static int load(const char *folder)
{
    char name[4096], *format, *word;
    struct spng_ihdr head;
    static spng_ctx *png;
    double x, y, height = 0, angle = 45, sum = 0;
    static json_t *heights, *bed_layer;
    snprintf(name, sizeof name, "%s/stack.json", folder);
    if (json_unpack(document = json_load_file(name, 0, NULL),
                    "{s:s,s:{s:i,s:i,s:i,s:[F,F],s?F,s?o},s:{s:s,s?F,s?o}}", "format", &format,
                    "lattice", "nx", &nx, "ny", &ny, "nz", &nz, "pitch_mm", &x, &y, "layer_mm",
                    &height, "heights_mm", &heights, "rule", "kind", &word, "angle_deg", &angle,
                    "bed_layer", &bed_layer) ||
        strcmp(format, "libsf-stack") || !strchr("bdo", kind = *word) || nx < 1 || ny < 1 ||
        nz < 1 || (step = calloc((size_t)nz, sizeof *step)) == NULL ||
        (voxels = calloc((size_t)(layer = (long)nx * ny), 2 * (size_t)nz)) == NULL) {
        return 0;
    }
    bed_given = json_is_integer(bed_layer) ? (int)json_integer_value(bed_layer) : -1;
    double slope = tan(angle * acos(-1) / 180) * ldexp(1 + ldexp(1, -40), 24), a = 0, b = 0;
    for (int z = 0; z < nz; z++) {
        double mm = heights ? json_number_value(json_array_get(heights, (size_t)z)) : height;
        double along_x = ldexp(floor(mm * slope / x), -24);
        double p = heights ? ldexp(floor((sum += mm) * slope / x), -24) : (z + 1) * along_x;
        double a1 = floor(cos(acos(-1) / 8) * p + 0.5), b1 = floor(a1 / (1 + sqrt(2)) + 0.5);
        double square = kind == 'b' ? 1 : a1 - a, more = kind == 'b' ? 1 : b1 - b;
        double s[4] = {along_x, ldexp(floor(mm * slope / y), -24), square, square + more};
        memcpy(step[z], s, sizeof s);
        widest = (int)fmax(widest, 1 + fmax(s[0], s[1]));
        a = a1;
        b = b1;
        snprintf(name, sizeof name, "%s/layer_%05d.png", folder, z);
        FILE *file = fopen(name, "rb");
        png = spng_ctx_new(0);
        if (file == NULL || spng_set_png_file(png, file) || spng_get_ihdr(png, &head) ||
            head.width != (unsigned)nx || head.height != (unsigned)ny || head.bit_depth != 1 ||
            spng_decode_image(png, &voxels[z * layer], (size_t)layer, SPNG_FMT_G8, 0)) {
            return 0;
        }
        spng_ctx_free(png);
        fclose(file);
    }
    return 1;
}

int main(int argc, char **argv)
{
    int loaded = (argc == 2 || argc == 6) && load(argv[1]);
    json_decref(document);
    if (!loaded) {
        fprintf(stderr, "verify STACK_DIR [--corrupt N --seed S]: no such stack, or no rule\n");
        return 3;
    }
    long v = first_fault(0, 0, nx + ny, 0, nz);
    printf(v < 0 ? "support-free\n" : "not support-free: nothing carries x %ld, y %ld, z %ld\n",
           v % nx, ny - 1 - v / nx % ny, v / layer);
    return v >= 0 ? 1 : argc == 6 ? corrupt(atol(argv[3]), strtoull(argv[5], NULL, 10)) : 0;
}

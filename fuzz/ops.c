// SPDX-License-Identifier: MIT
// Fuzz target: a string of operations on a small grid, each held against a byte for each voxel.
//
// The oracle shares no thought with the library: it looks at one voxel after the other and at the
// nine below it. After every operation all voxels are compared, and counts, bounds, the check's
// verdict and what is unsupported with what the oracle counts.

#include "target.h"

#include "draw.h"

#include <sf/sf.h>

enum { X = 70, Y = 4, Z = 4, OPERATIONS = 10 };

typedef struct model {
    uint32_t nx, ny, nz;
    uint8_t at[Z][Y][X];
} model;

static int is_carried(const model *m, uint32_t x, uint32_t y, uint32_t z)
{
    for (int dy = -1; dy <= 1; dy++) {
        for (int dx = -1; dx <= 1; dx++) {
            int64_t px = (int64_t)x + dx, py = (int64_t)y + dy;
            if (px >= 0 && py >= 0 && px < m->nx && py < m->ny && m->at[z - 1][py][px]) {
                return 1;
            }
        }
    }
    return 0;
}

static uint32_t bed_of(const model *m)
{
    for (uint32_t z = 0; z < m->nz; z++) {
        for (uint32_t y = 0; y < m->ny; y++) {
            for (uint32_t x = 0; x < m->nx; x++) {
                if (m->at[z][y][x]) {
                    return z;
                }
            }
        }
    }
    return SF_BED_AUTO;
}

// Takes away what nothing carries, or counts it. Layers at the bed and below rest on it.
static uint64_t hanging(model *m, int trims)
{
    uint64_t count = 0;
    uint32_t bed = bed_of(m);
    for (uint32_t z = bed == SF_BED_AUTO ? m->nz : bed + 1; z < m->nz; z++) {
        for (uint32_t y = 0; y < m->ny; y++) {
            for (uint32_t x = 0; x < m->nx; x++) {
                if (m->at[z][y][x] && !is_carried(m, x, y, z)) {
                    count++;
                    m->at[z][y][x] = trims ? 0 : 1;
                }
            }
        }
    }
    return count;
}

static void compare(model *m, const sf_grid *grid)
{
    uint64_t count = 0;
    for (uint32_t z = 0; z < m->nz; z++) {
        sf_slice s = sf_grid_slice(grid, z);
        for (uint32_t y = 0; y < m->ny; y++) {
            for (uint32_t x = 0; x < m->nx; x++) {
                must((s.words[y * s.stride + x / 64] >> x % 64 & 1) == m->at[z][y][x],
                     "each voxel is as the oracle has it");
                count += m->at[z][y][x];
            }
        }
    }
    must(sf_grid_popcount(grid) == count, "as many are solid");
    sf_check_report report;
    sf_check_options options = sf_check_options_default();
    must(sf_grid_check(grid, &options, NULL, NULL, &report, NULL) == SF_OK, "a check runs");
    uint64_t lost = hanging(m, 0);
    must(report.unsupported_voxels == lost && report.support_free == (lost == 0),
         "the check counts what the oracle counts");
}

// One operation of a slice of two: a layer becomes what two layers are together.
static void combine(model *m, sf_grid *grid, draw *d, uint32_t how)
{
    uint32_t to = draw_byte(d) % m->nz, a = draw_byte(d) % m->nz, b = draw_byte(d) % m->nz;
    sf_slice out = sf_grid_slice(grid, to), p = sf_grid_slice(grid, a), q = sf_grid_slice(grid, b);
    sf_status status = how == 0   ? sf_slice_and(out, p, q)
                       : how == 1 ? sf_slice_or(out, p, q)
                       : how == 2 ? sf_slice_xor(out, p, q)
                                  : sf_slice_subtract(out, p, q);
    must(status == SF_OK, "layers of one grid go together");
    for (uint32_t y = 0; y < m->ny; y++) {
        for (uint32_t x = 0; x < m->nx; x++) {
            uint8_t v = m->at[a][y][x], w = m->at[b][y][x];
            m->at[to][y][x] = (uint8_t)(how == 0   ? v & w
                                        : how == 1 ? v | w
                                        : how == 2 ? v ^ w
                                                   : v & !w);
        }
    }
}

static void fill(model *m, sf_grid *grid, draw *d)
{
    uint32_t z = draw_byte(d) % m->nz, value = draw_below(d, 4) != 0;
    sf_rect r = {draw_byte(d) % m->nx, draw_byte(d) % m->ny, 0, 0};
    r.x1 = r.x0 + draw_byte(d) % (m->nx - r.x0 + 1);
    r.y1 = r.y0 + draw_byte(d) % (m->ny - r.y0 + 1);
    must(sf_slice_fill(sf_grid_slice(grid, z), r, (int)value) == SF_OK, "a box within is filled");
    for (uint32_t y = r.y0; y < r.y1; y++) {
        for (uint32_t x = r.x0; x < r.x1; x++) {
            m->at[z][y][x] = (uint8_t)value;
        }
    }
}

// A layer becomes another one, grown or shrunk by one voxel all around; what is outside is empty.
static void morph(model *m, sf_grid *grid, draw *d, int grows)
{
    uint32_t to = draw_byte(d) % m->nz, from = draw_byte(d) % m->nz;
    sf_element box = sf_element_box3();
    uint8_t next[Y][X];
    for (uint32_t y = 0; y < m->ny; y++) {
        for (uint32_t x = 0; x < m->nx; x++) {
            int any = 0, all = 1;
            for (int i = 0; i < 9; i++) {
                int64_t px = (int64_t)x + i % 3 - 1, py = (int64_t)y + i / 3 - 1;
                int solid = px >= 0 && py >= 0 && px < m->nx && py < m->ny && m->at[from][py][px];
                any |= solid;
                all &= solid;
            }
            next[y][x] = (uint8_t)(grows ? any : all);
        }
    }
    sf_slice out = sf_grid_slice(grid, to), in = sf_grid_slice(grid, from);
    sf_status status = grows ? sf_slice_dilate(out, in, &box, SF_BORDER_EMPTY)
                             : sf_slice_erode(out, in, &box, SF_BORDER_EMPTY);
    if (status == SF_OK) { // one that is its own source may be refused
        memcpy(m->at[to], next, sizeof next);
    }
    must(status == SF_OK || to == from, "another layer is grown or shrunk");
}

static void operate(model *m, sf_grid *grid, draw *d)
{
    uint32_t what = draw_below(d, 9);
    if (what < 4) {
        combine(m, grid, d, what);
    } else if (what < 6) {
        fill(m, grid, d);
    } else if (what < 8) {
        morph(m, grid, d, what == 6);
    } else {
        sf_rule rule = sf_rule_box3();
        sf_trim_report report;
        must(sf_grid_trim(grid, &rule, SF_BED_AUTO, NULL, &report) == SF_OK, "any grid is trimmed");
        must(report.removed_voxels == hanging(m, 1), "trimming removes what the oracle removes");
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    draw d = {data, size, 0, 1};
    model m;
    memset(&m, 0, sizeof m);
    uint32_t wide = draw_byte(&d); // small most of the time, and then as wide as a word
    m.nx = 1 + (wide < 200 ? wide % 9 : 54 + wide % 16);
    m.ny = 1 + draw_byte(&d) % Y;
    m.nz = 1 + draw_byte(&d) % Z;
    sf_lattice lattice = {m.nx, m.ny, m.nz, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *grid = NULL;
    must(sf_grid_create(&lattice, NULL, &grid) == SF_OK, "a small grid is made");
    for (int i = 0; i < OPERATIONS && d.at < d.size; i++) {
        operate(&m, grid, &d);
        compare(&m, grid);
    }
    sf_grid_destroy(grid);
    return 0;
}

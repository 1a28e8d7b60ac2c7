// SPDX-License-Identifier: MIT
// Is a stack what its certificate says? Without code of libsf; formulas: docs/certificate.md.
#include <jansson.h>
#include <math.h>
#include <spng.h>
#include <string.h>
#define TURN(x, n) ((x) >> (n) | (x) << (32 - (n)))
#define NOT(it, ...)                                                                               \
    if (it) return snprintf(found, sizeof found, __VA_ARGS__), 0
#define GET json_object_get
#define USAGE "usage: sf-verify LAYERS CERTIFICATE (status 0: verified, 1: not, 3: unreadable)\n"
#define Q24(reach) floor((reach)*0x1p24 * (1 + 0x1p-40))
#define OWN(i) (*at(x + (i)*dx, y + (i)*dy, k) > 0 && *at(x + (i)*dx, y + (i)*dy, k) < BRIDGED)
enum { WAITS = -1, FREE = -2, BRIDGED = 999 }; // codes beside 0: empty, and 1 + slack: carried
static const char *const words[] = {"box3", "octagon",  "disk", "slack", "check",
                                    "trim", "preserve", "grow", "repair"};
static int nx, ny, nz, top, wide, units[2], spans[4], anchors[4]; // top: the best code
static long row, layer, area, bed; // bytes of a row and of a picture, voxels of a layer
static unsigned char *bits;        // pictures, one after the other
static short *codes, none;
static double (*step)[6], pitch[4], mm; // in q24: reach from layer 0 and of a step; what is listed
static json_t *stack, *heights, *given, *mine, *layers;        // two certificates; what one lists
static char kind, found[256], path[4096], all[(1 << 28) + 1];  // a letter of words; what is said
static char *sha256(const unsigned char *bytes, size_t size) { // FIPS 180-4
    static char hex[65];
    uint32_t k[64], h[8], w[64] = {0}, v[8];
    for (int n = 2, i = 0, d = 2; i < 64; i += d == n++, d = 2) { // fractions of primes' roots
        while (n % d != 0) d++;
        k[i] = fmod(cbrt(n), 1) * 0x1p32, h[i % 8] = i < 8 ? fmod(sqrt(n), 1) * 0x1p32 : h[i % 8];
    }
    for (size_t at = 0, end = (size + 72) / 64 * 64; at < end; at += 64) {
        for (size_t j = at; j < at + 64; j++) {
            uint64_t pad = j == size ? 128 : j + 8 < end ? 0 : size * 8ull >> 8 * (end - 1 - j);
            w[(j - at) / 4] = w[(j - at) / 4] << 8 | (j < size ? bytes[j] : pad & 255);
        }
        memcpy(v, h, sizeof v);
        for (int i = 0; i < 64; i++) {
            uint32_t a = v[0], e = v[4], p = w[(i + 49) % 64], q = w[(i + 62) % 64];
            p = TURN(p, 7) ^ TURN(p, 18) ^ p >> 3, q = TURN(q, 17) ^ TURN(q, 19) ^ q >> 10;
            if (i > 15) w[i] = w[i - 16] + p + w[i - 7] + q;
            p = TURN(e, 6) ^ TURN(e, 11) ^ TURN(e, 25), q = TURN(a, 2) ^ TURN(a, 13) ^ TURN(a, 22);
            p += v[7] + ((e & v[5]) ^ (~e & v[6])) + k[i] + w[i];
            q += (a & v[1]) ^ (a & v[2]) ^ (v[1] & v[2]);
            memmove(v + 1, v, 7 * sizeof *v), v[4] += p, v[0] = p + q;
        }
        for (int i = 0; i < 8; i++) snprintf(hex + 8 * i, 9, "%08x", (unsigned)(h[i] += v[i]));
    }
    return hex;
}
static short *at(long x, long y, long k) { // the code of a voxel
    return x >= 0 && y >= 0 && x < nx && y < ny ? codes + k * area + y * nx + x : &none;
}
static int load(const char *folder) {
    snprintf(path, sizeof path, "%s/stack.json", folder);
    int bad = json_unpack(stack = json_load_file(path, JSON_REJECT_DUPLICATES, NULL),
                          "{s{sisisis[FF]s?Fs?o}}", "lattice", "nx", &nx, "ny", &ny, "nz", &nz,
                          "pitch_mm", pitch, pitch + 1, "layer_mm", &mm, "heights_mm", &heights);
    row = (nx + 7) / 8, layer = row * ny, area = (long)nx * ny;
    bad = bad || nz < 1 || !(bits = calloc(layer, nz)) || !(step = calloc(nz + 1l, sizeof *step)) ||
          !(codes = calloc(area, nz * sizeof *codes));
    for (int z = 0; !bad && z < nz; z++) {
        struct spng_ihdr h;
        snprintf(path, sizeof path, "%s/layer_%05d.png", folder, z);
        FILE *file = fopen(path, "rb");
        spng_ctx *png = spng_ctx_new(0);
        bad = !file || spng_set_png_file(png, file) || spng_get_ihdr(png, &h) || h.color_type ||
              h.bit_depth > 1 || h.width != (unsigned)nx || h.height != (unsigned)ny ||
              spng_decode_image(png, bits + z * layer, layer, SPNG_FMT_PNG, 0);
        for (long x = 0, y = 0; y < ny; y += ++x == nx, x %= nx)
            *at(x, y, z) = -(bits[z * layer + (ny - 1 - y) * row + x / 8] >> (7 - x % 8) & 1);
        spng_ctx_free(png), bad = (file && fclose(file)) || bad;
    }
    return !bad;
}
// Units that a voxel of layer k pays to carry one that is (dx, dy) off in the layer above; or -1.
static int price(int dx, int dy, int k) {
    double *s = step[k], x = abs(dx), y = abs(dy), q = kind == 's' ? 0x1p24 : -256; // up or down
    double e = 16 * (q > 0), u = units[0], v = units[1], far = 5 * fmax(u * u, v * v);
    double rx = ceil((s[2] - e) / q) * q * 0x1p-24, ry = ceil((s[3] - e) / q) * q * 0x1p-24;
    int may = x <= rx && y <= ry && x * x * ry * ry + y * y * rx * rx <= rx * rx * ry * ry;
    may = kind == 's' ? may || x * x * u * u + y * y * v * v <= far : may;
    may = strchr("bo", kind) ? x <= s[4] && y <= s[4] && x + y <= s[5] : may;
    return may ? ceil(sqrt(x * x * u * u + y * y * v * v)) : -1;
}
static void make_numbers(double tangent, double span, double anchor) { // top > 255: no such rule
    double a = 0, b = 0, sum = 0, lost = 0, high = 0, least = fmin(pitch[0], pitch[1]);
    int tall = wide = units[0] = units[1] = 0, u = 254;
    for (int k = 0; k < nz; k++) {
        double *s = step[k], *up = step[k + 1], a0 = a, b0 = b;
        if (heights) mm = json_number_value(json_array_get(heights, k));
        lost += sum >= mm ? sum - (sum + mm) + mm : mm - (sum + mm) + sum, sum += mm;
        for (int i = 0; i < 2; i++) {
            s[i + 2] = Q24(mm * tangent / pitch[i]);
            up[i] = heights ? Q24((sum + lost) * tangent / pitch[i]) : s[i] + s[i + 2];
            if (kind == 's') s[i + 2] = up[i] - s[i];
            wide = fmin(fmax(wide, s[i + 2] * 0x1p-24 + 3 * pitch[!i] / least), 300);
        }
        a = floor(*up * floor(cos(acos(-1) / 8) * 0x1p32) * 0x1p-56 + 0.5);
        b = floor(a * floor((sqrt(2) - 1) * 0x1p32) * 0x1p-32 + 0.5);
        s[4] = kind == 'b' ? 1 : kind == 'o' ? a - a0 : s[2];
        s[5] = kind == 'b' ? 2 : kind == 'o' ? a - a0 + b - b0 : s[3];
        if (k + 1 < nz && mm > high) high = mm, tall = k;
    }
    for (top = kind == 's' ? 256 : 1; u > 3 && top > 255; u--) {
        for (int i = top = 0; i < 2; i++) units[i] = -floor(-pitch[i] / least * u * (1 - 0x1p-40));
        for (int i = 0; i < wide * wide; i++) top = fmax(top, 1 + price(i % wide, i / wide, tall));
    }
    pitch[2] = pitch[3] = sqrt(pitch[0] * pitch[0] + pitch[1] * pitch[1]);
    for (int i = 0; i < 4; i++) spans[i] = floor(span / pitch[i] + 0x1p-20);
    for (int i = 0; i < 4; i++) anchors[i] = -floor(-anchor / pitch[i] + 0x1p-20);
}
// Look at the listed runs of layer k: what waits there becomes `as`. Returns 0 where one is none.
static int take(json_t *l, size_t *i, int k, int as, json_int_t *voxels) {
    int good = 1, n, d, x, y, z;
    while (good && !json_unpack(json_array_get(l, *i), "[iiiii!]", &z, &d, &y, &x, &n) && z == k) {
        long dx = d == 3 ? -1 : d != 1, dy = d > 0;
        good = ++*i && n > 0 && (as == FREE ? d == 0 : d >= 0 && d < 4 && n <= spans[d]);
        for (int j = 0; good && as == BRIDGED && (j < anchors[d] || j == 0); j++)
            good = OWN(n + j) && OWN(-1 - j);
        for (short *c; good && n > 0; n--, x += dx, y += dy) {
            good = *(c = at(x, y, k)) && (as == BRIDGED || *c == WAITS);
            if (*c == WAITS) *c = as, ++*voxels;
        }
    }
    return good;
}
static int judge(json_t *exempt, json_t *bridges) { // finds the codes of all voxels, layer by layer
    size_t next[2] = {0, 0};
    for (int k = 0, i = units[0] > units[1], side = 2 * wide + 1; k < nz; k++) {
        double *s = step[k ? k - 1 : nz], from = s[i] * units[i] * 0x1p-24;
        double gain = floor(from + s[i + 2] * units[i] * 0x1p-24) - floor(from);
        json_int_t solid = 0, free = 0, held = 0, a = s[4], b = s[5], c = gain;
        int good = take(exempt, next, k, FREE, &free);
        for (long v = k * area; v < (k + 1) * area; v++) {
            short was = codes[v], best = k == bed ? top : was == FREE;
            for (int j = -1; was && k && k > bed && best < top && j < side * side; j++) {
                int dx = j < 0 ? 0 : j % side - wide, dy = j < 0 ? 0 : j / side - wide, p;
                int u = *at(v % nx + dx, v % area / nx + dy, k - 1);
                if (u && (p = price(dx, dy, k - 1)) >= 0)
                    best = fmax(best, fmin(top, u + gain - p));
            }
            solid += was != 0, codes[v] = was ? best > 0 ? best : WAITS : 0;
        }
        NOT(!good || !take(bridges, next + 1, k, BRIDGED, &held), "layer %d: a run is none", k);
        for (long v = k * area; v < (k + 1) * area; v++) {
            NOT(codes[v] == WAITS, "nothing carries (%ld, %ld, %d)", v % nx, v % area / nx, k);
            if (codes[v] == BRIDGED) codes[v] = 1;
        }
        json_array_append_new(layers, json_pack("[IIIIII]", solid, free, held, a, b, c));
    }
    return next[0] == json_array_size(exempt) && next[1] == json_array_size(bridges);
}
static int verify(const char *text, size_t size) {
    char tail[99], *name, *act, *from, *to, *of;
    double angle = 0, tangent = 0, span = 0, anchor = 0;
    json_int_t more, less, was, is = 0, rule = 3, o = 8;
    json_t *free, *gaps, *rests, *c = given = json_loadb(text, size, JSON_REJECT_DUPLICATES, NULL);
    json_t *said = GET(stack, "rule"), *asked = GET(c, "rule");
    sprintf(tail, "  \"digest\": \"%s\"\n}\n", sha256((void *)text, size < 81 ? 0 : size - 81));
    NOT(size < 81 || memcmp(text + size - 81, tail, 81), "it is not as it was written");
    NOT(json_unpack(c, "{s{ss}s{sssIsI!}s{sssI!}sosos{sss?Fs?Fs?[FF!]so!}}", "output", "sha256",
                    &of, "operation", "name", &act, "added", &more, "removed", &less, "input",
                    "sha256", &from, "voxels", &was, "exempt", &free, "bridges", &gaps, "rule",
                    "kind", &name, "angle_rad", &angle, "tangent", &tangent, "bridge_mm", &span,
                    &anchor, "bed_layer", &rests),
        "a field is of another kind");
    NOT(strcmp(of, to = sha256(bits, layer * nz)), "it is of other layers than these");
    json_object_del(said, "angle_deg"), json_object_set(said, "tangent", GET(asked, "tangent"));
    if (json_number_value(GET(said, "phase_layer")) == 0) json_object_del(said, "phase_layer");
    NOT(json_is_object(said) && !json_equal(said, asked), "the stack names another rule");
    while (rule >= 0 && (strcmp(name, words[rule]) || (rule == 1 && *pitch != pitch[1]))) rule--;
    while (o > 3 && strcmp(act, words[o])) o--;
    kind = *name, layers = json_array(), make_numbers(tangent, span, anchor);
    NOT(rule < 0 || top > 255 || (rule && fabs(tan(angle) / tangent - 1) > 1e-15), "no such rule");
    for (long v = bed = nz * area; v-- > 0; is += codes[v] != 0) bed = codes[v] ? v : bed;
    bed = json_is_null(rests) ? bed / area : json_integer_value(rests);
    if (!judge(free, gaps)) return 0;
    NOT(o < 4 || (more && o < 7) || (less && (o == 4 || o == 7)) || was + more - less != is ||
            strspn(from, "0123456789abcdef") != 64 || (more || less) == !strcmp(from, to),
        "its input is none");
    mine = json_pack("{sssis{sssI}sOs{sisis[iii]s[iii]s[iii]}sO}", "format", "libsf-certificate",
                     "version", 1, "output", "sha256", to, "voxels", is, "lattice",
                     GET(stack, "lattice"), "numbers", "phase", 0, "bed", (int)bed, "slack",
                     units[0], units[1], top > 1 ? top - 1 : 0, "spans", spans[0], spans[1],
                     spans[2], "anchors", anchors[0], anchors[1], anchors[2], "layers", layers);
    json_object_update_missing(mine, c);
    NOT(!json_equal(mine, c) || json_object_size(c) != 12, "the stack shows otherwise");
    return sprintf(found, "%d layers of %d x %d voxels, rule %s", nz, nx, ny, name);
}
int main(int argc, char **argv) {
    int help = argc == 2 && (!strcmp(argv[1], "--help") || !strcmp(argv[1], "-h"));
    if (argc != 3) return fputs(USAGE, help ? stdout : stderr), help ? 0 : 2;
    FILE *file = load(argv[1]) ? fopen(strncpy(path, argv[2], sizeof path - 1), "rb") : NULL;
    size_t size = file ? fread(all, 1, sizeof all, file) : 0;
    const char *why = size ? "it is larger than 256 MiB" : "it cannot be read";
    if (size % sizeof all == 0) return fprintf(stderr, "sf-verify: %s: %s\n", path, why), 3;
    int good = verify(all, size);
    json_decref(given), json_decref(mine), json_decref(layers), json_decref(stack);
    return printf("%s: %s\n", good ? "verified" : "not verified", found), !good;
}

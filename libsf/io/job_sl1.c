// SPDX-License-Identifier: MIT
// SL1 in: a zip archive of config.ini and a PNG for each layer.
//
// Layers are the pictures at the archive's root whose names are one text and a number, from 0 on:
// part00000.png, part00001.png. Pictures in folders are thumbnails. config.ini says how thick a
// layer is, and how many there are (numSlow and numFast together), so a job that lost its end is
// not taken for a shorter one. prusaslicer.ini, where there is one, says how large the display is
// and how thick the first layer.

#include "base/memory.h"
#include "base/status.h"
#include "io/job.h"
#include "io/picture.h"

#include <string.h>

#if defined(SF_HAVE_SPNG) && defined(SF_HAVE_ZLIB)

// Largest settings that are read.
#define CONFIG_MAX (1u << 20)
#define NO_ENTRY UINT32_MAX
#define NUMBER_DIGITS 5 // of a layer, in the name of its picture
#define NAME_SIZE 96

int sf_job_has_sl1(void)
{
    return 1;
}

// ---------------------------------------------------------------------------------------------
// Settings
// ---------------------------------------------------------------------------------------------

typedef struct config {
    char *text;
    size_t size;
} config;

static sf_status find_entry(const sf_job *job, const char *name, size_t *entry, sf_fault *fault)
{
    size_t found = 0;
    for (size_t i = 0; i < job->archive.count; i++) {
        if (sfi_archive_is_named(&job->archive, i, name)) {
            *entry = i;
            found++;
        }
    }
    if (found > 1) {
        return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                             "the job has two files %s, which readers would take differently; "
                             "export it again",
                             name);
    }
    return found == 1 ? SF_OK : SF_ERR_IO; // SF_ERR_IO: there is none
}

static sf_status read_text(const sf_job *job, size_t entry, config *made, sf_fault *fault)
{
    sfi_archive_reader *reader;
    sf_source source;
    size_t size = job->archive.entries[entry].size, done = 0;
    if (size > CONFIG_MAX) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "the job's settings are larger than 1 MiB");
    }
    made->text = sfi_alloc_array(&job->allocator, size + 1, 1);
    if (made->text == NULL) {
        return SF_ERR_MEMORY;
    }
    made->size = size;
    SF_TRY(sfi_archive_begin(&job->archive, entry, &reader, &source, fault));
    sf_status status = SF_OK;
    for (size_t got = 1; status == SF_OK && done < size && got > 0; done += got) {
        status = source.read(source.user, made->text + done, size - done, &got);
    }
    if (status == SF_OK) {
        status = sfi_archive_finish(reader, 0, fault);
    } else if (status == SF_ERR_FORMAT) {
        status = sfi_fault_set(fault, status, 0, job->archive.entries[entry].begin,
                               "the job's settings are damaged; export it again");
    }
    sfi_archive_end(reader);
    return status;
}

static void release(const sf_job *job, config *c)
{
    if (c->text != NULL) {
        sfi_free_array(&job->allocator, c->text, c->size + 1, 1);
    }
}

static int get(const config *c, const char *key, double *value)
{
    return c->text != NULL && sfi_config_number(c->text, c->size, key, value);
}

// ---------------------------------------------------------------------------------------------
// Layers
// ---------------------------------------------------------------------------------------------

// Where the number in the name of a layer's picture begins and ends; 0 for an entry that is none.
static int is_layer(const sf_job *job, size_t entry, size_t *first, size_t *end)
{
    const char *name = sfi_archive_name(&job->archive, entry);
    size_t size = job->archive.entries[entry].name_size;
    if (size < 5 || memcmp(name + size - 4, ".png", 4) != 0 || memchr(name, '/', size) != NULL ||
        memchr(name, '\\', size) != NULL) {
        return 0;
    }
    *end = *first = size - 4;
    while (*first > 0 && name[*first - 1] >= '0' && name[*first - 1] <= '9') {
        --*first;
    }
    return *first < *end;
}

// The number of a layer, after the text that all names begin with; NO_ENTRY where it is too large.
static uint32_t number_of(const sf_job *job, size_t entry, size_t prefix, size_t end)
{
    const char *name = sfi_archive_name(&job->archive, entry);
    uint32_t number = 0;
    for (size_t i = prefix; i < end && number < NO_ENTRY; i++) {
        number = number < 100000000 ? number * 10 + (uint32_t)(name[i] - '0') : NO_ENTRY;
    }
    return number;
}

// How many layers there are, and how long the text is that all their names begin with. A job's own
// name may end in digits: numbers are written with five of them, and with more only where there are
// more layers, so the shortest name has its last five, or fewer where it has no more.
static sf_status count_layers(sf_job *job, size_t *prefix, sf_fault *fault)
{
    size_t shortest = SIZE_MAX, any = 0, first, end;
    for (size_t i = 0; i < job->archive.count; i++) {
        if (is_layer(job, i, &first, &end)) {
            job->layer_count++;
            if (end < shortest) {
                shortest = end;
                any = i;
                *prefix = end - first > NUMBER_DIGITS ? end - NUMBER_DIGITS : first;
            }
        }
    }
    for (size_t i = 0; i < job->archive.count; i++) {
        if (is_layer(job, i, &first, &end) &&
            (first > *prefix || memcmp(sfi_archive_name(&job->archive, any),
                                       sfi_archive_name(&job->archive, i), *prefix) != 0)) {
            return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                                 "the job has pictures of several names, and which are its layers "
                                 "nobody can tell; export it again");
        }
    }
    if (job->layer_count == 0) {
        return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                             "the archive has no pictures of layers, so it is no SL1 job");
    }
    if (job->layer_count > job->options.layers_max) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "the job has %u layers; raise layers_max", (unsigned)job->layer_count);
    }
    return SF_OK;
}

static sf_status find_layers(sf_job *job, sf_fault *fault)
{
    size_t prefix = 0, first, end;
    SF_TRY(count_layers(job, &prefix, fault));
    job->layers = sfi_alloc_array(&job->allocator, job->layer_count, sizeof *job->layers);
    if (job->layers == NULL) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t k = 0; k < job->layer_count; k++) {
        job->layers[k] = NO_ENTRY;
    }
    for (size_t i = 0; i < job->archive.count; i++) {
        if (!is_layer(job, i, &first, &end)) {
            continue;
        }
        uint32_t number = number_of(job, i, prefix, end);
        if (number >= job->layer_count || job->layers[number] != NO_ENTRY) {
            return sfi_fault_set(
                fault, SF_ERR_FORMAT, 0, 0,
                number < job->layer_count
                    ? "layer %lu is there twice; export the job again"
                    : "there are %lu layers, but not all from 0 on; export the job "
                      "again",
                (unsigned long)(number < job->layer_count ? number : job->layer_count));
        }
        job->layers[number] = (uint32_t)i;
    }
    job->lattice.nz = job->layer_count;
    return SF_OK;
}

static void name_layer(const sf_job *job, uint32_t k, char name[NAME_SIZE])
{
    size_t entry = job->layers[k], size = job->archive.entries[entry].name_size;
    size = size < NAME_SIZE - 1 ? size : NAME_SIZE - 1;
    memcpy(name, sfi_archive_name(&job->archive, entry), size);
    name[size] = '\0';
}

static sf_status look_at_layers(sf_job *job, sf_fault *fault)
{
    for (uint32_t k = 0; k < job->layer_count; k++) {
        sfi_archive_reader *reader;
        sf_source source;
        sfi_png_head head = {0, 0, 0};
        char name[NAME_SIZE];
        name_layer(job, k, name);
        SF_TRY(sfi_archive_begin(&job->archive, job->layers[k], &reader, &source, fault));
        sf_status status = sfi_png_look(source, name, &head, fault);
        sfi_archive_end(reader);
        SF_TRY(status);
        if (k > 0 && (head.width != job->lattice.nx || head.height != job->lattice.ny)) {
            return sfi_picture_fault(fault, SF_ERR_FORMAT, name,
                                     "the picture has not the size of the others");
        }
        job->lattice.nx = head.width;
        job->lattice.ny = head.height;
        job->info.has_greys |= head.has_greys;
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Sizes
// ---------------------------------------------------------------------------------------------

// The display's pixels, which may lie on their side.
static sf_status said_pitch(sf_job *job, const config *slicer, sf_fault *fault)
{
    double size[2], pixels[2];
    sf_lattice *l = &job->lattice;
    if (!get(slicer, "display_width", &size[0]) || !get(slicer, "display_height", &size[1]) ||
        !get(slicer, "display_pixels_x", &pixels[0]) ||
        !get(slicer, "display_pixels_y", &pixels[1])) {
        return SF_OK;
    }
    int turned = !(pixels[0] == l->nx && pixels[1] == l->ny);
    if ((turned && !(pixels[0] == l->ny && pixels[1] == l->nx)) || !(size[0] > 0) ||
        !(size[1] > 0)) {
        return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                             "the pictures have not the size of the display in prusaslicer.ini; "
                             "export the job again");
    }
    l->pitch_x_mm = sfi_job_round_mm(size[turned] / pixels[turned]);
    l->pitch_y_mm = sfi_job_round_mm(size[!turned] / pixels[!turned]);
    job->info.has_pitch = 1;
    return SF_OK;
}

static sf_status find_pitch(sf_job *job, const config *slicer, sf_fault *fault)
{
    sf_lattice *l = &job->lattice;
    if (job->options.pitch_mm[0] > 0) {
        l->pitch_x_mm = job->options.pitch_mm[0];
        l->pitch_y_mm = job->options.pitch_mm[1];
        return SF_OK;
    }
    SF_TRY(said_pitch(job, slicer, fault));
    if (!job->info.has_pitch && l->nx == 1440 && l->ny == 2560) {
        l->pitch_x_mm = l->pitch_y_mm = 0.04725; // 68.04 mm by 120.96 mm
    } else if (!job->info.has_pitch) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "the job does not say how large its pixels are; say it (--pitch X,Y)");
    }
    return SF_OK;
}

static sf_status find_heights(sf_job *job, const config *own, const config *slicer, sf_fault *fault)
{
    double layer = 0, first = 0, slow = 0, fast = 0;
    uint32_t count = job->layer_count;
    if (!get(own, "layerHeight", &layer) || !(layer > 0 && layer <= 1000)) {
        return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                             "config.ini says no layerHeight above 0; export the job again");
    }
    if (get(own, "numSlow", &slow) && get(own, "numFast", &fast) && slow + fast != count) {
        return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                             "config.ini says another number of layers than the %lu that there "
                             "are; export the job again",
                             (unsigned long)count);
    }
    job->lattice.layer_mm = layer;
    if (get(slicer, "initial_layer_height", &first) && first > 0 && first <= 1000 &&
        first != layer && count > 1) {
        job->heights = sfi_alloc_array(&job->allocator, count, sizeof *job->heights);
        if (job->heights == NULL) {
            return SF_ERR_MEMORY;
        }
        for (uint32_t k = 0; k < count; k++) {
            job->heights[k] = k == 0 ? first : layer;
        }
    }
    return SF_OK;
}

static sf_status open_job(sf_job *job, config *own, config *slicer, sf_fault *fault)
{
    size_t entry = 0;
    SF_TRY(find_layers(job, fault));
    sf_status status = find_entry(job, "config.ini", &entry, fault);
    if (status == SF_ERR_IO) {
        return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                             "the archive has no config.ini, so it is no SL1 job");
    }
    SF_TRY(status);
    SF_TRY(read_text(job, entry, own, fault));
    status = find_entry(job, "prusaslicer.ini", &entry, fault);
    if (status == SF_OK) {
        SF_TRY(read_text(job, entry, slicer, fault));
    } else if (status != SF_ERR_IO) {
        return status;
    }
    SF_TRY(look_at_layers(job, fault));
    SF_TRY(find_pitch(job, slicer, fault));
    return find_heights(job, own, slicer, fault);
}

sf_status sfi_sl1_open(sf_job *job, sf_fault *fault)
{
    config own = {NULL, 0}, slicer = {NULL, 0};
    SF_TRY(sfi_archive_open(&job->archive, job->bytes, &job->allocator, fault));
    if (job->archive.is_wide) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "jobs of more than 4 GiB, or with sizes of 64 bits, are not read; "
                             "export it again as a plain archive");
    }
    sf_status status = open_job(job, &own, &slicer, fault);
    release(job, &own);
    release(job, &slicer);
    return status;
}

sf_status sfi_sl1_read(sf_job *job, uint32_t k, const sfi_job_out *out, sf_fault *fault)
{
    sfi_archive_reader *reader;
    sf_source source;
    char name[NAME_SIZE];
    name_layer(job, k, name);
    SF_TRY(sfi_archive_begin(&job->archive, job->layers[k], &reader, &source, fault));
    sf_status status = sfi_png_read_rows(source, &job->allocator, name, job->lattice.nx,
                                         job->lattice.ny, out->greys, out->user, fault);
    if (status == SF_OK) {
        status = sfi_archive_finish(reader, CONFIG_MAX, fault);
    }
    sfi_archive_end(reader);
    return status;
}

#else

int sf_job_has_sl1(void)
{
    return 0;
}

sf_status sfi_sl1_open(sf_job *job, sf_fault *fault)
{
    (void)job;
    return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                         "this build reads no SL1 jobs; build it with libspng and zlib");
}

sf_status sfi_sl1_read(sf_job *job, uint32_t k, const sfi_job_out *out, sf_fault *fault)
{
    (void)k;
    (void)out;
    return sfi_sl1_open(job, fault);
}

#endif

// SPDX-License-Identifier: MIT
// Tetrahedra in from HDF5.
//
// The whole file is read into memory first, from any source, and libhdf5 is given that. It may
// claim what it likes: a table is refused if it is larger than the file could hold, compressed as
// well as deflate can. Nothing may lead out of it: filters that libhdf5 would look for on the disk
// are forbidden, links that are not hard are none, and tables whose numbers lie in other files
// (external and virtual ones) are refused.

#include "io/exchange.h"

#include "base/memory.h"
#include "base/status.h"

#ifdef SF_HAVE_HDF5

#include <hdf5.h>
#include <stdio.h>
#include <string.h>

// Deflate makes at most that much of a byte (zlib: 1032), and there is little beside the tables.
enum { MOST_EXPANSION = 1100 };
static const uint64_t DEFAULT_MOST = (uint64_t)1 << 32;

typedef struct reader {
    const sf_allocator *allocator;
    sf_fault *fault;
    unsigned char *bytes;
    size_t size, capacity;
    hid_t file;
    // What is read.
    size_t points, tets;
    double *positions;
    uint32_t *corners;
    size_t channel_count;
    sf_channel channels[SF_PROPERTY_MAX];
} reader;

static void free_reader(reader *r)
{
    for (size_t i = 0; i < r->channel_count; i++) {
        sfi_free_array(r->allocator, (void *)r->channels[i].values, r->channels[i].value_count,
                       sizeof(double));
        sfi_free_array(r->allocator, (void *)r->channels[i].indices, r->tets, 4 * sizeof(uint32_t));
    }
    sfi_free_array(r->allocator, r->positions, r->points, 3 * sizeof(double));
    sfi_free_array(r->allocator, r->corners, r->tets, 4 * sizeof(uint32_t));
    sfi_free_array(r->allocator, r->bytes, r->capacity, 1);
}

static sf_status wrong(const reader *r, const char *where, const char *what)
{
    return sfi_fault_set(r->fault, SF_ERR_FORMAT, 0, 0, "%s %s", where, what);
}

static sf_status read_bytes(reader *r, sf_source source, uint64_t most)
{
    for (size_t got = 1; got > 0; r->size += got) {
        if (!sfi_grow_array(r->allocator, (void **)&r->bytes, &r->capacity, r->size + 65536, 1)) {
            return SF_ERR_MEMORY;
        }
        sf_status status = source.read(source.user, r->bytes + r->size, 65536, &got);
        status = status == SF_OK && got > 65536 ? SF_ERR_IO : status; // a broken promise
        if (status != SF_OK) {
            return sfi_fault_set(r->fault, status, 0, r->size, "reading failed");
        }
        if (r->size + got > most) {
            return sfi_fault_set(r->fault, SF_ERR_OVERFLOW, 0, 0,
                                 "the file is larger than %llu bytes", (unsigned long long)most);
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Tables
// ---------------------------------------------------------------------------------------------

// What a table must be: numbers of a kind and size, in rows of so many (0: a plain list).
typedef struct kind {
    H5T_class_t class;
    size_t size;
    size_t columns;
    hid_t memory_type;
    const char *words;
} kind;

static int is_kind(hid_t set, const kind *k)
{
    hid_t type = H5Dget_type(set);
    int good = type >= 0 && H5Tget_class(type) == k->class && H5Tget_size(type) == k->size &&
               (k->class != H5T_INTEGER || H5Tget_sign(type) == H5T_SGN_NONE);
    if (type >= 0) {
        H5Tclose(type);
    }
    return good;
}

// The rows of a table; 0 if it is none of its kind.
static size_t count_rows(hid_t set, const kind *k)
{
    hsize_t size[2] = {0, 0};
    hid_t space = H5Dget_space(set);
    int rank = space < 0 ? -1 : H5Sget_simple_extent_ndims(space);
    int good = rank == (k->columns == 0 ? 1 : 2) &&
               H5Sget_simple_extent_dims(space, size, NULL) == rank &&
               (k->columns == 0 || size[1] == k->columns) && size[0] <= INT32_MAX;
    if (space >= 0) {
        H5Sclose(space);
    }
    return good ? (size_t)size[0] : 0;
}

// Whether the numbers of a table lie in this file.
static int is_at_home(hid_t set)
{
    hid_t list = H5Dget_create_plist(set);
    int good = list >= 0 && H5Pget_layout(list) != H5D_VIRTUAL && H5Pget_external_count(list) == 0;
    if (list >= 0) {
        H5Pclose(list);
    }
    return good;
}

// Whether a name is that of an object itself. Other links name another place, or another file.
static int is_hard(hid_t place, const char *name)
{
    H5L_info_t info;
    return H5Lexists(place, name, H5P_DEFAULT) > 0 &&
           H5Lget_info(place, name, &info, H5P_DEFAULT) >= 0 && info.type == H5L_TYPE_HARD;
}

static sf_status read_set(reader *r, hid_t set, const char *where, const kind *k, size_t *rows,
                          void **data)
{
    size_t row = (k->columns == 0 ? 1 : k->columns) * k->size;
    *rows = is_kind(set, k) ? count_rows(set, k) : 0;
    if (*rows == 0) {
        return wrong(r, where, k->words);
    }
    if (!is_at_home(set)) {
        return wrong(r, where, "has its numbers in another file");
    }
    if (*rows > (r->size / row + 1) * MOST_EXPANSION) {
        return wrong(r, where, "claims to hold more than the file can");
    }
    *data = sfi_alloc_array(r->allocator, *rows, row);
    if (*data == NULL) {
        return SF_ERR_MEMORY;
    }
    if (H5Dread(set, k->memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, *data) < 0) {
        sfi_free_array(r->allocator, *data, *rows, row);
        *data = NULL;
        return wrong(r, where, "is damaged, or compressed in a way that is not served");
    }
    return SF_OK;
}

static sf_status read_table(reader *r, hid_t place, const char *name, const char *where,
                            const kind *k, size_t *rows, void **data)
{
    hid_t set = is_hard(place, name) ? H5Dopen2(place, name, H5P_DEFAULT) : -1;
    if (set < 0) {
        return wrong(r, where, "is missing, no table, or a link to another place");
    }
    sf_status status = read_set(r, set, where, k, rows, data);
    H5Dclose(set);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Attributes
// ---------------------------------------------------------------------------------------------

// A text of a fixed size.
static int read_fixed(hid_t attribute, hid_t type, char *text, size_t size)
{
    return H5Tget_size(type) < size && H5Aget_storage_size(attribute) == H5Tget_size(type) &&
           H5Aread(attribute, type, text) >= 0;
}

// A text of any size, as h5py writes them: libhdf5 takes memory for it.
static int read_variable(hid_t attribute, hid_t type, char *text, size_t size)
{
    char *found = NULL;
    hid_t space = H5Aget_space(attribute);
    int good = space >= 0 && H5Sget_simple_extent_npoints(space) == 1 &&
               H5Aread(attribute, type, &found) >= 0 && found != NULL && strlen(found) < size;
    if (good) {
        memcpy(text, found, strlen(found));
    }
    if (found != NULL) {
        H5free_memory(found);
    }
    if (space >= 0) {
        H5Sclose(space);
    }
    return good;
}

// A text that ends within `size` bytes.
static int read_text(hid_t place, const char *name, char *text, size_t size)
{
    hid_t attribute = H5Aexists(place, name) > 0 ? H5Aopen(place, name, H5P_DEFAULT) : -1;
    hid_t type = attribute < 0 ? -1 : H5Aget_type(attribute);
    int good = type >= 0 && H5Tget_class(type) == H5T_STRING;
    memset(text, 0, size);
    good = good && (H5Tis_variable_str(type) > 0 ? read_variable(attribute, type, text, size)
                                                 : read_fixed(attribute, type, text, size));
    if (type >= 0) {
        H5Tclose(type);
    }
    if (attribute >= 0) {
        H5Aclose(attribute);
    }
    return good;
}

// Numbers, `count` of them.
static int read_numbers(hid_t place, const char *name, hid_t memory_type, H5T_class_t class,
                        hsize_t count, void *numbers)
{
    hid_t attribute = H5Aexists(place, name) > 0 ? H5Aopen(place, name, H5P_DEFAULT) : -1;
    hid_t space = attribute < 0 ? -1 : H5Aget_space(attribute);
    hid_t type = attribute < 0 ? -1 : H5Aget_type(attribute);
    int good = space >= 0 && type >= 0 && H5Tget_class(type) == class &&
               H5Sget_simple_extent_npoints(space) == (hssize_t)count &&
               H5Aread(attribute, memory_type, numbers) >= 0;
    if (type >= 0) {
        H5Tclose(type);
    }
    if (space >= 0) {
        H5Sclose(space);
    }
    if (attribute >= 0) {
        H5Aclose(attribute);
    }
    return good;
}

// ---------------------------------------------------------------------------------------------
// Properties
// ---------------------------------------------------------------------------------------------

static sf_status read_meaning(const reader *r, hid_t group, const char *where, sf_property *p)
{
    if (!read_text(group, "name", p->name, sizeof p->name) ||
        !read_numbers(group, "si_exponents", H5T_NATIVE_INT8, H5T_INTEGER, 7, p->si) ||
        !read_numbers(group, "low", H5T_NATIVE_DOUBLE, H5T_FLOAT, 1, &p->low) ||
        !read_numbers(group, "high", H5T_NATIVE_DOUBLE, H5T_FLOAT, 1, &p->high)) {
        return wrong(r, where, "lacks its name (47 bytes at most), si_exponents, low or high");
    }
    return SF_OK;
}

static sf_status read_channel(reader *r, hid_t group, const char *uuid)
{
    kind values = {H5T_FLOAT, 8, 0, H5T_NATIVE_DOUBLE, "is no list of 64-bit numbers"};
    kind index = {H5T_INTEGER, 4, 4, H5T_NATIVE_UINT32,
                  "has no rows of four unsigned 32-bit numbers"};
    sf_channel *c = &r->channels[r->channel_count];
    char where[96];
    void *data = NULL;
    size_t rows = 0;
    memset(c, 0, sizeof *c);
    snprintf(where, sizeof where, "/properties/%s", uuid);
    if (!sfi_exchange_uuid_parse(uuid, c->property.uuid)) {
        return wrong(r, where, "is no UUID");
    }
    SF_TRY(read_meaning(r, group, where, &c->property));
    snprintf(where, sizeof where, "/properties/%s/values", uuid);
    SF_TRY(read_table(r, group, "values", where, &values, &c->value_count, &data));
    c->values = data;
    r->channel_count++;
    snprintf(where, sizeof where, "/properties/%s/index", uuid);
    data = NULL;
    SF_TRY(read_table(r, group, "index", where, &index, &rows, &data));
    if (rows != r->tets) {
        sfi_free_array(r->allocator, data, rows, 4 * sizeof(uint32_t));
        return wrong(r, where, "has not one row for each tetrahedron");
    }
    c->indices = data;
    if (c->value_count == r->points &&
        memcmp(c->indices, r->corners, 4 * r->tets * sizeof(uint32_t)) == 0) {
        sfi_free_array(r->allocator, data, rows, 4 * sizeof(uint32_t));
        c->indices = NULL; // each point has its own
    }
    return SF_OK;
}

static sf_status read_channels(reader *r, hid_t properties)
{
    H5G_info_t info;
    if (H5Gget_info(properties, &info) < 0) {
        return wrong(r, "/properties", "is damaged");
    }
    for (hsize_t i = 0; i < info.nlinks; i++) {
        char name[SFI_UUID_SIZE + 1];
        ssize_t length = H5Lget_name_by_idx(properties, ".", H5_INDEX_NAME, H5_ITER_INC, i, name,
                                            sizeof name, H5P_DEFAULT);
        if (length < 0 || length >= (ssize_t)sizeof name || r->channel_count == SF_PROPERTY_MAX) {
            return wrong(r, "/properties", "has more than 64 entries, or one that is no UUID");
        }
        hid_t group = is_hard(properties, name) ? H5Gopen2(properties, name, H5P_DEFAULT) : -1;
        if (group < 0) {
            return wrong(r, "/properties", "has an entry that is no group, or a link to one");
        }
        sf_status status = read_channel(r, group, name);
        H5Gclose(group);
        SF_TRY(status);
    }
    return SF_OK;
}

static sf_status read_head(const reader *r)
{
    char format[32], unit[16];
    uint32_t version = 0;
    if (!read_text(r->file, "format", format, sizeof format) ||
        strcmp(format, SFI_EXCHANGE_FORMAT) != 0) {
        return wrong(r, "the file", "is not of the format " SFI_EXCHANGE_FORMAT);
    }
    if (!read_numbers(r->file, "version", H5T_NATIVE_UINT32, H5T_INTEGER, 1, &version) ||
        version != SFI_EXCHANGE_VERSION || !read_text(r->file, "length_unit", unit, sizeof unit) ||
        strcmp(unit, "mm") != 0) {
        return sfi_fault_set(r->fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "the version is not 1 or the unit not mm; a newer libsf wrote this");
    }
    return SF_OK;
}

static sf_status read_all(reader *r)
{
    kind positions = {H5T_FLOAT, 8, 3, H5T_NATIVE_DOUBLE, "has no rows of three 64-bit numbers"};
    kind tets = {H5T_INTEGER, 4, 4, H5T_NATIVE_UINT32,
                 "has no rows of four unsigned 32-bit numbers"};
    void *data = NULL;
    SF_TRY(read_head(r));
    SF_TRY(read_table(r, r->file, "positions", "/positions", &positions, &r->points, &data));
    r->positions = data;
    data = NULL;
    SF_TRY(read_table(r, r->file, "tets", "/tets", &tets, &r->tets, &data));
    r->corners = data;
    hid_t group =
        is_hard(r->file, "properties") ? H5Gopen2(r->file, "properties", H5P_DEFAULT) : -1;
    if (group < 0) {
        return wrong(r, "/properties", "is missing, no group, or a link to one");
    }
    sf_status status = read_channels(r, group);
    H5Gclose(group);
    return status;
}

static hid_t open_file(const reader *r)
{
    hid_t access = H5Pcreate(H5P_FILE_ACCESS), file = -1;
    if (access >= 0 && H5Pset_fapl_core(access, 1 << 20, 0) >= 0 &&
        H5Pset_file_image(access, r->bytes, r->size) >= 0) {
        file = H5Fopen("libsf-exchange", H5F_ACC_RDONLY, access);
    }
    if (access >= 0) {
        H5Pclose(access);
    }
    return file;
}

static sf_status read_quietly(reader *r, sf_tets **tets)
{
    r->file = open_file(r);
    if (r->file < 0) {
        return wrong(r, "the file", "is no HDF5 file, or is damaged");
    }
    sf_status status = read_all(r);
    H5Fclose(r->file);
    if (status == SF_OK) {
        sf_tets_view view = {r->points,  r->positions,     r->tets,
                             r->corners, r->channel_count, r->channels};
        status = sf_tets_create(&view, r->allocator, tets, r->fault);
    }
    return status;
}

sf_status sf_exchange_read(sf_source source, uint64_t bytes_max, const sf_allocator *allocator,
                           sf_tets **tets, sf_fault *fault)
{
    if (source.read == NULL || tets == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    reader r;
    memset(&r, 0, sizeof r);
    r.allocator = &kept;
    r.fault = fault;
    sf_status status = read_bytes(&r, source, bytes_max != 0 ? bytes_max : DEFAULT_MOST);
    if (status == SF_OK) {
        H5E_auto2_t said;
        void *to;
        unsigned plugins = 0;
        H5Eget_auto2(H5E_DEFAULT, &said, &to);
        H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
        H5PLget_loading_state(&plugins);
        H5PLset_loading_state(0);
        status = read_quietly(&r, tets);
        H5PLset_loading_state(plugins);
        H5Eset_auto2(H5E_DEFAULT, said, to);
    }
    free_reader(&r);
    return status;
}

#else

sf_status sf_exchange_read(sf_source source, uint64_t bytes_max, const sf_allocator *allocator,
                           sf_tets **tets, sf_fault *fault)
{
    (void)bytes_max;
    (void)allocator;
    if (source.read == NULL || tets == NULL) {
        return SF_ERR_ARGUMENT;
    }
    return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                         "this build reads no exchange files; build it with libhdf5");
}

#endif

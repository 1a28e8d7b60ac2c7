// SPDX-License-Identifier: MIT
// Tetrahedra out as HDF5.
//
// The file is made in memory, by libhdf5's core driver, and handed on when it is whole, so that no
// sink ever sees half of one. Nothing in it depends on when or where it was made: no times are
// kept.

#include "io/exchange.h"

#include "base/memory.h"
#include "base/status.h"

#ifdef SF_HAVE_HDF5

#include <hdf5.h>
#include <string.h>

enum { CHUNK = 65536, DEFLATE = 6 };

int sf_exchange_is_served(void)
{
    return 1;
}

// One way to close them all, in the order in which they were opened last.
typedef struct writer {
    hid_t file, properties, group;
} writer;

static hid_t creation_list(hid_t class)
{
    hid_t list = H5Pcreate(class);
    if (list >= 0) {
        (void)H5Pset_obj_track_times(list, 0);
    }
    return list;
}

// A table of rows by columns (0: a plain list), compressed in chunks where it is large.
static int write_table(hid_t place, const char *name, hid_t file_type, hid_t memory_type,
                       size_t rows, size_t columns, const void *data)
{
    hsize_t size[2] = {rows, columns}, chunk[2] = {rows < CHUNK ? rows : CHUNK, columns};
    int rank = columns == 0 ? 1 : 2;
    hid_t space = H5Screate_simple(rank, size, NULL), list = creation_list(H5P_DATASET_CREATE);
    hid_t set = -1;
    int good = space >= 0 && list >= 0 && H5Pset_chunk(list, rank, chunk) >= 0 &&
               H5Pset_shuffle(list) >= 0 && H5Pset_deflate(list, DEFLATE) >= 0;
    if (good) {
        set = H5Dcreate2(place, name, file_type, space, H5P_DEFAULT, list, H5P_DEFAULT);
        good = set >= 0 && H5Dwrite(set, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0;
    }
    if (set >= 0) {
        good = H5Dclose(set) >= 0 && good;
    }
    if (list >= 0) {
        H5Pclose(list);
    }
    if (space >= 0) {
        H5Sclose(space);
    }
    return good;
}

static int write_attribute(hid_t place, const char *name, hid_t type, hid_t space,
                           hid_t memory_type, const void *data)
{
    hid_t attribute =
        space < 0 || type < 0 ? -1 : H5Acreate2(place, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    int good = attribute >= 0 && H5Awrite(attribute, memory_type, data) >= 0;
    if (attribute >= 0) {
        good = H5Aclose(attribute) >= 0 && good;
    }
    if (space >= 0) {
        H5Sclose(space);
    }
    return good;
}

static int write_text(hid_t place, const char *name, const char *text)
{
    hid_t type = H5Tcopy(H5T_C_S1);
    int good = type >= 0 && H5Tset_size(type, strlen(text) + 1) >= 0 &&
               H5Tset_cset(type, H5T_CSET_UTF8) >= 0 &&
               write_attribute(place, name, type, H5Screate(H5S_SCALAR), type, text);
    if (type >= 0) {
        H5Tclose(type);
    }
    return good;
}

static int write_number(hid_t place, const char *name, double value)
{
    return write_attribute(place, name, H5T_IEEE_F64LE, H5Screate(H5S_SCALAR), H5T_NATIVE_DOUBLE,
                           &value);
}

static int write_version(hid_t place)
{
    uint32_t version = SFI_EXCHANGE_VERSION;
    return write_attribute(place, "version", H5T_STD_U32LE, H5Screate(H5S_SCALAR),
                           H5T_NATIVE_UINT32, &version);
}

static int write_exponents(hid_t place, const int8_t si[7])
{
    hsize_t seven = 7;
    return write_attribute(place, "si_exponents", H5T_STD_I8LE, H5Screate_simple(1, &seven, NULL),
                           H5T_NATIVE_INT8, si);
}

static hid_t create_group(hid_t place, const char *name)
{
    hid_t list = creation_list(H5P_GROUP_CREATE);
    hid_t group = list < 0 ? -1 : H5Gcreate2(place, name, H5P_DEFAULT, list, H5P_DEFAULT);
    if (list >= 0) {
        H5Pclose(list);
    }
    return group;
}

static int write_channel(writer *w, const sf_tets_view *v, const sf_channel *channel)
{
    const sf_property *p = &channel->property;
    char uuid[SFI_UUID_SIZE], unit[SFI_UNIT_SIZE];
    sfi_exchange_uuid(p->uuid, uuid);
    sfi_exchange_unit(p->si, unit);
    w->group = create_group(w->properties, uuid);
    int good = w->group >= 0 && write_text(w->group, "name", p->name) &&
               write_text(w->group, "unit", unit) && write_exponents(w->group, p->si) &&
               write_number(w->group, "low", p->low) && write_number(w->group, "high", p->high) &&
               write_table(w->group, "values", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE,
                           channel->value_count, 0, channel->values) &&
               write_table(w->group, "index", H5T_STD_U32LE, H5T_NATIVE_UINT32, v->tet_count, 4,
                           channel->indices != NULL ? channel->indices : v->corners);
    if (w->group >= 0) {
        good = H5Gclose(w->group) >= 0 && good;
    }
    w->group = -1;
    return good;
}

static int write_all(writer *w, const sf_tets_view *v)
{
    int good =
        write_text(w->file, "format", SFI_EXCHANGE_FORMAT) && write_version(w->file) &&
        write_text(w->file, "length_unit", "mm") &&
        write_table(w->file, "positions", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, v->point_count, 3,
                    v->positions) &&
        write_table(w->file, "tets", H5T_STD_U32LE, H5T_NATIVE_UINT32, v->tet_count, 4, v->corners);
    w->properties = good ? create_group(w->file, "properties") : -1;
    good = good && w->properties >= 0;
    for (size_t i = 0; good && i < v->channel_count; i++) {
        good = write_channel(w, v, &v->channels[i]);
    }
    if (w->properties >= 0) {
        good = H5Gclose(w->properties) >= 0 && good;
    }
    return good;
}

// A file in memory that is written nowhere.
static hid_t create_file(void)
{
    hid_t access = H5Pcreate(H5P_FILE_ACCESS), create = creation_list(H5P_FILE_CREATE), file = -1;
    if (access >= 0 && create >= 0 && H5Pset_fapl_core(access, 1 << 20, 0) >= 0 &&
        H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18) >= 0) {
        file = H5Fcreate("libsf-exchange", H5F_ACC_TRUNC, create, access);
    }
    if (create >= 0) {
        H5Pclose(create);
    }
    if (access >= 0) {
        H5Pclose(access);
    }
    return file;
}

static sf_status hand_on(hid_t file, sf_sink sink)
{
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    ssize_t size = H5Fflush(file, H5F_SCOPE_GLOBAL) < 0 ? -1 : H5Fget_file_image(file, NULL, 0);
    if (size <= 0) {
        return SF_ERR_INTERNAL;
    }
    void *bytes = sfi_alloc_array(&allocator, (size_t)size, 1);
    if (bytes == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = H5Fget_file_image(file, bytes, (size_t)size) == size
                           ? sink.write(sink.user, bytes, (size_t)size)
                           : SF_ERR_INTERNAL;
    sfi_free_array(&allocator, bytes, (size_t)size, 1);
    return status;
}

static sf_status write_quietly(const sf_tets_view *v, sf_sink sink, sf_fault *fault)
{
    writer w = {create_file(), -1, -1};
    sf_status status = w.file >= 0 && write_all(&w, v) ? hand_on(w.file, sink) : SF_ERR_MEMORY;
    if (w.file >= 0 && H5Fclose(w.file) < 0 && status == SF_OK) {
        status = SF_ERR_INTERNAL;
    }
    return status == SF_OK
               ? SF_OK
               : sfi_fault_set(fault, status, 0, 0, "the exchange file was not written: %s",
                               sf_status_message(status));
}

sf_status sf_exchange_write(const sf_tets *tets, sf_sink sink, sf_fault *fault)
{
    if (tets == NULL || sink.write == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_tets_view view = sf_tets_get_view(tets);
    H5E_auto2_t said;
    void *to;
    H5Eget_auto2(H5E_DEFAULT, &said, &to);
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL); // what fails is said in our words
    sf_status status = write_quietly(&view, sink, fault);
    H5Eset_auto2(H5E_DEFAULT, said, to);
    return status;
}

#else

int sf_exchange_is_served(void)
{
    return 0;
}

sf_status sf_exchange_write(const sf_tets *tets, sf_sink sink, sf_fault *fault)
{
    if (tets == NULL || sink.write == NULL) {
        return SF_ERR_ARGUMENT;
    }
    return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                         "this build writes no exchange files; build it with libhdf5");
}

#endif

// SPDX-License-Identifier: MIT
// A 3MF file that is damaged, or that asks for what is not read, is refused with a sentence that
// says what is wrong, and leaves nothing behind: cycles, paths that lead out, entities, two parts
// of one name. Guards: TRUST 2, B5, B7, B10 to B14; the strong guarantee.

#include "stored_zip.h"

#define C OBJECT("1", CORNER)
#define I ITEM("1")
#define VERTEX "<vertex x=\"0\" y=\"0\" z=\"0\"/>"
#define MESH(vertices, triangles)                                                                  \
    "<mesh><vertices>" vertices "</vertices><triangles>" triangles "</triangles></mesh>"
#define TRIANGLE "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>"

static int model_refused(const char *model, sf_status expected, const char *words)
{
    static archive a;
    archive_model(&a, model);
    return refused(&a, NULL, expected, words);
}

static void refuses_what_it_cannot_read(void)
{
    static const struct {
        const char *model, *words;
    } wanting[] = {
        {MODEL("xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\" "
               "requiredextensions=\"b\"",
               C, I),
         "beam lattices"},
        {MODEL("xmlns:i=\"http://schemas.3mf.io/3dmanufacturing/implicit/2023/12\" "
               "requiredextensions=\" p  m i \"",
               C, I),
         "implicit functions"},
        {MODEL("xmlns:q=\"urn:q\" requiredextensions=\"q\"", C, I), "urn:q"},
        {MODEL("xmlns:b=\"urn:b\"",
               OBJECT("1", "<mesh><vertices>" VERTEX "</vertices><b:beamlattice/></mesh>"), I),
         "beam lattice"},
        {MODEL("xmlns:v=\"urn:v\"", OBJECT("1", "<v:levelset/>"), I), "'levelset'"},
    };
    for (size_t i = 0; i < sizeof wanting / sizeof wanting[0]; i++) {
        CHECK(model_refused(wanting[i].model, SF_ERR_UNSUPPORTED, wanting[i].words));
    }
    CHECK(model_refused(MODEL("requiredextensions=\"zz\"", C, I), SF_ERR_FORMAT, "does not name"));
}

static void refuses_broken_models(void)
{
    static const struct {
        const char *model, *words;
    } broken[] = {
        {"", "no element found"},
        {"<model/>", "no model"},
        {"<model " CORE_NS ">", "no element found"},
        {"<model " CORE_NS "></modle>", "mismatched"},
        {MODEL("unit=\"yard\"", C, I), "unit"},
        {MODEL("", "", ""), "no objects"},
        {MODEL("", C, ""), "builds nothing"},
        {MODEL("", C, ITEM("2")), "no object 2"},
        {MODEL("", C, ITEM("0")), "objectid"},
        {MODEL("", C, ITEM("-1")), "objectid"},
        {MODEL("", C, ITEM("2147483648")), "objectid"},
        {MODEL("", C, ITEM("1.0")), "objectid"},
        {MODEL("", C, "<item/>"), "objectid"},
        {MODEL("", C C, I), "two objects 1"},
        {MODEL("", OBJECT("", CORNER), I), "id is missing"},
        {MODEL("", "<object id=\"1\" type=\"thing\">" CORNER "</object>", I), "type"},
        {MODEL("", OBJECT("1", ""), I), "neither"},
        {MODEL("", OBJECT("1", CORNER CORNER), I), "two meshes"},
        {MODEL("", C OBJECT("2", CORNER "<components><component objectid=\"1\"/></components>"), I),
         "both"},
        {MODEL("", OBJECT("1", MESH(VERTEX VERTEX VERTEX, "")), I), "no triangles"},
        {MODEL("", OBJECT("1", MESH(VERTEX VERTEX, TRIANGLE)), I), "names vertex 2"},
        {MODEL("", OBJECT("1", MESH("<vertex x=\"0\" y=\"0\"/>", TRIANGLE)), I), "z is missing"},
        {MODEL("", OBJECT("1", MESH("<vertex x=\"nan\" y=\"0\" z=\"0\"/>", "")), I), "x is"},
        {MODEL("", OBJECT("1", MESH("<vertex x=\"0\" y=\"-inf\" z=\"0\"/>", "")), I), "y is"},
        {MODEL("", OBJECT("1", MESH("<vertex x=\"0\" y=\"0\" z=\"1e999\"/>", "")), I), "z is"},
        {MODEL("unit=\"meter\"", OBJECT("1", MESH("<vertex x=\"0\" y=\"0\" z=\"1e307\"/>", "")), I),
         "z is"},
        {MODEL("", OBJECT("1", MESH("<vertex x=\"0\" y=\"0\" z=\"1 2\"/>", "")), I), "z is"},
        {MODEL("", OBJECT("1", MESH("<vertex x=\"0,5\" y=\"0\" z=\"1\"/>", "")), I), "x is"},
        {MODEL("", C, "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0\"/>"), "transform"},
        {MODEL("", C, "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 0 0\"/>"),
         "transform"},
        {MODEL("", C, "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 0 0 0 0\"/>"), "transform"},
        {MODEL("", C, "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 nan\"/>"),
         "transform"},
        {MODEL("", "<m:colorgroup id=\"1\"><m:color color=\"red\"/></m:colorgroup>" C, I),
         "color is"},
        {MODEL("", "<m:colorgroup id=\"1\"><m:color color=\"#GG0000\"/></m:colorgroup>" C, I),
         "color is"},
        {MODEL("", "<basematerials id=\"1\"><base displaycolor=\"#000000\"/></basematerials>", I),
         "name is"},
        {MODEL("", "<m:colorgroup id=\"1\"/><m:colorgroup id=\"1\"/>", I), "one number"},
        {MODEL("",
               "<m:colorgroup id=\"3\"><m:color color=\"#000000\"/></m:colorgroup>"
               "<object id=\"1\" pid=\"3\" pindex=\"1\">" CORNER "</object>",
               I),
         "its group does not have"},
    };
    for (size_t i = 0; i < sizeof broken / sizeof broken[0]; i++) {
        CHECK(model_refused(broken[i].model, SF_ERR_FORMAT, broken[i].words));
    }
}

#define SLICES(inside)                                                                             \
    MODEL("",                                                                                      \
          "<s:slicestack id=\"3\" zbottom=\"1\">" inside "</s:slicestack>"                         \
          "<object id=\"1\" s:slicestackid=\"3\">" CORNER "</object>",                             \
          I)
#define SQUARE                                                                                     \
    "<s:vertices><s:vertex x=\"0\" y=\"0\"/><s:vertex x=\"1\" y=\"0\"/>"                           \
    "<s:vertex x=\"1\" y=\"1\"/></s:vertices>"

static void refuses_broken_slices(void)
{
    static const struct {
        const char *model, *words;
    } broken[] = {
        {SLICES("<s:slice ztop=\"1\"/>"), "ztop"},
        {SLICES("<s:slice/>"), "ztop"},
        {SLICES("<s:slice ztop=\"2\"/><s:slice ztop=\"2\"/>"), "ztop"},
        {SLICES("<s:slice ztop=\"2\">" SQUARE "<s:polygon startv=\"3\"/></s:slice>"), "a point"},
        {SLICES("<s:slice ztop=\"2\">" SQUARE "<s:polygon startv=\"0\"><s:segment v2=\"1\"/>"
                "<s:segment v2=\"2\"/></s:polygon></s:slice>"),
         "open"},
        {SLICES("<s:slice ztop=\"2\">" SQUARE "<s:polygon startv=\"0\"/></s:slice>"), "open"},
        {SLICES("<s:slice ztop=\"2\"><s:vertices><s:vertex x=\"inf\" y=\"0\"/></s:vertices>"
                "</s:slice>"),
         "x is"},
        {SLICES("<s:slice ztop=\"2\"/><s:sliceref slicestackid=\"3\" slicepath=\"/a\"/>"),
         "both slices and"},
        {SLICES("<s:sliceref slicestackid=\"3\"/>"), "slicepath"},
        {SLICES("<s:sliceref slicestackid=\"3\" slicepath=\"/3D/3dmodel.model\"/>"), "references"},
        {SLICES("<s:sliceref slicestackid=\"4\" slicepath=\"/3D/3dmodel.model\"/>"),
         "no stack of slices 4"},
        {MODEL("", "<object id=\"1\" s:slicestackid=\"3\">" CORNER "</object>", I),
         "no stack of slices 3"},
    };
    for (size_t i = 0; i < sizeof broken / sizeof broken[0]; i++) {
        CHECK(model_refused(broken[i].model, SF_ERR_FORMAT, broken[i].words));
    }
}

static void refuses_paths_that_lead_out(void)
{
    static const char *const paths[] = {"/../../etc/passwd",
                                        "/3D/../../x",
                                        "/3D/./x",
                                        "//etc/x",
                                        "/3D//x",
                                        "/",
                                        "",
                                        "x",
                                        "/3D\\..\\x",
                                        "/c:/x",
                                        "/a b",
                                        "/\xc3\xa4",
                                        "/3D/x/..",
                                        "http://example.com/x"};
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++) {
        char model[1024];
        snprintf(model, sizeof model, MODEL("", "", "<item objectid=\"1\" p:path=\"%s\"/>"),
                 paths[i]);
        CHECK(model_refused(model, SF_ERR_FORMAT, "leads out"));
    }
    static archive a;
    memset(&a, 0, sizeof a);
    archive_add(&a, "_rels/.rels", RELS("../3D/3dmodel.model"));
    archive_end(&a);
    CHECK(refused(&a, NULL, SF_ERR_FORMAT, "leads out"));
}

static void refuses_entities(void)
{
    CHECK(model_refused("<!DOCTYPE m [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]><m>&b;</m>",
                        SF_ERR_FORMAT, "DOCTYPE"));
    CHECK(
        model_refused("<!DOCTYPE m SYSTEM \"file:///etc/passwd\"><m/>", SF_ERR_FORMAT, "DOCTYPE"));
    CHECK(model_refused("<model " CORE_NS ">&passwd;</model>", SF_ERR_FORMAT, "undefined entity"));
}

static void refuses_cycles(void)
{
#define HOLDS(id, other) OBJECT(id, "<components><component objectid=\"" other "\"/></components>")
    CHECK(model_refused(MODEL("", HOLDS("1", "1"), I), SF_ERR_FORMAT, "contains itself"));
    CHECK(model_refused(MODEL("", HOLDS("1", "2") HOLDS("2", "3") HOLDS("3", "1"), I),
                        SF_ERR_FORMAT, "contains itself"));
    // A hundred levels; and ten objects, each ten times the one before.
    static char model[60000];
    size_t n = (size_t)snprintf(model, sizeof model, "<model " CORE_NS "><resources>" C);
    for (int i = 2; i <= 100; i++) {
        n += (size_t)snprintf(model + n, sizeof model - n,
                              "<object id=\"%d\"><components><component objectid=\"%d\"/>"
                              "</components></object>",
                              i, i - 1);
    }
    snprintf(model + n, sizeof model - n,
             "</resources><build><item objectid=\"100\"/></build></model>");
    CHECK(model_refused(model, SF_ERR_FORMAT, "too deep"));
    n = (size_t)snprintf(model, sizeof model, "<model " CORE_NS "><resources>" C);
    for (int i = 2; i <= 11; i++) {
        n += (size_t)snprintf(model + n, sizeof model - n, "<object id=\"%d\"><components>", i);
        for (int k = 0; k < 10; k++) {
            n += (size_t)snprintf(model + n, sizeof model - n, "<component objectid=\"%d\"/>",
                                  i - 1);
        }
        n += (size_t)snprintf(model + n, sizeof model - n, "</components></object>");
    }
    snprintf(model + n, sizeof model - n,
             "</resources><build><item objectid=\"11\"/></build></model>");
    CHECK(model_refused(model, SF_ERR_OVERFLOW, "100000 objects"));
}

static void refuses_bad_archives(void)
{
    static archive a;
    memset(&a, 0, sizeof a);
    CHECK(refused(&a, NULL, SF_ERR_FORMAT, "no zip archive"));
    archive_end(&a);
    CHECK(refused(&a, NULL, SF_ERR_FORMAT, ".rels"));
    memset(&a, 0, sizeof a);
    archive_add(&a, "_rels/.rels", "<a/>");
    archive_end(&a);
    CHECK(refused(&a, NULL, SF_ERR_FORMAT, "no 3D model"));
    memset(&a, 0, sizeof a);
    archive_add(&a, "_rels/.rels", RELS("/3D/3dmodel.model"));
    archive_add(&a, "3D/3dmodel.model", MODEL("", C, I));
    archive_add(&a, "3D/3DMODEL.model", MODEL("", C, I));
    archive_end(&a);
    CHECK(refused(&a, NULL, SF_ERR_FORMAT, "two parts"));
    memset(&a, 0, sizeof a);
    archive_add(&a, "_rels/.rels", RELS("/3D/3dmodel.model"));
    archive_add_as(&a, "3D/3dmodel.model", "x", 1, 1, 1, 0);
    archive_end(&a);
    CHECK(refused(&a, NULL, SF_ERR_UNSUPPORTED, "encrypted"));
    memset(&a, 0, sizeof a);
    archive_add(&a, "_rels/.rels", RELS("/3D/3dmodel.model"));
    archive_add_as(&a, "3D/3dmodel.model", "x", 1, 1, 0, 12);
    archive_end(&a);
    CHECK(refused(&a, NULL, SF_ERR_UNSUPPORTED, "method 12"));
}

static void holds_to_limits(void)
{
    static archive a;
    archive_model(&a, MODEL("", C OBJECT("2", CORNER), I ITEM("2") ITEM("2")));
    sf_read_limits limits = sf_read_limits_default();
    limits.triangles_max = 7;
    CHECK(refused(&a, &limits, SF_ERR_OVERFLOW, "triangles_max"));
    limits = sf_read_limits_default();
    limits.vertices_max = 7;
    CHECK(refused(&a, &limits, SF_ERR_OVERFLOW, "vertices_max"));
    limits = sf_read_limits_default();
    limits.bytes_max = a.size - 1;
    CHECK(refused(&a, &limits, SF_ERR_OVERFLOW, "bytes_max"));
    // What is built is counted place by place.
    sf_threemf *document = NULL;
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    limits = sf_read_limits_default();
    limits.triangles_max = 11;
    CHECK_EQ(archive_read(&a, &limits, NULL, &document, NULL), SF_OK);
    CHECK_EQ(sf_threemf_merge(document, &limits, NULL, &mesh, &fault), SF_ERR_OVERFLOW);
    CHECK(mesh == NULL && strstr(fault.message, "triangles_max") != NULL);
    limits.triangles_max = 12;
    limits.vertices_max = 11;
    CHECK_EQ(sf_threemf_merge(document, &limits, NULL, &mesh, &fault), SF_ERR_OVERFLOW);
    limits.vertices_max = 12;
    CHECK_EQ(sf_threemf_merge(document, &limits, NULL, &mesh, &fault), SF_OK);
    sf_mesh_destroy(mesh);
    sf_threemf_destroy(document);
}

static sf_status broken_read(void *user, void *data, size_t capacity, size_t *size)
{
    int *how = user;
    memset(data, 'x', capacity < 8 ? capacity : 8);
    *size = *how ? capacity + 1 : 0;
    return *how ? SF_OK : SF_ERR_CANCELLED;
}

static void passes_on_what_a_source_says(void)
{
    for (int how = 0; how < 2; how++) {
        sf_source source = {broken_read, &how};
        sf_threemf *document = NULL;
        CHECK_EQ(sf_threemf_read(source, NULL, NULL, &document, NULL),
                 how ? SF_ERR_IO : SF_ERR_CANCELLED);
        CHECK(document == NULL);
    }
    sf_source none = {NULL, NULL};
    sf_threemf *document = NULL;
    CHECK_EQ(sf_threemf_read(none, NULL, NULL, &document, NULL), SF_ERR_ARGUMENT);
    sf_mesh *mesh = NULL;
    CHECK_EQ(sf_threemf_merge(NULL, NULL, NULL, &mesh, NULL), SF_ERR_ARGUMENT);
    sf_threemf_destroy(NULL);
    CHECK_EQ(sf_threemf_get_view(NULL).object_count, 0);
}

int main(void)
{
    if (!sf_threemf_is_served()) {
        TEST(passes_on_what_a_source_says);
        return test_finish();
    }
    TEST(refuses_what_it_cannot_read);
    TEST(refuses_broken_models);
    TEST(refuses_broken_slices);
    TEST(refuses_paths_that_lead_out);
    TEST(refuses_entities);
    TEST(refuses_cycles);
    TEST(refuses_bad_archives);
    TEST(holds_to_limits);
    TEST(passes_on_what_a_source_says);
    return test_finish();
}

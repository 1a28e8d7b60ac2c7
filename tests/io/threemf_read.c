// SPDX-License-Identifier: MIT
// What a 3MF file says is what is read: units, components, transforms, parts of their own,
// materials and colours, in the words of the specification. Guards: issue 8 part 1.

#include "stored_zip.h"

static sf_threemf *read_model(const char *model)
{
    static archive a;
    sf_threemf *document = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    archive_model(&a, model);
    CHECK_EQ(archive_read(&a, NULL, NULL, &document, &fault), SF_OK);
    if (document == NULL) {
        printf("# %s\n", fault.message);
    }
    return document;
}

static double volume_of(const sf_threemf *document, double centre[3])
{
    sf_mesh *mesh = NULL;
    sf_mass mass = {0};
    CHECK_EQ(sf_threemf_merge(document, NULL, NULL, &mesh, NULL), SF_OK);
    CHECK_EQ(sf_mesh_measure(sf_mesh_get_view(mesh), &mass), SF_OK);
    sf_mesh_destroy(mesh);
    memcpy(centre, mass.com_mm, 3 * sizeof(double));
    return mass.volume_mm3;
}

static void reads_units(void)
{
    static const struct {
        const char *model;
        double mm;
    } units[] = {
        {MODEL("", OBJECT("1", CORNER), ITEM("1")), 1},
        {MODEL("unit=\"micron\"", OBJECT("1", CORNER), ITEM("1")), 1e-3},
        {MODEL("unit=\"millimeter\"", OBJECT("1", CORNER), ITEM("1")), 1},
        {MODEL("unit=\"centimeter\"", OBJECT("1", CORNER), ITEM("1")), 10},
        {MODEL("unit=\"inch\"", OBJECT("1", CORNER), ITEM("1")), 25.4},
        {MODEL("unit=\"foot\"", OBJECT("1", CORNER), ITEM("1")), 304.8},
        {MODEL("unit=\"meter\"", OBJECT("1", CORNER), ITEM("1")), 1000},
    };
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        double centre[3], mm = units[i].mm;
        sf_threemf *document = read_model(units[i].model);
        double volume = volume_of(document, centre);
        CHECK_NEAR(volume, mm * mm * mm / 6, 1e-12 * mm * mm * mm);
        CHECK_NEAR(centre[1], mm / 4, 1e-12 * mm);
        sf_threemf_destroy(document);
    }
}

// x' = x m00 + y m10 + z m20 + m30: a row times a matrix, the numbers row after row. Here x becomes
// 2 y, y becomes -x and z becomes 3 z, in inches, and then all moves by (10, 20, 30) inches.
static void reads_transforms(void)
{
    sf_threemf *document =
        read_model(MODEL("unit=\"inch\"", OBJECT("7", CORNER),
                         "<item objectid=\"7\" transform=\" 0 2 0 -1 0 0  0 0 3\t10 20 30 \"/>"));
    double centre[3], in = 25.4;
    CHECK_NEAR(volume_of(document, centre), in * in * in, 1e-9);
    CHECK_NEAR(centre[0], in * (10 - 0.25), 1e-9);
    CHECK_NEAR(centre[1], in * (20 + 0.5), 1e-9);
    CHECK_NEAR(centre[2], in * (30 + 0.75), 1e-9);
    sf_threemf_destroy(document);
    // One that mirrors turns triangles, so that the inside stays inside.
    document = read_model(MODEL("", OBJECT("1", CORNER),
                                "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>"));
    CHECK_NEAR(volume_of(document, centre), 1.0 / 6, 1e-12);
    CHECK_NEAR(centre[0], -0.25, 1e-12);
    sf_threemf_destroy(document);
}

// A part of a part of a part: the innermost transform comes first.
static void reads_components(void)
{
    sf_threemf *document = read_model(MODEL(
        "",
        OBJECT("1", CORNER) OBJECT(
            "2", "<components><component objectid=\"1\" transform=\"2 0 0 0 2 0 0 0 2 1 0 0\"/>"
                 "<component objectid=\"1\"/></components>")
            OBJECT("3", "<components><component objectid=\"2\" "
                        "transform=\"1 0 0 0 1 0 0 0 1 0 100 0\"/></components>"),
        "<item objectid=\"3\" transform=\"3 0 0 0 3 0 0 0 3 0 0 0\"/>" ITEM("1")));
    sf_threemf_view view = sf_threemf_get_view(document);
    double centre[3];
    CHECK_EQ(view.object_count, 1);
    CHECK_EQ(view.item_count, 3);
    if (view.item_count == 3) {
        const sf_transform *t = &view.items[0].placed;
        CHECK_NEAR(t->matrix[0], 6, 0);
        CHECK_NEAR(t->shift_mm[0], 3, 0);
        CHECK_NEAR(t->shift_mm[1], 300, 0);
        CHECK_NEAR(view.items[1].placed.matrix[4], 3, 0);
        CHECK_NEAR(view.items[2].placed.matrix[4], 1, 0);
    }
    CHECK_NEAR(volume_of(document, centre), (216 + 27 + 1) / 6.0, 1e-9);
    sf_threemf_destroy(document);
}

static void reads_other_parts(void)
{
    static archive a;
    sf_threemf *document = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    double centre[3];
    memset(&a, 0, sizeof a);
    // The relationship's path may lack its slash, and capitals tell no parts apart.
    archive_add(&a, "_rels/.rels", RELS("3d/3DModel.model"));
    archive_add(&a, "3D/3dmodel.model",
                MODEL("requiredextensions=\"p\"",
                      OBJECT("5", "<components><component objectid=\"1\" "
                                  "p:path=\"/3D/Objects/one.model\"/></components>"),
                      ITEM("5") "<item objectid=\"1\" p:path=\"/3D/Objects/one.model\"/>"));
    archive_add(&a, "3D/Objects/one.model",
                MODEL("unit=\"centimeter\"", OBJECT("1", CORNER), ITEM("1")));
    archive_end(&a);
    CHECK_EQ(archive_read(&a, NULL, NULL, &document, &fault), SF_OK);
    CHECK_STR(fault.message, "");
    CHECK_EQ(sf_threemf_get_view(document).item_count, 2);
    CHECK_NEAR(volume_of(document, centre), 2000 / 6.0, 1e-9);
    sf_threemf_destroy(document);
}

#define COLOURS                                                                                    \
    "<basematerials id=\"4\"><base name=\"Steel &amp; more\" displaycolor=\"#0A0b0C\"/>"           \
    "<base name=\"Gum\" displaycolor=\"#11223344\"/></basematerials>"                              \
    "<m:colorgroup id=\"9\"><m:color color=\"#FF0000\"/><m:color color=\"#00FF0080\"/>"            \
    "</m:colorgroup>"
#define COLOURED                                                                                   \
    "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"           \
    "<vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices><triangles>"     \
    "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\" p1=\"0\"/>"        \
    "<triangle v1=\"0\" v2=\"3\" v3=\"2\" pid=\"9\" p1=\"1\" p2=\"0\"/>"                           \
    "<triangle v1=\"1\" v2=\"2\" v3=\"3\" pid=\"77\" p1=\"3\"/></triangles></mesh>"

static void reads_colours(void)
{
    sf_threemf *document = read_model(MODEL(
        "", COLOURS "<object id=\"1\" pid=\"4\" pindex=\"1\">" COLOURED "</object>", ITEM("1")));
    sf_threemf_view view = sf_threemf_get_view(document);
    CHECK_EQ(view.colour_count, 4);
    CHECK_EQ(view.object_count, 1);
    if (view.colour_count == 4 && view.object_count == 1) {
        static const uint32_t expected[12] = {
            1, 1, 1, 0, 0, 0, 3, 2, 3, SF_THREEMF_NONE, SF_THREEMF_NONE, SF_THREEMF_NONE};
        static const uint8_t steel[4] = {10, 11, 12, 255}, green[4] = {0, 255, 0, 128};
        CHECK_STR(view.colours[0].name, "Steel & more");
        CHECK_STR(view.colours[3].name, "");
        CHECK(memcmp(view.colours[0].rgba, steel, 4) == 0);
        CHECK(memcmp(view.colours[3].rgba, green, 4) == 0);
        CHECK_EQ(view.colours[1].group, 0);
        CHECK_EQ(view.colours[2].group, 1);
        CHECK(view.objects[0].colours != NULL &&
              memcmp(view.objects[0].colours, expected, sizeof expected) == 0);
    }
    sf_threemf_destroy(document);
    document = read_model(MODEL("", OBJECT("1", CORNER), ITEM("1")));
    CHECK(sf_threemf_get_view(document).objects[0].colours == NULL);
    sf_threemf_destroy(document);
}

// What a printer's program makes solid is no part of the shape; what is solid already, is.
static void reads_kinds(void)
{
    sf_threemf *document = read_model(
        MODEL("",
              OBJECT("1", CORNER) "<object id=\"2\" type=\"support\">" CORNER "</object>"
                                  "<object id=\"3\" type=\"solidsupport\">" CORNER "</object>"
                                  "<object id=\"4\" type=\"surface\">" CORNER "</object>",
              ITEM("1") ITEM("2") ITEM("3") ITEM("4")));
    sf_threemf_view view = sf_threemf_get_view(document);
    double centre[3];
    CHECK_EQ(view.item_count, 4);
    CHECK_EQ(view.objects[1].kind, SF_THREEMF_SUPPORT);
    CHECK_EQ(view.objects[2].kind, SF_THREEMF_SOLID_SUPPORT);
    CHECK_EQ(view.objects[3].kind, SF_THREEMF_SURFACE);
    CHECK_NEAR(volume_of(document, centre), 2 / 6.0, 1e-12);
    sf_threemf_destroy(document);
}

// Metadata says anything, and unknown elements hold anything.
static void passes_over_the_rest(void)
{
    sf_threemf *document =
        read_model("<?xml version=\"1.0\"?><!-- a comment --><model " CORE_NS
                   " xmlns:q=\"urn:q\"><metadata name=\"q:post_process\">rm -rf "
                   "/</metadata><resources>"
                   "<q:texture path=\"../../etc/passwd\"><q:object/></q:texture>" OBJECT(
                       "1", "<metadatagroup><metadata "
                            "name=\"a\">b</metadata></metadatagroup>" CORNER) "</"
                                                                              "resources><build><"
                                                                              "item objectid=\"1\" "
                                                                              "printable=\"0\"/></"
                                                                              "build></model>");
    double centre[3];
    CHECK_NEAR(volume_of(document, centre), 1.0 / 6, 1e-12);
    sf_threemf_destroy(document);
}

static void says_that_it_is_left_out(void)
{
    static archive a;
    sf_threemf *document = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    archive_model(&a, MODEL("", OBJECT("1", CORNER), ITEM("1")));
    CHECK_EQ(archive_read(&a, NULL, NULL, &document, &fault), SF_ERR_UNSUPPORTED);
    CHECK(strstr(fault.message, "expat") != NULL && document == NULL);
}

int main(void)
{
    if (!sf_threemf_is_served()) {
        TEST(says_that_it_is_left_out);
        return test_finish();
    }
    TEST(reads_units);
    TEST(reads_transforms);
    TEST(reads_components);
    TEST(reads_other_parts);
    TEST(reads_colours);
    TEST(reads_kinds);
    TEST(passes_over_the_rest);
    return test_finish();
}

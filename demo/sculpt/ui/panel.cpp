// SPDX-License-Identifier: MIT
// The panel beside the shape, by Dear ImGui.

#include "panel.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <cstdio>
#include <cstring>
#include <new>

#include "app/work.h"
#include "outlet.h"
#include "panel_balance.h"
#include "panel_grade.h"

struct panel {
    char path[PANEL_PATH_SIZE];
    bool shows_help;
};

namespace {

bool section(const char *name, bool is_open)
{
    return ImGui::CollapsingHeader(name, is_open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

void choose_kind(const outlet &out, const editor *e)
{
    static const char *const says[SF_BRUSH_KIND_COUNT] = {
        "adds what is carried; touches nothing else",
        "removes what carries nothing",
        "adds, and grows what it needs below",
        "removes, and what then hangs falls",
        "levels bumps and dents",
        "gives another material"};
    for (int k = 0; k < SF_BRUSH_KIND_COUNT; k++) {
        char name[48];
        snprintf(name, sizeof name, "%d  %s", k + 1,
                 sf_brush_kind_name(static_cast<sf_brush_kind>(k)));
        if (ImGui::RadioButton(name, e->brush.kind == k)) {
            out.set(SET_KIND, k);
        }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", says[k]);
        }
    }
}

void choose_material(const outlet &out, const editor *e)
{
    for (int i = 0; i < VIEW_PALETTE_COUNT; i++) {
        const unsigned char *c = view_palette[i];
        char name[16];
        snprintf(name, sizeof name, "material %d", i + 1);
        bool is_chosen = e->brush.material == i + 1;
        if (i % 8 != 0) {
            ImGui::SameLine(0, 4);
        }
        ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, is_chosen ? 2.5f : 0.0f);
        ImGui::PushStyleColor(ImGuiCol_Border, ImVec4(1, 1, 1, 1));
        if (ImGui::ColorButton(name, ImVec4(c[0] / 255.0f, c[1] / 255.0f, c[2] / 255.0f, 1),
                               ImGuiColorEditFlags_NoTooltip)) {
            out.set(SET_MATERIAL, i + 1);
        }
        ImGui::PopStyleColor();
        ImGui::PopStyleVar();
    }
}

void show_brush(const outlet &out, const editor *e)
{
    static const char *const shapes[5] = {"sphere", "box", "cylinder", "cone", "a mesh"};
    static const char *const planes[4] = {"on the shape", "plane across x", "plane across y",
                                          "level plane"};
    int passes = static_cast<int>(e->brush.passes), plane = e->brush.plane + 1;
    choose_kind(out, e);
    ImGui::Spacing();
    ImGui::PushItemWidth(150);
    out.choose("shape", e->brush.shape, shapes, e->tip_mesh != nullptr ? 5 : 4, SET_SHAPE);
    out.slide("radius", e->brush.radius_mm, 0.2, 24, "%.1f mm", SET_RADIUS, true);
    if (e->brush.kind == SF_BRUSH_SMOOTH_TRIM && ImGui::SliderInt("passes", &passes, 1, 16)) {
        out.set(SET_PASSES, passes);
    }
    if (ImGui::Combo("draw", &plane, planes, 4)) {
        out.set(SET_PLANE, plane - 1);
    }
    ImGui::PopItemWidth();
    choose_material(out, e);
    out.flag("mirror x", e->brush.mirror_x, SET_MIRROR_X);
    ImGui::SameLine();
    out.flag("mirror y", e->brush.mirror_y, SET_MIRROR_Y);
}

void show_view(const outlet &out, const editor *e)
{
    const view_overlays &o = e->overlays;
    sf_lattice l = sf_sculpt_options_of(e->model).lattice;
    out.flag("ground", o.ground, SET_GROUND);
    ImGui::SameLine(120);
    out.flag("shadows", o.shadows, SET_SHADOWS);
    out.flag("overhangs", o.overhangs, SET_OVERHANGS);
    ImGui::SameLine(120);
    out.flag("ghosts", o.ghosts, SET_GHOSTS);
    out.flag("cut", o.is_cut, SET_CUT);
    if (o.is_cut) {
        const double low[3] = {l.origin_mm[0], l.origin_mm[1], l.origin_mm[2]};
        const double size[3] = {l.nx * l.pitch_x_mm, l.ny * l.pitch_y_mm, l.nz * l.layer_mm};
        ImGui::SameLine(60);
        ImGui::PushItemWidth(140);
        out.slide("##cut", o.cut_mm, low[o.cut_axis], low[o.cut_axis] + size[o.cut_axis], "%.1f mm",
                  SET_CUT_MM);
        ImGui::PopItemWidth();
        ImGui::SameLine();
        if (ImGui::SmallButton(o.cut_axis == 0 ? "x" : o.cut_axis == 1 ? "y" : "z")) {
            out.set(SET_CUT_AXIS, (o.cut_axis + 1) % 3);
        }
    }
}

void show_history(const outlet &out, const editor *e)
{
    sf_sculpt_history h = sf_sculpt_history_of(e->model);
    if (ImGui::Button("undo") && h.undo_count > 0) {
        out.act(DO_UNDO);
    }
    ImGui::SameLine();
    if (ImGui::Button("redo") && h.redo_count > 0) {
        out.act(DO_REDO);
    }
    ImGui::SameLine();
    if (ImGui::Button("show all")) {
        out.act(DO_FRAME);
    }
    ImGui::SameLine();
    if (ImGui::Button("clear")) {
        out.act(DO_CLEAR);
    }
    if (sf_sculpt_options_of(e->model).keep_drawn != 0 && ImGui::Button("let the ghosts go")) {
        out.act(DO_DROP_GHOSTS);
    }
    ImGui::TextDisabled("%zu steps, %.1f MB", h.undo_count, static_cast<double>(h.size) / 1e6);
}

// The workspaces that this build has; nothing where there is one.
void show_works(const outlet &out, const editor *e)
{
    static const char *const names[WORK_COUNT] = {"sculpt", "balance", "grade"};
    for (int i = 0; i < WORK_COUNT; i++) {
        if (work_name(static_cast<workspace>(i)) == nullptr) {
            continue;
        }
        if (i > 0) {
            ImGui::SameLine();
        }
        if (ImGui::RadioButton(names[i], e->work == i)) {
            out.set(SET_WORK, i);
        }
    }
    ImGui::Separator();
}

void show_files(panel *p, panel_request *request)
{
    ImGui::PushItemWidth(-1);
    ImGui::InputTextWithHint("##path", "path: .session .stl .obj .ply .3mf .png, or a folder",
                             p->path, sizeof p->path);
    ImGui::PopItemWidth();
    const struct {
        const char *name, *says;
        panel_wish wish;
    } buttons[5] = {{"open", "a mesh or a session", WISH_OPEN},
                    {"brush", "a mesh as the brush's shape", WISH_BRUSH},
                    {"save", "the session", WISH_SESSION},
                    {"export", "a mesh by its name, or a folder of layers", WISH_SHAPE},
                    {"picture", "what is seen, as PNG", WISH_PICTURE}};
    for (int i = 0; i < 5; i++) {
        if (i > 0) {
            ImGui::SameLine(0, 4);
        }
        if (ImGui::Button(buttons[i].name) && p->path[0] != '\0') {
            request->wish = buttons[i].wish;
            std::memcpy(request->path, p->path, sizeof request->path);
        }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", buttons[i].says);
        }
    }
}

void show_state(const editor *e)
{
    const sf_sculpt_change &c = e->change;
    ImGui::TextDisabled("+%llu  -%llu  fell %llu  kept %llu",
                        static_cast<unsigned long long>(c.added_voxels),
                        static_cast<unsigned long long>(c.removed_voxels),
                        static_cast<unsigned long long>(c.lost_voxels),
                        static_cast<unsigned long long>(c.kept_back_voxels));
    if (e->has_place) {
        ImGui::TextDisabled("%.1f  %.1f  %.1f mm", e->at_mm[0], e->at_mm[1], e->at_mm[2]);
    }
}

void say(const char *said)
{
    if (said[0] != '\0') {
        ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1, 0.55f, 0.35f, 1));
        ImGui::TextWrapped("%s", said);
        ImGui::PopStyleColor();
    }
}

void show_sculpting(const outlet &out, const editor *e)
{
    if (section("Brush", true)) {
        show_brush(out, e);
    }
    if (section("View", true)) {
        show_view(out, e);
    }
    if (section("History", true)) {
        show_history(out, e);
    }
}

// The workspace's own part of the panel.
void show_work(const outlet &out, const editor *e)
{
    switch (e->work) {
    case WORK_BALANCE:
        panel_balance(out, editor_desk(e));
        break;
    case WORK_GRADE:
        panel_grade(out, editor_desk(e));
        break;
    default:
        show_sculpting(out, e);
    }
}

void show_bottom(const editor *e, double frame_ms)
{
    ImGui::Separator();
    if (editor_desk(e) == nullptr) {
        show_state(e);
    }
    ImGui::TextDisabled("frame %.1f ms", frame_ms);
    say(e->said);
    if (editor_desk(e) != nullptr) {
        say(editor_desk(e)->said);
    }
}

void show_sculpting_keys()
{
    static const char *const lines[][2] = {
        {"left", "brush"},
        {"control + left", "the other way: remove instead of add"},
        {"shift + left", "smooth"},
        {"right, alt + left", "turn"},
        {"middle, shift + right", "move"},
        {"wheel", "nearer, farther"},
#ifdef SCULPT_HAVE_SPACE
        {"SpaceMouse", "the shape in the hand; undo, fit"},
#endif
        {"[  ]", "smaller, larger brush"},
        {"1 to 6", "kind of brush"},
        {"X  Y", "mirrors"},
        {"P", "sketch plane, through the last place"},
        {"C", "cut"},
        {"O  G", "overhangs, ground"},
        {"F", "show all"},
        {"control + Z", "undo; with shift, redo"},
        {"escape", "give up the stroke"}};
    show_pairs(lines, static_cast<int>(sizeof lines / sizeof *lines));
}

void show_keys(const editor *e)
{
    switch (e->work) {
    case WORK_BALANCE:
        panel_balance_keys();
        break;
    case WORK_GRADE:
        panel_grade_keys();
        break;
    default:
        show_sculpting_keys();
    }
}

void style(float scale)
{
    ImGuiStyle &s = ImGui::GetStyle();
    ImGui::StyleColorsDark();
    s.WindowRounding = 6;
    s.FrameRounding = 3;
    s.WindowPadding = ImVec2(12, 10);
    s.ItemSpacing = ImVec2(7, 5);
    s.Colors[ImGuiCol_WindowBg] = ImVec4(0.13f, 0.14f, 0.16f, 0.94f);
    s.Colors[ImGuiCol_CheckMark] = s.Colors[ImGuiCol_SliderGrab] = ImVec4(0.95f, 0.72f, 0.25f, 1);
    s.Colors[ImGuiCol_TitleBgActive] = s.Colors[ImGuiCol_TitleBg] = ImVec4(0.17f, 0.18f, 0.21f, 1);
    s.Colors[ImGuiCol_Header] = ImVec4(0.24f, 0.26f, 0.30f, 1);
    s.Colors[ImGuiCol_Button] = s.Colors[ImGuiCol_FrameBg] = ImVec4(0.24f, 0.26f, 0.30f, 1);
    s.ScaleAllSizes(scale);
    ImGui::GetIO().FontGlobalScale = scale;
    ImGui::GetIO().IniFilename = nullptr;
}

} // namespace

extern "C" panel *panel_create(struct GLFWwindow *window, float scale)
{
    panel *p = new (std::nothrow) panel();
    if (p == nullptr) {
        return nullptr;
    }
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    style(scale);
    if (!ImGui_ImplGlfw_InitForOpenGL(window, true) || !ImGui_ImplOpenGL3_Init("#version 450")) {
        ImGui::DestroyContext();
        delete p;
        return nullptr;
    }
    return p;
}

extern "C" void panel_destroy(panel *p)
{
    if (p != nullptr) {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
        delete p;
    }
}

extern "C" void panel_draw(panel *p, const editor *e, double frame_ms,
                           void (*emit)(void *user, const app_event *event), void *user,
                           panel_request *request)
{
    const outlet out = {emit, user};
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    ImGui::SetNextWindowPos(ImVec2(12, 12), ImGuiCond_Once);
    ImGui::SetNextWindowSize(ImVec2(292, 0), ImGuiCond_Once);
    if (ImGui::Begin("libsf sculpt", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
        show_works(out, e);
        show_work(out, e);
        if (section("Files", false)) {
            show_files(p, request);
        }
        if (section("Keys", false)) {
            show_keys(e);
        }
        show_bottom(e, frame_ms);
    }
    ImGui::End();
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

extern "C" int panel_has_pointer(const panel *p)
{
    return p != nullptr && ImGui::GetIO().WantCaptureMouse;
}

extern "C" int panel_has_keys(const panel *p)
{
    return p != nullptr && ImGui::GetIO().WantTextInput;
}

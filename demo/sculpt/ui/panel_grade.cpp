// SPDX-License-Identifier: MIT
// The panel's part for the Grade workspace: the property, what is done to it, the cut and the
// print.

#include "panel_grade.h"

#include <cstdio>

extern "C" {
#include "grade/grade_desk.h"
#include "shade.h"
}

namespace {

bool section(const char *name)
{
    return ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_DefaultOpen);
}

// "kg m^-3"; nothing where the property is a bare number.
void write_unit(const sf_property &p, char *to, size_t size)
{
    static const char *const names[7] = {"m", "kg", "s", "A", "K", "mol", "cd"};
    size_t at = 0;
    to[0] = '\0';
    for (int i = 0; i < 7 && at < size; i++) {
        if (p.si[i] == 1) {
            at += static_cast<size_t>(std::snprintf(to + at, size - at, " %s", names[i]));
        } else if (p.si[i] != 0) {
            at +=
                static_cast<size_t>(std::snprintf(to + at, size - at, " %s^%d", names[i], p.si[i]));
        }
    }
}

// The colours with their numbers.
void show_colours(const grade_state &s)
{
    const sf_property &p = s.cage.channels[s.channel].property;
    ImDrawList *list = ImGui::GetWindowDrawList();
    ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = 250, height = 12;
    for (int i = 0; i < 50; i++) {
        uint8_t c[3];
        shade_of((i + 0.5) / 50, 1, c);
        list->AddRectFilled(ImVec2(at.x + width * static_cast<float>(i) / 50, at.y),
                            ImVec2(at.x + width * static_cast<float>(i + 1) / 50, at.y + height),
                            IM_COL32(c[0], c[1], c[2], 255));
    }
    ImGui::Dummy(ImVec2(width, height));
    char unit[64];
    write_unit(p, unit, sizeof unit);
    ImGui::TextDisabled("%s: %.4g to %.4g%s", p.name, s.low, s.high, unit);
}

void choose_channel(const outlet &out, const grade_state &s)
{
    for (size_t i = 0; i < s.cage.channel_count && s.cage.channel_count > 1; i++) {
        if (ImGui::RadioButton(s.cage.channels[i].property.name, s.channel == i)) {
            out.set(GRADE_CHANNEL, static_cast<double>(i));
        }
    }
}

void show_tool(const outlet &out, const grade_state &s)
{
    static const char *const tools[GRADE_TOOL_COUNT] = {"1  select points", "2  brush",
                                                        "3  move points"};
    for (int i = 0; i < GRADE_TOOL_COUNT; i++) {
        if (ImGui::RadioButton(tools[i], s.tool == i)) {
            out.set(GRADE_TOOL, i);
        }
    }
}

void show_paint(const outlet &out, const grade_state &s)
{
    static const char *const operations[3] = {"set to", "add", "smooth by"};
    static const char *const falloffs[4] = {"constant", "linear", "smooth", "a Gaussian's"};
    static const char *const wheres[3] = {"all points", "those outside", "those inside"};
    double size = 0, least = s.low, most = s.high;
    for (int i = 0; i < 3; i++) {
        size = s.high_mm[i] - s.low_mm[i] > size ? s.high_mm[i] - s.low_mm[i] : size;
    }
    out.choose("what", s.operation, operations, 3, GRADE_OPERATION);
    const sf_property &p = s.cage.channels[s.channel].property;
    if (s.operation == SF_PAINT_SET) {
        least = p.low > -1e30 && p.low < least ? p.low : least;
        most = p.high < 1e30 && p.high > most ? p.high : most;
    } else if (s.operation == SF_PAINT_ADD) {
        least = s.low - s.high;
        most = s.high - s.low;
    } else {
        least = 0;
        most = 1;
    }
    out.slide("amount", s.amount, least, most, "%.4g", GRADE_AMOUNT);
    if (s.tool == GRADE_BRUSH) {
        out.slide("radius", s.brush.radius_mm, 0.01 * size, size, "%.3g mm", GRADE_RADIUS, true);
        out.choose("falls", s.brush.falloff, falloffs, 4, GRADE_FALLOFF);
        out.choose("takes", s.brush.where, wheres, 3, GRADE_WHERE);
        return;
    }
    ImGui::TextDisabled("%zu of %zu points selected", s.selected_count, s.cage.point_count);
    out.button("apply", GRADE_APPLY);
    ImGui::SameLine();
    out.button("all", GRADE_ALL);
    ImGui::SameLine();
    out.button("none", GRADE_NONE);
    ImGui::SameLine();
    out.button("smooth places", GRADE_SMOOTH_PLACES);
}

void show_cut(const outlet &out, const grade_state &s)
{
    static const char *const axes[3] = {"across x", "across y", "across z"};
    out.flag("cut open", s.is_cut, GRADE_CUT);
    ImGui::SameLine(120);
    out.flag("cage", s.shows_cage, GRADE_CAGE);
    if (!s.is_cut || s.cage.dimension != 3) {
        return;
    }
    double low = s.low_mm[s.cut_axis], high = s.high_mm[s.cut_axis];
    char format[48];
    std::snprintf(format, sizeof format, "%.2f mm", low + s.cut_share * (high - low));
    out.choose("plane", s.cut_axis, axes, 3, GRADE_CUT_AXIS);
    out.slide("at", s.cut_share, 0, 1, format, GRADE_CUT_SHARE);
    out.flag("keep what is beyond", s.keeps_beyond, GRADE_CUT_SIDE);
}

void show_print(const outlet &out, const grade_state &s)
{
    out.slide("materials", s.materials, 2, GRADE_MATERIALS_MAX, "%.0f", GRADE_MATERIALS);
    out.slide("voxels", s.resolution, 32, 400, "%.0f along it", GRADE_RESOLUTION);
    uint64_t all = 0;
    for (uint64_t count : s.counts) {
        all += count;
    }
    for (uint32_t m = 0; m < s.materials && all > 0 && s.is_cut; m++) {
        ImGui::TextDisabled("material %u: %.1f %% of the slice", m + 1,
                            100 * static_cast<double>(s.counts[m]) / static_cast<double>(all));
    }
}

} // namespace

void panel_grade(const outlet &out, const desk *d)
{
    const grade_state &s = *grade_desk_state(d);
    show_tool(out, s);
    ImGui::PushItemWidth(150);
    if (section("Property")) {
        choose_channel(out, s);
        show_colours(s);
    }
    if (section("Paint")) {
        show_paint(out, s);
    }
    if (section("Cut")) {
        show_cut(out, s);
    }
    if (section("Print")) {
        show_print(out, s);
    }
    ImGui::PopItemWidth();
    ImGui::Separator();
    out.button("undo", DO_UNDO);
    ImGui::SameLine();
    out.button("redo", DO_REDO);
    ImGui::SameLine();
    ImGui::TextDisabled("%zu step%s", s.history.undo_count, s.history.undo_count == 1 ? "" : "s");
}

void panel_grade_keys()
{
    static const char *const lines[][2] = {{"left", "what the tool says"},
                                           {"shift + left", "select as well, or no more"},
                                           {"right, alt + left", "turn"},
                                           {"middle, shift + right", "move"},
                                           {"wheel", "nearer, farther"},
                                           {"1 to 3", "tools"},
                                           {"space", "apply to what is selected"},
                                           {"A", "select all, or none"},
                                           {"S", "smooth the selected places"},
                                           {"[  ]", "smaller, larger brush"},
                                           {"C  V  B", "cut, its axis, its side"},
                                           {"H", "the cage"},
                                           {"F", "show all"},
                                           {"control + Z", "undo; with shift, redo"},
                                           {"escape", "give up the stroke"}};
    show_pairs(lines, static_cast<int>(sizeof lines / sizeof *lines));
}

// SPDX-License-Identifier: MIT
// The panel's part for the Balance workspace: how it shall rest, what may be done to it, how far it
// has come.

#include "panel_balance.h"

#include <cmath>

extern "C" {
#include "balance/balance_desk.h"
}

namespace {

const double DEGREES = 180 / 3.14159265358979323846;

bool section(const char *name)
{
    return ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_DefaultOpen);
}

void choose_tool(const outlet &out, const balance_state &s)
{
    static const char *const names[BALANCE_TOOL_COUNT][2] = {
        {"1  move handles", "select one and drag it; it keeps its place then"},
        {"2  put a handle", "into the middle of the solid behind the pointer"},
        {"3  stand on a face", "with shift: on that as well"},
        {"4  hang from a point", "with shift: from that as well"}};
    for (int i = 0; i < BALANCE_TOOL_COUNT; i++) {
        if (ImGui::RadioButton(names[i][0], s.tool == i)) {
            out.set(BALANCE_TOOL, i);
        }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", names[i][1]);
        }
    }
}

void show_stance(const outlet &out, const balance_state &s)
{
    out.slide("tilt", s.plan.gamma_deg, 0, 30, "%.1f degrees", BALANCE_GAMMA);
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("how far the ground may tilt before it falls");
    }
    for (size_t i = 0; i < s.plan.stance_count; i++) {
        bool hangs = s.plan.stances[i].kind == SF_STANCE_HANG;
        ImGui::TextDisabled("%zu: %s, %.2f degrees", i + 1, hangs ? "hangs, off by" : "stands",
                            hangs ? -s.verdicts[i].margin_rad * DEGREES
                                  : s.verdicts[i].margin_rad * DEGREES);
    }
    if (s.plan.stance_count > 1) {
        out.button("the first one alone", BALANCE_ONE_STANCE);
    }
}

void show_means(const outlet &out, const balance_state &s)
{
    static const char *const carvings[3] = {"solid", "carved", "carved in planes"};
    out.choose("inside", s.plan.carving, carvings, 3, BALANCE_CARVING);
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("carved: cavities print without supports inside; in planes: as much as\n"
                          "there is, whose ceilings may hang");
    }
    out.slide("wall", s.plan.wall_mm, 0.005 * s.size_mm, 0.1 * s.size_mm, "%.2f mm", BALANCE_WALL,
              true);
    out.slide("voxels", s.plan.resolution, 24, 128, "%.0f along it", BALANCE_RESOLUTION);
    out.flag("may bend", s.plan.bends, BALANCE_BENDS);
    ImGui::SameLine(120);
    out.flag("hull of glass", s.shows_glass, BALANCE_GLASS);
}

void show_handles(const outlet &out, const balance_state &s)
{
    out.slide("count", s.wanted, 1, BALANCE_HANDLES_MAX, "%.0f", BALANCE_COUNT);
    out.button("place them", BALANCE_PLACE);
    if (s.selected < 0) {
        ImGui::SameLine();
        ImGui::TextDisabled("%zu there", s.plan.handle_count);
        return;
    }
    const balance_handle &h = s.plan.handles[s.selected];
    ImGui::SameLine();
    out.button(h.locked ? "let go" : "lock", BALANCE_LOCK);
    ImGui::SameLine();
    out.button("remove", BALANCE_REMOVE);
    if (h.locked) {
        out.slide("scale", h.pose.scale, 0.5, 2, "%.2f", BALANCE_SCALE);
        ImGui::TextDisabled("moved %.1f  %.1f  %.1f mm", h.pose.shift_mm[0], h.pose.shift_mm[1],
                            h.pose.shift_mm[2]);
    }
}

void show_verdict(const balance_state &s)
{
    const ImVec4 good(0.45f, 0.82f, 0.5f, 1), bad(1, 0.45f, 0.38f, 1);
    ImGui::PushStyleColor(ImGuiCol_Text, s.safe ? good : bad);
    ImGui::Text("%s: %.2f degrees",
                s.safe     ? "rests safely"
                : s.stands ? "rests, barely"
                           : "falls",
                s.margin_rad * DEGREES);
    ImGui::PopStyleColor();
    ImGui::TextDisabled("at first %.2f", s.before_rad * DEGREES);
    ImGui::TextDisabled("centre of mass %.1f  %.1f  %.1f mm", s.com_mm[0], s.com_mm[1],
                        s.com_mm[2]);
    if (s.has_report) {
        ImGui::TextDisabled("round %u%s, %.0f mm3 carved", s.report.rounds,
                            s.report.ended ? ", the last" : "", s.report.carved_mm3);
        ImGui::TextDisabled("moved by %.1f %% of its size",
                            100 * s.report.displacement_mm / s.size_mm);
        if (s.report.hanging_voxels > 0) {
            ImGui::TextDisabled("%llu voxels hang inside",
                                static_cast<unsigned long long>(s.report.hanging_voxels));
        }
    }
}

void show_runs(const outlet &out, const balance_state &s)
{
    out.button(s.is_running ? "stop" : "run", BALANCE_RUN);
    ImGui::SameLine();
    out.button("one round", BALANCE_ROUND);
    ImGui::SameLine();
    out.button("anew", DO_CLEAR);
    ImGui::SameLine();
    out.button("undo", DO_UNDO);
    ImGui::SameLine();
    out.button("redo", DO_REDO);
}

} // namespace

void panel_balance(const outlet &out, const desk *d)
{
    const balance_state &s = *balance_desk_state(d);
    choose_tool(out, s);
    ImGui::PushItemWidth(150);
    if (section("How it rests")) {
        show_stance(out, s);
    }
    if (section("What may be done")) {
        show_means(out, s);
    }
    if (section("Handles")) {
        show_handles(out, s);
    }
    ImGui::PopItemWidth();
    ImGui::Separator();
    show_runs(out, s);
    show_verdict(s);
}

void panel_balance_keys()
{
    static const char *const lines[][2] = {{"left", "what the tool says"},
                                           {"shift + drag", "a handle up and down"},
                                           {"control + drag", "it grows or shrinks"},
                                           {"right, alt + left", "turn"},
                                           {"middle, shift + right", "move"},
                                           {"wheel", "nearer, farther"},
                                           {"1 to 4", "tools"},
                                           {"space", "run, stop"},
                                           {"N", "one round"},
                                           {"A", "place handles"},
                                           {"L  X", "lock, remove a handle"},
                                           {"[  ]", "its size"},
                                           {"H", "hull of glass"},
                                           {"F", "show all"},
                                           {"control + Z", "undo; with shift, redo"}};
    show_pairs(lines, static_cast<int>(sizeof lines / sizeof *lines));
}

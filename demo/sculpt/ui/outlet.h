// SPDX-License-Identifier: MIT
// Where what a person sets in the panel goes: out as events.

#ifndef SCULPT_UI_OUTLET_H
#define SCULPT_UI_OUTLET_H

#include <imgui.h>

#include "app/event.h"

struct outlet {
    void (*emit)(void *user, const app_event *event);
    void *user;

    void set(int setting, double x) const
    {
        const app_event event = {EVENT_SET, setting, 0, x, 0, 0, 0, 0};
        emit(user, &event);
    }
    void act(int action) const
    {
        const app_event event = {EVENT_DO, action, 0, 0, 0, 0, 0, 0};
        emit(user, &event);
    }

    // A box to tick, and a button.
    void flag(const char *name, int value, int setting) const
    {
        bool now = value != 0;
        if (ImGui::Checkbox(name, &now)) {
            set(setting, now ? 1 : 0);
        }
    }
    void button(const char *name, int action) const
    {
        if (ImGui::Button(name)) {
            act(action);
        }
    }

    // A number on a scale that is linear, or logarithmic where it says so; `format` as printf has
    // it.
    void slide(const char *name, double value, double low, double high, const char *format,
               int setting, bool is_logarithmic = false) const
    {
        float now = static_cast<float>(value);
        if (ImGui::SliderFloat(name, &now, static_cast<float>(low), static_cast<float>(high),
                               format, is_logarithmic ? ImGuiSliderFlags_Logarithmic : 0)) {
            set(setting, static_cast<double>(now));
        }
    }

    // One of some names, counted from 0.
    void choose(const char *name, int value, const char *const *names, int count, int setting) const
    {
        int now = value;
        if (ImGui::Combo(name, &now, names, count)) {
            set(setting, now);
        }
    }
};

// What keys and the mouse do: pairs of words.
static inline void show_pairs(const char *const (*lines)[2], int count)
{
    for (int i = 0; i < count; i++) {
        ImGui::TextUnformatted(lines[i][0]);
        ImGui::SameLine(150);
        ImGui::TextDisabled("%s", lines[i][1]);
    }
}

#endif

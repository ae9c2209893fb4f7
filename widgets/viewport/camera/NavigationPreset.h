// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace handwheel {

// The presets of mouse navigation; some imitate the programs after which they are named.
enum class NavigationPreset { Handwheel, Blender, FreeCad, SolidWorks, Laptop };
inline constexpr std::array kNavigationPresets{NavigationPreset::Handwheel, NavigationPreset::Blender,
                                               NavigationPreset::FreeCad, NavigationPreset::SolidWorks,
                                               NavigationPreset::Laptop};

// The camera motions that a mouse drag can control.
enum class NavigationGesture { None, Orbit, Pan, Zoom };

// The gesture of a drag with exactly these buttons and modifiers. The modifiers are Shift, Ctrl and Alt.
struct NavigationBinding {
  Qt::MouseButtons buttons;
  Qt::KeyboardModifiers modifiers;
  NavigationGesture gesture;
  bool onBackground = false;  // true: valid only for drags that start beside the model
};

// Returns the mouse bindings of a preset.
std::span<const NavigationBinding> bindingsOf(NavigationPreset preset);
// Returns the gesture that a preset assigns to buttons and modifiers.
NavigationGesture gestureFor(NavigationPreset preset, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers,
                             bool onBackground);
// Returns true if the wheel zooms in when turned away from the user, not towards.
bool wheelAwayEnlarges(NavigationPreset preset);

// Converts between presets and their ids for settings: "handwheel", "blender", "freecad", "solidworks", "laptop". An
// unknown id is converted to the preset Handwheel.
QString idOf(NavigationPreset preset);
NavigationPreset presetOf(const QString& id);
// Returns the name of a preset for menus, translated.
QString nameOf(NavigationPreset preset);
// Returns the translated navigation hints of a preset: pairs of input and effect, such as "Shift+middle", "pan".
std::vector<std::pair<QString, QString>> navigationHints(NavigationPreset preset);

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace handwheel {

// Whose habits the mouse follows when it moves the camera.
enum class NavigationPreset { Handwheel, Blender, FreeCad, SolidWorks, Laptop };
inline constexpr std::array kNavigationPresets{NavigationPreset::Handwheel, NavigationPreset::Blender,
                                               NavigationPreset::FreeCad, NavigationPreset::SolidWorks,
                                               NavigationPreset::Laptop};

enum class NavigationGesture { None, Orbit, Pan, Zoom };

// What dragging with exactly these buttons and keys (Shift, Ctrl, Alt) does.
struct NavigationBinding {
  Qt::MouseButtons buttons;
  Qt::KeyboardModifiers modifiers;
  NavigationGesture gesture;
  bool onBackground = false;  // only where the drag begins beside the model
};

std::span<const NavigationBinding> bindingsOf(NavigationPreset preset);
NavigationGesture gestureFor(NavigationPreset preset, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers,
                             bool onBackground);
// Whether the wheel enlarges when it is turned away from the user, or towards.
bool wheelAwayEnlarges(NavigationPreset preset);

// For settings: "handwheel", "blender", "freecad", "solidworks", "laptop". An id that is none of these gives Handwheel.
QString idOf(NavigationPreset preset);
NavigationPreset presetOf(const QString& id);
// For menus, translated.
QString nameOf(NavigationPreset preset);
// How the camera is moved, in a few pairs of input and effect: "Shift+middle", "pan". Translated.
std::vector<std::pair<QString, QString>> navigationHints(NavigationPreset preset);

}  // namespace handwheel

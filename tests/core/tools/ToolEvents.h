// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/Tool.h"

// Events of a pointer over a model.
namespace handwheel::test {

using Kind = PointerEvent::Kind;

inline constexpr Modifiers kNoModifiers{};
inline constexpr Modifiers kShift{true, false, false};
inline constexpr Modifiers kControl{false, true, false};

// Returns an event whose ray comes straight down from high above (x, y). A pixel is 0.01 mm.
inline PointerEvent above(Kind kind, double x, double y, Modifiers modifiers = {}) {
  PointerEvent event;
  event.kind = kind;
  event.ray = {Vec3(x, y, 1e3), -Vec3::UnitZ()};
  event.button = kind == Kind::Hover || kind == Kind::Leave ? PointerButton::None : PointerButton::First;
  event.modifiers = modifiers;
  event.pixel = 0.01;
  return event;
}

inline const ToolAction* actionNamed(const std::vector<ToolAction>& actions, std::string_view id) {
  for (const ToolAction& action : actions)
    if (action.id == id) return &action;
  return nullptr;
}

inline bool isEnabled(const Tool& tool, std::string_view id) {
  const std::vector<ToolAction> actions = tool.actions();
  const ToolAction* action = actionNamed(actions, id);
  return action && action->enabled;
}

inline const Property* propertyNamed(const std::vector<Property>& properties, std::string_view id) {
  for (const Property& property : properties)
    if (property.id == id) return &property;
  return nullptr;
}

}  // namespace handwheel::test

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/TransformTool.h"

#include "document/mesh/MeshDocument.h"
#include "tools/ToolProperty.h"

#include <QtGlobal>
#include <algorithm>
#include <utility>

namespace handwheel {
namespace {

constexpr const char* kShiftIds[] = {"shift_x", "shift_y", "shift_z"};
constexpr const char* kTurnIds[] = {"turn_x", "turn_y", "turn_z"};
constexpr const char* kShiftLabels[] = {QT_TRANSLATE_NOOP("Property", "Move along X"),
                                        QT_TRANSLATE_NOOP("Property", "Move along Y"),
                                        QT_TRANSLATE_NOOP("Property", "Move along Z")};
constexpr const char* kTurnLabels[] = {QT_TRANSLATE_NOOP("Property", "Turn about X"),
                                       QT_TRANSLATE_NOOP("Property", "Turn about Y"),
                                       QT_TRANSLATE_NOOP("Property", "Turn about Z")};

}  // namespace

Eigen::Affine3d TransformTool::placement() const {
  return m_placement.of(m_document.defects().box);
}

ToolReply TransformTool::perform(std::string_view action) {
  if (action == "revert") {
    if (isIdle()) return ToolReply::Finished;
    m_placement = {};
    return ToolReply::Used;
  }
  if (action == "commit") {
    m_services.commit(placeChange(std::exchange(m_placement, {})));
    return ToolReply::Used;
  }
  for (const StandardPlace& standard : standardPlaces()) {
    if (action != standard.id) continue;
    m_services.commit(placeChange(standard));
    return ToolReply::Used;
  }
  return ToolReply::Ignored;
}

std::span<const ToolKey> TransformTool::keys() {
  static const std::vector<ToolKey> all = [] {
    std::vector<ToolKey> keys = {{"commit", "Return", QT_TRANSLATE_NOOP("Tool", "place so")}};
    for (const StandardPlace& standard : standardPlaces()) keys.push_back({standard.id, "", standard.effect});
    keys.push_back({"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "reset")});
    return keys;
  }();
  return all;
}

std::vector<ToolAction> TransformTool::actions() const {
  std::vector<ToolAction> all = {actionOf(keys(), "commit", !isIdle())};
  for (const StandardPlace& standard : standardPlaces()) all.push_back(actionOf(keys(), standard.id));
  all.push_back(actionOf(keys(), "revert", true, isIdle() ? QT_TRANSLATE_NOOP("Tool", "done") : nullptr));
  return all;
}

ToolPreview TransformTool::preview() const {
  ToolPreview preview;
  const Box& box = m_document.defects().box;
  if (box.isEmpty() || isIdle()) return preview;
  const Eigen::Affine3d by = placement();
  const auto corner = [&](int i) -> Vec3 { return by * box.corner(static_cast<Box::CornerType>(i)); };
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 8; ++i) {
      if ((i >> axis & 1) == 0) preview.lines.push_back({corner(i), corner(i | 1 << axis)});
    }
  }
  return preview;
}

std::vector<Property> TransformTool::settings() const {
  const Placement& p = m_placement;
  std::vector<Property> all;
  for (std::size_t i = 0; i < 3; ++i)
    all.push_back(numberSetting(kShiftIds[i], kShiftLabels[i], p.shift[i], Quantity::Length, Placement::kShift));
  for (std::size_t i = 0; i < 3; ++i)
    all.push_back(numberSetting(kTurnIds[i], kTurnLabels[i], p.turn[i], Quantity::Angle, Placement::kTurn));
  all.push_back(
      numberSetting("scale", QT_TRANSLATE_NOOP("Property", "Scale by"), p.scale, Quantity::Number, Placement::kScale));
  std::vector<std::string> units;
  for (const LengthUnit unit : Placement::kUnits) units.emplace_back(symbolOf(unit));
  const auto chosen = std::find(std::begin(Placement::kUnits), std::end(Placement::kUnits), p.unit);
  all.push_back(choiceSetting("unit", QT_TRANSLATE_NOOP("Property", "The file is in"),
                              static_cast<int>(chosen - std::begin(Placement::kUnits)), std::move(units)));
  return all;
}

void TransformTool::setSetting(std::string_view id, const PropertyValue& value) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (id == kShiftIds[i]) takeNumber(m_placement.shift[i], value, Placement::kShift);
    if (id == kTurnIds[i]) takeNumber(m_placement.turn[i], value, Placement::kTurn);
  }
  if (id == "scale") takeNumber(m_placement.scale, value, Placement::kScale);
  std::size_t unit = 0;
  if (id == "unit" && takeChoice(unit, value, static_cast<int>(std::size(Placement::kUnits))))
    m_placement.unit = Placement::kUnits[unit];
}

}  // namespace handwheel

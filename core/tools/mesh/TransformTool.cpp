// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/TransformTool.h"

#include "document/mesh/MeshDocument.h"
#include "tools/OperationSettings.h"

#include <QtGlobal>
#include <utility>

namespace handwheel {
namespace {

constexpr const char* kTransformIds[] = {"move_x", "move_y", "move_z", "turn_x", "turn_y", "turn_z", "scale", "unit"};

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
    m_services.commit(placementChange(std::exchange(m_placement, {})));
    return ToolReply::Used;
  }
  for (const StandardPlacement& standard : standardPlacements()) {
    if (action != standard.id) continue;
    m_services.commit(placementChange(standard));
    return ToolReply::Used;
  }
  return ToolReply::Ignored;
}

std::span<const ToolKey> TransformTool::keys() {
  static const std::vector<ToolKey> all = [] {
    std::vector<ToolKey> keys = {{"commit", "Return", QT_TRANSLATE_NOOP("Tool", "apply the placement")}};
    for (const StandardPlacement& standard : standardPlacements()) keys.push_back({standard.id, "", standard.effect});
    keys.push_back({"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "reset")});
    return keys;
  }();
  return all;
}

std::vector<ToolAction> TransformTool::actions() const {
  std::vector<ToolAction> all = {actionOf(keys(), "commit", !isIdle())};
  for (const StandardPlacement& standard : standardPlacements()) all.push_back(actionOf(keys(), standard.id));
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
  const OperationValues values = valuesOf(m_placement);
  std::vector<Property> all;
  for (const char* id : kTransformIds) all.push_back(settingOf(values, id));
  return all;
}

void TransformTool::setSetting(std::string_view id, const PropertyValue& value) {
  OperationValues values = valuesOf(m_placement);
  if (takeSetting(values, id, value)) m_placement = placementOf(values);
}

}  // namespace handwheel

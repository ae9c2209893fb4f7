// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/DecimateTool.h"

#include "document/mesh/MeshDocument.h"
#include "mesh/measure/MeshFidelity.h"
#include "tools/ToolProperty.h"
#include "tools/mesh/ManualMeshChanges.h"

#include <QtGlobal>
#include <cmath>
#include <numbers>

namespace handwheel {
namespace {

constexpr Limits kFaces = {4.0, 1e9};
constexpr Limits kDistance = {1e-9, 1e9};  // mm
constexpr Limits kFeatureAngle = {0.01, std::numbers::pi};
constexpr ToolKey kDecimateKeys[] = {
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "remove triangles")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "done")},
};

}  // namespace

DecimateTool::DecimateTool(MeshDocument& document, MeshServices services)
    : m_document(document), m_services(std::move(services)) {
  resetGoals();
}

// Half of what is there; the distance that was chosen for all meshes.
void DecimateTool::resetGoals() {
  m_faces = kFaces.bring(std::round(0.5 * static_cast<double>(m_document.mesh().liveFaceCount())));
  const Box& box = m_document.defects().box;
  const double share = m_document.fidelity().of(decimationErrorSetting());
  m_distance = kDistance.bring(box.isEmpty() ? 1.0 : share * box.diagonal().norm());
}

// An undo may have brought back more than the goal was set for; a goal that still makes sense stays.
void DecimateTool::documentChanged() {
  if (m_faces >= static_cast<double>(m_document.mesh().liveFaceCount())) resetGoals();
}

DecimationOptions DecimateTool::options() const {
  DecimationOptions options;
  if (m_goal == Goal::Count) {
    options.faces = static_cast<std::size_t>(m_faces);
  } else {
    options.error = m_distance;
  }
  options.keepBorders = m_keepsBorders;
  if (m_keepsCreases) options.creaseAngle = m_creaseAngle;
  options.avoidIntersections = m_avoidsCrossings;
  return options;
}

ToolReply DecimateTool::perform(std::string_view action) {
  if (action == "revert") return ToolReply::Finished;
  if (action != "commit") return ToolReply::Ignored;
  m_services.commit(decimateChange(options()));
  return ToolReply::Used;
}

std::span<const ToolKey> DecimateTool::keys() {
  return kDecimateKeys;
}

std::vector<ToolAction> DecimateTool::actions() const {
  const bool isPossible = m_goal == Goal::Distance || m_faces < static_cast<double>(m_document.mesh().liveFaceCount());
  return {actionOf(kDecimateKeys, "commit", isPossible), actionOf(kDecimateKeys, "revert")};
}

std::vector<Property> DecimateTool::settings() const {
  std::vector<Property> all;
  all.push_back(
      choiceSetting("goal", QT_TRANSLATE_NOOP("Property", "Go down to"), static_cast<int>(m_goal),
                    {QT_TRANSLATE_NOOP("Property", "A number"), QT_TRANSLATE_NOOP("Property", "A distance")}));
  if (m_goal == Goal::Count) {
    all.push_back(
        numberSetting("faces", QT_TRANSLATE_NOOP("Property", "Triangles"), m_faces, Quantity::Number, kFaces));
  } else {
    all.push_back(numberSetting("distance", QT_TRANSLATE_NOOP("Property", "Largest distance"), m_distance,
                                Quantity::Length, kDistance));
  }
  all.push_back(
      switchSetting("keeps_borders", QT_TRANSLATE_NOOP("Property", "Leave open edges as they are"), m_keepsBorders));
  all.push_back(switchSetting("keeps_creases", QT_TRANSLATE_NOOP("Property", "Keep sharp edges"), m_keepsCreases));
  if (m_keepsCreases) {
    all.push_back(numberSetting("crease_angle", QT_TRANSLATE_NOOP("Property", "Sharp from"), m_creaseAngle,
                                Quantity::Angle, kFeatureAngle));
  }
  all.push_back(
      switchSetting("avoids_crossings", QT_TRANSLATE_NOOP("Property", "Let nothing cross"), m_avoidsCrossings));
  return all;
}

void DecimateTool::setSetting(std::string_view id, const PropertyValue& value) {
  if (id == "goal") takeChoice(m_goal, value, 2);
  if (id == "faces" && takeNumber(m_faces, value, kFaces)) m_faces = std::round(m_faces);
  if (id == "distance") takeNumber(m_distance, value, kDistance);
  if (id == "keeps_borders") takeSwitch(m_keepsBorders, value);
  if (id == "keeps_creases") takeSwitch(m_keepsCreases, value);
  if (id == "crease_angle") takeNumber(m_creaseAngle, value, kFeatureAngle);
  if (id == "avoids_crossings") takeSwitch(m_avoidsCrossings, value);
}

}  // namespace handwheel

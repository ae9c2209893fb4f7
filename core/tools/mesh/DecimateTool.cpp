// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/DecimateTool.h"

#include "document/mesh/MeshDocument.h"
#include "mesh/measure/MeshFidelity.h"
#include "mesh/simplify/DecimationFidelity.h"
#include "tools/OperationSettings.h"
#include "tools/ToolProperty.h"
#include "tools/mesh/ManualMeshChanges.h"

#include <QtGlobal>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kFewestFaces = 4.0;   // fewest faces of a solid
constexpr double kUsualCrease = 0.52;  // radian
constexpr ToolKey kDecimateKeys[] = {
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "reduce triangles")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "done")},
};

}  // namespace

DecimateTool::DecimateTool(MeshDocument& document, MeshServices services)
    : m_document(document), m_services(std::move(services)) {
  m_values.setValid("keep-borders", true);
  m_values.setValid("keep-creases", kUsualCrease);
  m_values.setValid("no-crossings", true);
  m_values.setValid("method", static_cast<double>(decimationMethodOf(m_document.fidelity())));
  resetGoals();
}

// Half of what is there; the distance that was chosen for all meshes.
void DecimateTool::resetGoals() {
  setFaces(0.5 * static_cast<double>(m_document.mesh().liveFaceCount()));
  const Box& box = m_document.defects().box;
  const double share = m_document.fidelity().of(decimationErrorSetting());
  takeSetting(m_values, "error", box.isEmpty() ? 1.0 : share * box.diagonal().norm());
}

void DecimateTool::setFaces(double faces) {
  takeSetting(m_values, "faces", std::max(kFewestFaces, faces));
}

// An undo may have brought back more than the goal was set for; a goal that still makes sense stays.
void DecimateTool::documentChanged() {
  if (m_values.whole("faces") >= m_document.mesh().liveFaceCount()) resetGoals();
}

// It knows of no distance and no crossings, so these are not offered.
bool DecimateTool::isQuadric() const {
  return static_cast<DecimationMethod>(m_values.whole("method")) == DecimationMethod::Quadric;
}

DecimationOptions DecimateTool::options() const {
  OperationValues values = m_values;
  values.reset(goal() == Goal::Count ? "error" : "faces");
  if (isQuadric()) values.reset("no-crossings");
  if (!m_keepsCreases) values.reset("keep-creases");
  return decimationOptionsOf(values);
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
  const bool isFewer = goal() == Goal::Distance || m_values.whole("faces") < m_document.mesh().liveFaceCount();
  const bool isBusy = m_services.isBusy();
  ToolAction commit = actionOf(kDecimateKeys, "commit", isFewer && !isBusy);
  if (!isFewer) commit.reason = QT_TRANSLATE_NOOP("Tool", "the mesh has no more triangles than that");
  if (isBusy) commit.reason = QT_TRANSLATE_NOOP("Tool", "a job that changes this mesh is running");
  return {commit, actionOf(kDecimateKeys, "revert")};
}

std::vector<Property> DecimateTool::settings() const {
  std::vector<Property> all = {settingOf(m_values, "method")};
  if (!isQuadric())
    all.push_back(choiceSetting(
        "goal", QT_TRANSLATE_NOOP("Property", "Target"), static_cast<int>(m_goal),
        {QT_TRANSLATE_NOOP("Property", "Number of triangles"), QT_TRANSLATE_NOOP("Property", "Largest distance")}));
  all.push_back(settingOf(m_values, goal() == Goal::Count ? "faces" : "error"));
  if (goal() == Goal::Count) all.back().least = kFewestFaces;
  all.push_back(settingOf(m_values, "keep_borders"));
  all.push_back(switchSetting("has_creases", QT_TRANSLATE_NOOP("Property", "Preserve sharp edges"), m_keepsCreases));
  if (m_keepsCreases) all.push_back(settingOf(m_values, "keep_creases"));
  if (!isQuadric()) all.push_back(settingOf(m_values, "no_crossings"));
  return all;
}

void DecimateTool::setSetting(std::string_view id, const PropertyValue& value) {
  const auto* number = std::get_if<double>(&value);
  if (id == "goal") {
    assignChoice(m_goal, value, 2);
  } else if (id == "has_creases") {
    assignSwitch(m_keepsCreases, value);
  } else if (id == "faces" && number && !std::isnan(*number)) {
    setFaces(*number);
  } else {
    takeSetting(m_values, id, value);
  }
}

}  // namespace handwheel

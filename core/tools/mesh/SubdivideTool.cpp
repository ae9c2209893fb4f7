// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/SubdivideTool.h"

#include "document/mesh/MeshDocument.h"
#include "tools/OperationSettings.h"
#include "tools/mesh/ManualMeshChanges.h"

#include <QtGlobal>
#include <cmath>

namespace handwheel {
namespace {

constexpr ToolKey kSubdivideKeys[] = {
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "subdivide the mesh")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "done")},
};

}  // namespace

SubdivideTool::SubdivideTool(MeshDocument& document, MeshServices services)
    : m_document(document), m_services(std::move(services)) {}

double SubdivideTool::facesAfterwards() const {
  const SchemeSubdivision subdivision = schemeSubdivisionOf(m_values);
  return static_cast<double>(m_document.mesh().liveFaceCount()) *
         std::pow(static_cast<double>(facesOfOne(subdivision.scheme)), subdivision.times);
}

ToolReply SubdivideTool::perform(std::string_view action) {
  if (action == "revert") return ToolReply::Finished;
  if (action != "commit") return ToolReply::Ignored;
  m_services.commit(subdivideMeshChange(schemeSubdivisionOf(m_values), m_document.fileNumbers()));
  return ToolReply::Used;
}

std::span<const ToolKey> SubdivideTool::keys() {
  return kSubdivideKeys;
}

std::vector<ToolAction> SubdivideTool::actions() const {
  const bool isTooMany = facesAfterwards() > static_cast<double>(SubdivisionLimits().mostFaces);
  const bool isBusy = m_services.isBusy();
  ToolAction commit = actionOf(kSubdivideKeys, "commit", !isTooMany && !isBusy);
  if (isTooMany) commit.reason = QT_TRANSLATE_NOOP("Tool", "the result would have too many triangles");
  if (isBusy) commit.reason = QT_TRANSLATE_NOOP("Tool", "a job that changes this mesh is running");
  return {commit, actionOf(kSubdivideKeys, "revert")};
}

std::vector<Property> SubdivideTool::settings() const {
  std::vector<Property> all = {settingOf(m_values, "method"), settingOf(m_values, "times")};
  Property faces;
  faces.id = "faces";
  faces.label = QT_TRANSLATE_NOOP("Property", "Resulting triangles");
  faces.value = facesAfterwards();
  faces.editable = false;
  all.push_back(std::move(faces));
  return all;
}

void SubdivideTool::setSetting(std::string_view id, const PropertyValue& value) {
  if (id == "method" || id == "times") takeSetting(m_values, id, value);
}

}  // namespace handwheel

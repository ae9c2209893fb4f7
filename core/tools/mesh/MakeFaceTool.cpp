// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/MakeFaceTool.h"

#include "document/mesh/MeshDocument.h"
#include "tools/mesh/ManualMeshChanges.h"

#include <QtGlobal>
#include <algorithm>
#include <utility>

namespace handwheel {
namespace {

constexpr double kCornerMark = 6.0;  // pixels, radius of the mark on a point
constexpr ToolKey kMakeFaceKeys[] = {
    {"back", "Backspace", QT_TRANSLATE_NOOP("Tool", "undo the last corner")},
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "done")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "start again")},
};

}  // namespace

MakeFaceTool::MakeFaceTool(MeshDocument& document, MeshServices services)
    : m_document(document), m_services(std::move(services)), m_picking(document, m_services) {}

const HalfEdgeMesh& MakeFaceTool::mesh() const {
  return m_document.mesh();
}

ToolReply MakeFaceTool::pointer(const PointerEvent& event) {
  switch (event.kind) {
    case PointerEvent::Kind::Hover:
      hover(event);
      return ToolReply::Used;
    case PointerEvent::Kind::Leave:
      m_hovered.reset();
      return ToolReply::Used;
    case PointerEvent::Kind::Press:
    case PointerEvent::Kind::DoubleClick:
      return press(event);
    default:
      return ToolReply::Ignored;
  }
}

void MakeFaceTool::hover(const PointerEvent& event) {
  const auto point = m_picking.pointAt(event.pickRay());
  const auto vertex = point ? std::optional(mesh().from(point->at)) : std::nullopt;
  if (vertex) m_mark = kCornerMark * event.pickRay().pixelAt(mesh().position(*vertex));
  if (vertex == m_hovered) return;
  m_hovered = vertex;
  judge();
}

// Accepts clockwise clicks as well: only one orientation fits the neighbours.
void MakeFaceTool::judge() {
  m_problem = JoinProblem::NoBorder;
  const auto near = m_corners.size() == 2 && m_hovered ? m_picking.near() : nullptr;
  if (!near) return;
  m_face = {m_corners[0], m_corners[1], *m_hovered};
  HalfEdgeMesh trial = mesh();
  m_problem = addFaces(trial, {&m_face, 1}, *near);
  if (m_problem != JoinProblem::InconsistentOrientation) return;
  const Triangle turned = {m_face[0], m_face[2], m_face[1]};
  if (addFaces(trial, {&turned, 1}, *near) != JoinProblem::None) return;
  m_face = turned;
  m_problem = JoinProblem::None;
}

ToolReply MakeFaceTool::press(const PointerEvent& event) {
  if (event.device && event.button == PointerButton::Second) return perform("back");
  if (event.button != PointerButton::First) return ToolReply::Ignored;
  m_hovered.reset();
  hover(event);
  if (!m_hovered) return ToolReply::Ignored;  // the camera's
  if (m_corners.size() < 2) {
    if (std::find(m_corners.begin(), m_corners.end(), *m_hovered) == m_corners.end()) m_corners.push_back(*m_hovered);
    return ToolReply::Used;
  }
  if (m_problem != JoinProblem::None) return ToolReply::Used;
  std::vector<Vec3> positions;
  for (const Vertex v : m_face) positions.push_back(mesh().position(v));
  m_corners.clear();
  // Looked at again: by the time it is carried out the mesh may be another.
  const auto isAsKnown = [face = m_face, positions](const HalfEdgeMesh& mesh) {
    for (std::size_t k = 0; k < 3; ++k)
      if (face[k] >= mesh.vertexSlots() || mesh.position(face[k]) != positions[k]) return false;
    return true;
  };
  m_services.commit(onlyWhere(isAsKnown, faceChange(m_face)));
  return ToolReply::Used;
}

ToolReply MakeFaceTool::perform(std::string_view action) {
  if (action == "commit" || (action == "revert" && m_corners.empty())) return ToolReply::Finished;
  if (action == "revert") {
    m_corners.clear();
  } else if (action == "back" && !m_corners.empty()) {
    m_corners.pop_back();
  } else {
    return ToolReply::Ignored;
  }
  judge();
  return ToolReply::Used;
}

std::span<const ToolKey> MakeFaceTool::keys() {
  return kMakeFaceKeys;
}

std::vector<ToolAction> MakeFaceTool::actions() const {
  const char* effect = QT_TRANSLATE_NOOP("Tool", "first corner, on an open edge");
  if (m_corners.size() == 1) effect = QT_TRANSLATE_NOOP("Tool", "second corner, counter-clockwise");
  if (m_corners.size() == 2) {
    effect = QT_TRANSLATE_NOOP("Tool", "third corner: creates the face");
    if (m_hovered) effect = hintOf(m_problem, effect);
  }
  return {
      {"", QT_TRANSLATE_NOOP("ToolInput", "Click"), effect},
      actionOf(kMakeFaceKeys, "back", !m_corners.empty()),
      actionOf(kMakeFaceKeys, "commit"),
      actionOf(kMakeFaceKeys, "revert", true, m_corners.empty() ? QT_TRANSLATE_NOOP("Tool", "done") : nullptr),
  };
}

ToolPreview MakeFaceTool::preview() const {
  ToolPreview preview;
  std::vector<Vec3> line;
  for (const Vertex v : m_corners) line.push_back(mesh().position(v));
  if (m_hovered) {
    line.push_back(mesh().position(*m_hovered));
    preview.circle = {line.back(), m_mark};
  }
  if (line.size() == 3) line.push_back(line.front());
  if (line.size() > 1) preview.lines.push_back(line);
  if (m_problem != JoinProblem::None) return preview;
  TriangleSoup soup;
  for (const Vertex v : m_face) soup.points.push_back(mesh().position(v));
  soup.triangles = {{0, 1, 2}};
  DisplayPart part;
  part.name = "face";
  part.soup = std::make_shared<const TriangleSoup>(std::move(soup));
  preview.parts.push_back(std::move(part));
  return preview;
}

std::vector<Property> MakeFaceTool::settings() const {
  Property corners;
  corners.id = "corners";
  corners.label = QT_TRANSLATE_NOOP("Property", "Corners");
  corners.value = static_cast<double>(m_corners.size());
  corners.editable = false;
  if (m_corners.size() == 2 && m_hovered) corners.problem = textOf(m_problem);
  return {corners};
}

void MakeFaceTool::documentChanged() {
  m_corners.clear();
  m_hovered.reset();
  m_problem = JoinProblem::NoBorder;
}

}  // namespace handwheel

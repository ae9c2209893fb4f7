// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/boundary/BoundaryPicking.h"

#include "document/mesh/MeshDocument.h"
#include "mesh/boundary/HolePick.h"

#include <QtGlobal>

namespace handwheel {

const char* const kEdgeChanged = QT_TRANSLATE_NOOP("Tool", "the boundary has changed meanwhile");

const char* textOf(JoinProblem problem) {
  switch (problem) {
    case JoinProblem::None:
      break;
    case JoinProblem::SamePoint:
      return QT_TRANSLATE_NOOP("Property", "Two of the vertices are the same.");
    case JoinProblem::DegenerateFace:
      return QT_TRANSLATE_NOOP("Property", "A triangle would be degenerate.");
    case JoinProblem::NonManifoldEdge:
      return QT_TRANSLATE_NOOP("Property", "An edge would have more than two triangles.");
    case JoinProblem::InconsistentOrientation:
      return QT_TRANSLATE_NOOP("Property", "The adjacent triangle has the opposite orientation.");
    case JoinProblem::NonManifoldVertex:
      return QT_TRANSLATE_NOOP("Property", "It would touch the surface at a single vertex only.");
    case JoinProblem::Crosses:
      return QT_TRANSLATE_NOOP("Property", "It would intersect or touch the part.");
    case JoinProblem::FlippedFace:
      return QT_TRANSLATE_NOOP("Property", "A triangle would flip or become degenerate.");
    case JoinProblem::NoBorder:
      return QT_TRANSLATE_NOOP("Property", "There is no open edge.");
  }
  return "";
}

const char* hintOf(JoinProblem problem, const char* otherwise) {
  switch (problem) {
    case JoinProblem::None:
      break;
    case JoinProblem::SamePoint:
      return QT_TRANSLATE_NOOP("Tool", "not possible: two of the vertices are the same");
    case JoinProblem::DegenerateFace:
    case JoinProblem::FlippedFace:
      return QT_TRANSLATE_NOOP("Tool", "not possible: a triangle would flip or become degenerate");
    case JoinProblem::NonManifoldEdge:
      return QT_TRANSLATE_NOOP("Tool", "not possible: an edge would have more than two triangles");
    case JoinProblem::InconsistentOrientation:
      return QT_TRANSLATE_NOOP("Tool", "not possible: the adjacent triangle has the opposite orientation");
    case JoinProblem::NonManifoldVertex:
      return QT_TRANSLATE_NOOP("Tool", "not possible: it would touch the surface at a single vertex only");
    case JoinProblem::Crosses:
      return QT_TRANSLATE_NOOP("Tool", "not possible: it would intersect or touch the part");
    case JoinProblem::NoBorder:
      return QT_TRANSLATE_NOOP("Tool", "not possible: there is no open edge");
  }
  return otherwise;
}

std::optional<BoundaryPoint> BoundaryPicking::pointAt(const PickRay& pickRay,
                                                      const std::optional<Vec3>& without) const {
  const auto faces = m_faces();
  if (!faces) return std::nullopt;
  return pickBoundaryPoint(m_document.mesh(), m_document.defects().loops, *faces, pickRay, without);
}

std::optional<Vertex> BoundaryPicking::loopAt(const PickRay& pickRay) const {
  const auto faces = m_faces();
  if (!faces) return std::nullopt;
  const auto& loops = m_document.defects().loops;
  const auto loop = pickHole(m_document.mesh(), loops, *faces, pickRay);
  return loop ? std::optional(keyOf(m_document.mesh(), loops[*loop])) : std::nullopt;
}

std::shared_ptr<const FaceLocator> BoundaryPicking::near() {
  const auto faces = m_faces();
  if (!faces) return nullptr;
  if (!m_near || m_older != faces || m_revision != m_document.revision()) {
    m_near = std::make_shared<const FaceLocator>(m_document.mesh(), faces);
    m_older = faces;
    m_revision = m_document.revision();
  }
  return m_near;
}

}  // namespace handwheel

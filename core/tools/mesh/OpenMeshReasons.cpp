// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/OpenMeshReasons.h"

#include <QtGlobal>

namespace handwheel {

const char* reasonOf(OpenMeshRefusal refusal) {
  switch (refusal) {
    case OpenMeshRefusal::Degenerate:
      return QT_TRANSLATE_NOOP("Tool", "a triangle has the same vertex twice: remove degenerate ones first");
    case OpenMeshRefusal::DoubleEdge:
      return QT_TRANSLATE_NOOP(
          "Tool", "OpenMesh does not take two edges between the same vertices, as on a surface with one side only");
    case OpenMeshRefusal::BackToBack:
      return QT_TRANSLATE_NOOP("Tool", "OpenMesh does not take two triangles back to back: remove such debris first");
    case OpenMeshRefusal::Seam:
      return QT_TRANSLATE_NOOP("Tool", "more than two triangles meet at an edge, where the surface would tear");
    case OpenMeshRefusal::Hub:
      return QT_TRANSLATE_NOOP("Tool", "a vertex has too many triangles for this scheme: take another");
    case OpenMeshRefusal::None:
      break;
  }
  return nullptr;
}

const char* reasonOf(const SchemeOutcome& outcome) {
  if (outcome.failure == SubdivisionFailure::TooManyFaces)
    return QT_TRANSLATE_NOOP("Tool", "it would have too many triangles");
  if (outcome.failure == SubdivisionFailure::TooFine)
    return QT_TRANSLATE_NOOP("Tool", "the numbers of the file show no finer triangles");
  return reasonOf(outcome.refusal);
}

}  // namespace handwheel

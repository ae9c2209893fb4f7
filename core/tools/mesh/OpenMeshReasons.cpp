// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/OpenMeshReasons.h"

#include <QtGlobal>

namespace handwheel {

const char* reasonOf(OpenMeshRefusal refusal) {
  switch (refusal) {
    case OpenMeshRefusal::Degenerate:
      return QT_TRANSLATE_NOOP("Tool", "a triangle has a repeated vertex: remove degenerate triangles first");
    case OpenMeshRefusal::DoubleEdge:
      return QT_TRANSLATE_NOOP("Tool",
                               "OpenMesh does not support two edges between the same vertices, as on one-sided "
                               "surfaces: repair the mesh first");
    case OpenMeshRefusal::BackToBack:
      return QT_TRANSLATE_NOOP(
          "Tool", "OpenMesh does not support two triangles back to back, a plate of zero thickness: delete them first");
    case OpenMeshRefusal::Seam:
      return QT_TRANSLATE_NOOP("Tool", "more than two triangles share an edge: the surface would tear there");
    case OpenMeshRefusal::Hub:
      return QT_TRANSLATE_NOOP("Tool", "a vertex has too many triangles for this scheme: choose another");
    case OpenMeshRefusal::None:
      break;
  }
  return nullptr;
}

const char* reasonOf(const SchemeOutcome& outcome) {
  if (outcome.failure == SubdivisionFailure::TooManyFaces)
    return QT_TRANSLATE_NOOP("Tool", "the result would have too many triangles");
  if (outcome.failure == SubdivisionFailure::TooFine)
    return QT_TRANSLATE_NOOP("Tool", "the precision of the file does not allow finer triangles");
  return reasonOf(outcome.refusal);
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/sculpt/LoopSubdivision.h"

#include <memory>

namespace handwheel {

// A mesh patch with several subdivision levels, for multiresolution editing. Each level is made from the previous one
// by subdivision, and its vertices may have been moved afterwards. Each level contains a version of the whole mesh; the
// surface outside the patch is the same in all of them, and vertices and faces keep their numbers across levels. The
// detail of a finer level is its displacement from the subdivided coarser one. It is expressed in frames that follow
// the coarser level, so it moves with that level (Zorin, Schröder, Sweldens, "Interactive multiresolution mesh
// editing", 1997, without their step from a fine level back to the coarse ones, which stay unchanged). Copies are
// cheap, because they share pages and stencils.
class PatchLevels {
 public:
  PatchLevels(HalfEdgeMesh mesh, FaceSelection patch);

  // Inserts a level before the first one, to read the levels of a file from fine to coarse. If there is only one level
  // so far, its patch may be empty; the function then sets it. Returns false, without a change, if subdividing the
  // patch, with added slots from firstAdded on, does not make the first level, apart from moved vertices. Both meshes
  // must be valid.
  bool addBelow(HalfEdgeMesh mesh, FaceSelection patch, FirstSlots firstAdded);

  std::size_t finest() const { return m_levels.size() - 1; }
  const HalfEdgeMesh& mesh() const { return m_levels.back().mesh; }  // mesh at the finest level
  const HalfEdgeMesh& mesh(std::size_t level) const { return m_levels[level].mesh; }
  const FaceSelection& patch() const { return m_levels.back().patch; }
  const FaceSelection& patch(std::size_t level) const { return m_levels[level].patch; }
  // Returns the first slots that a level has in addition to the previous level. The level must not be the first.
  FirstSlots firstAdded(std::size_t level) const { return m_levels[level].step->firstAdded; }

  // Adds a finer level. A failure changes nothing.
  SubdivisionFailure refine(const SubdivisionLimits& limits = {});
  // Removes the finest level. Changes that were made at the other levels in the meantime stay. There must be at least
  // two levels.
  void coarsen() { m_levels.pop_back(); }

  // Returns the face of a level from which a face of the finest level was made; outside the patch, this is the same
  // face.
  Face faceAt(std::size_t level, Face fine) const;

  // Replaces the mesh of a level by a version with the same faces and moved vertices. Finer levels follow with their
  // detail, as far as that flips no face. Returns the faces of the finest level whose corners moved. The list is empty
  // if there is no finer level. O(finer levels of the patch).
  std::vector<Face> replace(std::size_t level, HalfEdgeMesh mesh, NumberType numbers = NumberType::Float64);

  // Applies an edit outside the patch to all levels. after: the mesh at the finest level after the edit. Coarser levels
  // get dead slots for elements of finer ones, so that added elements have the same number in all levels. Returns
  // false, without a change, if the edit changes a face of the patch or one that shares an edge with it: such a face
  // has a different neighbour at each level. Calling the function with the mesh before the edit undoes its effect.
  // O(differences + finer levels of the patch), or O(mesh) if vertices were moved.
  bool follow(const HalfEdgeMesh& after);

 private:
  struct Level {
    HalfEdgeMesh mesh;
    FaceSelection patch;
    std::shared_ptr<const SubdivisionStep> step;  // step from the previous level; null for the first
  };
  std::vector<Level> m_levels;  // never empty
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/sculpt/LoopSubdivision.h"

#include <memory>

namespace handwheel {

// A mesh patch with several subdivision levels, for multiresolution editing. Each level is made of the one before by
// subdivision, and may have been moved since. A version of the whole mesh belongs to each level; what lies outside the
// patch is the same in all of them, and vertices and faces keep their numbers from level to level. What a finer level
// has beyond the subdivided coarser one, its detail, is expressed in frames that follow the coarser one: when that is
// moved, the detail comes along (Zorin, Schröder, Sweldens, "Interactive multiresolution mesh editing", 1997, without
// their step from a fine level back to the coarse ones, which stay as they were). A value type: a copy shares its pages
// and stencils, and is cheap.
class PatchLevels {
 public:
  PatchLevels(HalfEdgeMesh mesh, FaceSelection patch);

  // Inserts a level before the first, as when levels come from a file, from fine to coarse; the patch of an only level
  // may be empty, and is set. False, and nothing changed, where subdividing the patch does not make the first level,
  // with what it adds from these slots on, but for what was moved since. Both meshes must be valid.
  bool addBelow(HalfEdgeMesh mesh, FaceSelection patch, FirstSlots firstAdded);

  std::size_t finest() const { return m_levels.size() - 1; }
  const HalfEdgeMesh& mesh() const { return m_levels.back().mesh; }  // at the finest level
  const HalfEdgeMesh& mesh(std::size_t level) const { return m_levels[level].mesh; }
  const FaceSelection& patch() const { return m_levels.back().patch; }
  const FaceSelection& patch(std::size_t level) const { return m_levels[level].patch; }
  // Where that begins which a level, not the first, has more than the one before.
  FirstSlots firstAdded(std::size_t level) const { return m_levels[level].step->firstAdded; }

  // One level more, or nothing changed.
  SubdivisionFailure refine(const SubdivisionLimits& limits = {});
  // Removes the finest level: the mesh is as it was before that was made, but for what was changed at the others since.
  // There must be one more than the first.
  void coarsen() { m_levels.pop_back(); }

  // The face of this level from which a face of the finest level was made; itself outside of the patch.
  Face faceAt(std::size_t level, Face fine) const;

  // Replaces the mesh of a level by another version: the same faces, with vertices elsewhere. Finer levels follow with
  // their detail, as far as that flips no face. Returns the faces of the finest level that were given other corners;
  // none where nothing is finer. O(finer levels of the patch).
  std::vector<Face> replace(std::size_t level, HalfEdgeMesh mesh, NumberType numbers = NumberType::Float64);

  // Takes an edit elsewhere over to all levels. after: the mesh at the finest level when it is done. Coarser levels get
  // dead slots for what only finer ones have, so that what the edit adds has one number in all. False, and nothing
  // changed, where the edit changes a face of the patch or one that shares an edge with it: such a face has another
  // neighbour at each level. The inverse edit leads back. O(what differs + finer levels of the patch), O(mesh) where
  // vertices were moved.
  bool follow(const HalfEdgeMesh& after);

 private:
  struct Level {
    HalfEdgeMesh mesh;
    FaceSelection patch;
    std::shared_ptr<const SubdivisionStep> step;  // from the level before; null for the first
  };
  std::vector<Level> m_levels;  // never empty
};

}  // namespace handwheel

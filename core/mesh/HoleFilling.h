// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/BoundaryLoops.h"
#include "mesh/HalfEdgeMesh.h"

#include <memory>
#include <string>
#include <vector>

namespace handwheel {

enum class FillMethod {
  Fair,     // refined to the density of the surroundings and bent to continue them (CGAL)
  Refined,  // refined, not bent
  Ear,      // best-first ear cutting (He 2008, section 4.3; spec step 4), no new vertices
  Minimal,  // CGAL's triangulation by dihedral angle and area, no new vertices
};

enum class FillFailure {
  None,
  Cancelled,
  Rim,                // the outer edge of an open sheet: left open unless asked
  KeptOpen,           // the user wants it open
  TooLong,            // more edges than the user allows
  NoPatch,            // no method found a triangulation
  SelfIntersecting,   // every patch would cross or touch the part
  Swelling,           // every patch would bulge out of the hole's surroundings
};

struct FillOptions {
  FillMethod method = FillMethod::Fair;
  bool tryOthers = true;  // when the chosen method gives no acceptable patch
  NumberType numbers = NumberType::Float64;
};

// A patch that may be put into the mesh: triangles over mesh vertices and new ones. Vertex numbers from
// mesh.vertexSlots() on mean newPoints.
struct Patch {
  std::vector<Vec3> newPoints;
  std::vector<Triangle> triangles;
  FillMethod method = FillMethod::Fair;
};

struct FillAttempt {
  FillFailure failure = FillFailure::None;
  Patch patch;
};

// Proposes patches for the holes of one version of a mesh. Builds the triangle hierarchy once; accepted patches are
// remembered, so later ones are checked against them too. One thread at a time.
class HoleFiller {
 public:
  explicit HoleFiller(const HalfEdgeMesh& mesh);
  ~HoleFiller();

  // A patch that closes the loop without crossing the part, itself or an accepted patch. The mesh is not changed.
  FillAttempt propose(const BoundaryLoop& loop, const FillOptions& options, Progress progress = {}) const;

  // Puts a proposed patch into the mesh that this filler was made for, or a copy of it with the same slots.
  void accept(HalfEdgeMesh& mesh, const BoundaryLoop& loop, const Patch& patch);

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

}  // namespace handwheel

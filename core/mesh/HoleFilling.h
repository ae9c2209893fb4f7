// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Tolerance.h"
#include "mesh/BoundaryLoops.h"
#include "mesh/EarCutting.h"
#include "mesh/Fairing.h"
#include "mesh/HalfEdgeMesh.h"
#include "mesh/Patch.h"
#include "mesh/PlaceKey.h"

#include <memory>
#include <set>

namespace handwheel {

enum class FillFailure {
  None,
  Cancelled,
  Rim,               // the outer edge of an open sheet: left open unless asked
  KeptOpen,          // the user wants it open
  TooLong,           // more edges than the user allows
  NoPatch,           // no method found a triangulation
  SelfIntersecting,  // every patch would cross or touch the part
  Swelling,          // every patch would bulge far out of the hole
  TooMuchEffort,     // given up: closing it takes more than a repair of such a mesh may (Effort)
};

struct FillOptions {
  FillMethod method = FillMethod::Fair;
  bool tryOthers = true;  // when the chosen method gives no acceptable patch
  bool mayCross = false;  // patches that cross or touch the part will do: who accepts them uncrosses them
  NumberType numbers = NumberType::Float64;
  double density = tolerance::kPatchDensity;  // of Fair and Refined; the setting mesh.patch_density
  // Of Fair and Ridge: the setting mesh.fill_continuity. Where no patch of curvature will do, one of tangent is tried.
  Continuity continuity = Continuity::Tangent;
  EarWeights ears = {};  // of Ear
  // A loop of more edges is cut into pieces of no more, each triangulated by itself: the setting mesh.piece_edges.
  std::size_t pieceEdges = tolerance::kPieceEdges;
  // Where it is cut, or a shorter one too; the bridges are edges of the patch unless it is refined. Empty: as
  // HoleFiller::proposeStitches() says. Along stitches that are none or cross (cutLoop()) there is no patch.
  std::vector<Stitch> stitches = {};
  // Corners of loops that are to stay open: no sheet with one gets a back, no tangle with one is taken out.
  std::set<PointKey> keptCorners = {};
};

struct FillAttempt {
  FillFailure failure = FillFailure::None;
  Patch patch;
};

// Proposes patches for the holes of one version of a mesh. Builds the triangle hierarchy once; accepted patches are
// remembered, so later ones are checked against them too. One thread at a time.
class HoleFiller {
 public:
  // Of no use once cancelled.
  explicit HoleFiller(const HalfEdgeMesh& mesh, Progress progress = {});
  ~HoleFiller();
  HoleFiller(const HoleFiller&) = delete;
  HoleFiller& operator=(const HoleFiller&) = delete;

  // A patch that closes the loop without crossing the part, itself or an accepted patch. The loop must be open still.
  FillAttempt propose(const BoundaryLoop& loop, const FillOptions& options, Progress progress = {}) const;

  // The bridges along which propose() would cut the loop into pieces; none when it is short enough.
  std::vector<Stitch> proposeStitches(const BoundaryLoop& loop, std::size_t pieceEdges = tolerance::kPieceEdges,
                                      Progress progress = {}) const;

  // Puts a proposed patch into the mesh. Only new faces and vertices appear; where the loop was pinched, its vertices
  // at the pinch become one.
  void accept(const BoundaryLoop& loop, const Patch& patch);

  // The mesh with the accepted patches.
  const HalfEdgeMesh& mesh() const;

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

// Puts a patch into a mesh, as HoleFiller::accept() does.
void putPatch(HalfEdgeMesh& mesh, const BoundaryLoop& loop, const Patch& patch);

}  // namespace handwheel

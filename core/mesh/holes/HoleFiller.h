// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Tolerance.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/holes/EarClipping.h"
#include "mesh/holes/Fairing.h"
#include "mesh/holes/Patch.h"
#include "mesh/structure/HalfEdgeMesh.h"
#include "mesh/structure/PositionKey.h"

#include <memory>
#include <set>

namespace handwheel {

// Reasons why a hole was not filled.
enum class FillFailure {
  None,
  Cancelled,
  SheetBoundary,     // outer edge of an open sheet: left open unless requested
  WasSheetBoundary,  // outer edge of a sheet that looks like a hole after changes by the repair
  KeptOpen,          // the user wants it open
  TooLong,           // more edges than the user allows
  NoPatch,           // no method found a triangulation
  SelfIntersecting,  // every patch would intersect or touch the part
  Bulging,           // every patch would bulge far out of the hole
  NarrowTriangles,   // one of the last three, perhaps caused by narrow triangles along the hole (findBoundaryNeedles())
  TooMuchEffort,     // abandoned: closing it exceeds the effort limit of the repair (Effort)
  SheetIntersecting,  // outer edge of a sheet whose body would intersect the part, however thin
  SheetTooThin,       // outer edge of a sheet: the number type of the file cannot represent its thickness
  SheetKeptOpen,      // outer edge of a sheet that has an edge the user wants open; a body has none
};

// Options of hole filling.
struct FillOptions {
  FillMethod method = FillMethod::Fair;
  bool tryOthers = true;  // try other methods if the chosen one gives no acceptable patch
  bool mayCross = false;  // accept patches that intersect or touch the part; the caller removes the intersections
  NumberType numbers = NumberType::Float64;
  double density = tolerance::kPatchDensity;  // for Fair and Refined; the setting mesh.patch_density
  // Continuity of Fair and Crease: the setting mesh.fill_continuity. If no patch with curvature continuity is
  // acceptable, one with tangent continuity is tried.
  Continuity continuity = Continuity::Tangent;
  EarWeights ears = {};  // for Ear
  // The most edges of a piece: longer loops are cut into pieces that are triangulated separately. The setting
  // mesh.piece_edges.
  std::size_t pieceEdges = tolerance::kPieceEdges;
  // The bridges along which a loop of any length is cut; they are edges of the patch unless it is refined. Empty: those
  // of HoleFiller::proposeHoleBridges(). Invalid or crossing bridges (splitHole()) give no patch.
  std::vector<HoleBridge> bridges = {};
  // Corners of loops that stay open: a sheet with one is not thickened, a folded region with one is not removed.
  std::set<PointKey> keptCorners = {};
};

// The result of an attempt to fill a hole: a patch, or the failure.
struct FillAttempt {
  FillFailure failure = FillFailure::None;
  Patch patch;
};

// Proposes patches for the holes of one version of a mesh. Builds the triangle hierarchy once; accepted patches are
// remembered, so later ones are checked against them too. One thread at a time.
class HoleFiller {
 public:
  // The result is invalid if cancelled.
  explicit HoleFiller(const HalfEdgeMesh& mesh, Progress progress = {});
  ~HoleFiller();
  HoleFiller(const HoleFiller&) = delete;
  HoleFiller& operator=(const HoleFiller&) = delete;

  // Returns a patch that closes the loop without intersecting the part, itself or an accepted patch. The loop must
  // still be open.
  FillAttempt propose(const BoundaryLoop& loop, const FillOptions& options, Progress progress = {}) const;

  // Returns the bridges along which propose() would cut the loop into pieces; none if it is short enough.
  std::vector<HoleBridge> proposeHoleBridges(const BoundaryLoop& loop, std::size_t pieceEdges = tolerance::kPieceEdges,
                                             Progress progress = {}) const;

  // Adds a proposed patch to the mesh. Only new faces and vertices appear; where the loop was pinched, its vertices at
  // the pinch become one.
  void accept(const BoundaryLoop& loop, const Patch& patch);

  // Returns the mesh with the accepted patches.
  const HalfEdgeMesh& mesh() const;

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

// Adds a patch to a mesh, as HoleFiller::accept() does.
void insertPatch(HalfEdgeMesh& mesh, const BoundaryLoop& loop, const Patch& patch);

}  // namespace handwheel

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
  SheetBoundary,      // the outer edge of an open sheet: left open unless requested
  WasSheetBoundary,   // the same of a sheet that the repair changed, so that it looks like a hole now
  KeptOpen,           // the user wants it open
  TooLong,            // more edges than the user allows
  NoPatch,            // no method found a triangulation
  SelfIntersecting,   // every patch would intersect or touch the part
  Bulging,            // every patch would bulge far out of the hole
  NarrowTriangles,    // any of the last three, with triangles along the hole that may be why: findBoundaryNeedles()
  TooMuchEffort,      // abandoned: closing it takes more than a repair of such a mesh may (Effort)
  SheetIntersecting,  // of the outer edge of a sheet: however thin, its body would intersect the part
  SheetTooThin,       // the same: the numbers of the file cannot show its thickness
  SheetKeptOpen,      // the same: the user wants an edge of the sheet open, and a body has none
};

// Options of hole filling.
struct FillOptions {
  FillMethod method = FillMethod::Fair;
  bool tryOthers = true;  // when the chosen method gives no acceptable patch
  bool mayCross = false;  // accept patches that intersect or touch the part; the caller removes the intersections
  NumberType numbers = NumberType::Float64;
  double density = tolerance::kPatchDensity;  // of Fair and Refined; the setting mesh.patch_density
  // Of Fair and Crease: the setting mesh.fill_continuity. Where no patch with curvature continuity is acceptable, one
  // with tangent continuity is tried.
  Continuity continuity = Continuity::Tangent;
  EarWeights ears = {};  // of Ear
  // A loop of more edges is cut into pieces of no more, each triangulated by itself: the setting mesh.piece_edges.
  std::size_t pieceEdges = tolerance::kPieceEdges;
  // The bridges along which it is cut, or a shorter one too; they are edges of the patch unless it is refined. Empty:
  // those of HoleFiller::proposeHoleBridges(). With bridges that are invalid or cross (splitHole()) there is no patch.
  std::vector<HoleBridge> bridges = {};
  // Corners of loops that are to stay open: no sheet with one is thickened, no folded region with one is removed.
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

  // A patch that closes the loop without intersecting the part, itself or an accepted patch. The loop must be open
  // still.
  FillAttempt propose(const BoundaryLoop& loop, const FillOptions& options, Progress progress = {}) const;

  // The bridges along which propose() would cut the loop into pieces; none when it is short enough.
  std::vector<HoleBridge> proposeHoleBridges(const BoundaryLoop& loop, std::size_t pieceEdges = tolerance::kPieceEdges,
                                             Progress progress = {}) const;

  // Adds a proposed patch to the mesh. Only new faces and vertices appear; where the loop was pinched, its vertices at
  // the pinch become one.
  void accept(const BoundaryLoop& loop, const Patch& patch);

  // The mesh with the accepted patches.
  const HalfEdgeMesh& mesh() const;

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

// Adds a patch to a mesh, as HoleFiller::accept() does.
void insertPatch(HalfEdgeMesh& mesh, const BoundaryLoop& loop, const Patch& patch);

}  // namespace handwheel

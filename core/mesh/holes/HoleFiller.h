// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Tolerance.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/holes/EarClipping.h"
#include "mesh/holes/Fairing.h"
#include "mesh/holes/Patch.h"
#include "mesh/holes/PatchGuides.h"
#include "mesh/structure/HalfEdgeMesh.h"
#include "mesh/structure/PositionKey.h"

#include <memory>
#include <set>

namespace handwheel {

// Reasons why a hole was not filled.
enum class FillFailure {
  None,
  Cancelled,
  SheetBoundary,     // outer edge of an open sheet, which stays open unless requested
  WasSheetBoundary,  // outer edge of a sheet that looks like a hole after changes by the repair
  KeptOpen,          // the user wants the hole to stay open
  TooLong,           // the loop has more edges than the user allows
  NoPatch,           // no method found a triangulation
  SelfIntersecting,  // every patch would intersect or touch the part
  Bulging,           // every patch would bulge far out of the hole
  NarrowTriangles,  // NoPatch, SelfIntersecting or Bulging, perhaps because of narrow triangles (findBoundaryNeedles())
  TooMuchEffort,    // closing the hole would exceed the effort limit of the repair (WorkBudget)
  SheetIntersecting,  // outer edge of a sheet whose body would intersect the part, however thin
  SheetTooThin,       // outer edge of a sheet whose thickness the number type of the file cannot represent
  SheetKeptOpen,      // outer edge of a sheet with a loop that the user wants open, so that it is not made a body
};

// Options of hole filling.
struct FillOptions {
  FillMethod method = FillMethod::Fair;
  bool tryOthers = true;  // try other methods if the chosen one gives no acceptable patch
  bool mayCross = false;  // accept patches that intersect or touch the part; the caller removes the intersections
  NumberType numbers = NumberType::Float64;
  double density = tolerance::kPatchDensity;  // density of Fair and Refined patches; the setting mesh.patch_density
  // Continuity of Fair and Crease patches (the setting mesh.fill_continuity). If no patch with curvature continuity is
  // acceptable, a patch with tangent continuity is tried.
  Continuity continuity = Continuity::Tangent;
  EarWeights ears = {};  // weights of FillMethod::Ear
  // The largest number of edges of a piece (the setting mesh.piece_edges). Longer loops are cut into pieces that are
  // triangulated separately.
  std::size_t pieceEdges = tolerance::kPieceEdges;
  // The bridges along which a loop of any length is cut. They are edges of the patch unless it is refined. If the list
  // is empty, the bridges of HoleFiller::proposeHoleBridges() are used. With invalid or crossing bridges (splitHole()),
  // no patch is made.
  std::vector<HoleBridge> bridges = {};
  std::vector<PatchGuide> guides = {};  // points through which Fair patches pass where they agree (guidedPoints())
  // Corners of loops that must stay open. A sheet with such a corner is not thickened, and a folded region with such a
  // corner is not removed.
  std::set<PointKey> keptCorners = {};
};

// The difference of a patch from what the options ask for.
enum class Substitute {
  None,
  LessSmooth,   // the chosen method, but less continuity with the surroundings
  OtherMethod,  // another method
};

// Returns how a patch differs from what the options ask for.
Substitute substituteIn(const Patch& patch, const FillOptions& options);

// The result of an attempt to fill a hole: a patch, or the failure.
struct FillAttempt {
  FillFailure failure = FillFailure::None;
  Patch patch;
};

// Proposes patches for the holes of one version of a mesh. It builds the triangle hierarchy once and remembers accepted
// patches, so that later ones are checked against them too. Only one thread at a time may use it.
class HoleFiller {
 public:
  // Builds the hierarchy. The object is invalid if cancelled.
  explicit HoleFiller(const HalfEdgeMesh& mesh, Progress progress = {});
  ~HoleFiller();
  HoleFiller(const HoleFiller&) = delete;
  HoleFiller& operator=(const HoleFiller&) = delete;

  // Returns a patch that closes the loop without intersecting the part, itself or an accepted patch. The loop must
  // still be open.
  FillAttempt propose(const BoundaryLoop& loop, const FillOptions& options, Progress progress = {}) const;

  // Returns the bridges along which propose() would cut the loop into pieces. The result is empty if the loop is short
  // enough.
  std::vector<HoleBridge> proposeHoleBridges(const BoundaryLoop& loop, std::size_t pieceEdges = tolerance::kPieceEdges,
                                             Progress progress = {}) const;

  // Adds a proposed patch to the mesh. The mesh only gets new faces and vertices, except that the vertices at a pinch
  // of the loop become one.
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

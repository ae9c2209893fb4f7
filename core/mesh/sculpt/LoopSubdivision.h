// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/selection/FaceSelection.h"

#include <optional>
#include <span>
#include <vector>

namespace handwheel {

// The Loop subdivision stencils of the vertices of a finer mesh. They give a vertex its place and a frame for its
// displacement from there: both follow the coarser mesh, so that detail turns with what it sits on.
class LoopStencils {
 public:
  enum class Kind : std::uint8_t {
    Fixed,  // on the outline of the patch: stays; its frame is the global one
    Inner,  // sources: itself, then its neighbours counter-clockwise
    Edge,   // sources: the ends a and b of the edge, the corners left and right of it seen from a to b
  };

  // leaving: a half-edge of the finer mesh that leaves the vertex. Sources are vertices of the coarser mesh.
  void add(Kind kind, HalfEdge leaving, std::span<const Vertex> sources);

  std::size_t size() const { return m_stencils.size(); }
  HalfEdge leaving(std::size_t i) const { return m_stencils[i].leaving; }
  void setLeaving(std::size_t i, HalfEdge h) { m_stencils[i].leaving = h; }
  bool isFixed(std::size_t i) const { return m_stencils[i].kind == Kind::Fixed; }
  std::span<const Vertex> sources(std::size_t i) const;
  // Loop's place (equations 4-1 and 4-2 of He 2008) over the coarser mesh.
  Vec3 place(const HalfEdgeMesh& coarse, std::size_t i) const;
  // A right-handed orthonormal frame over the coarser mesh, one axis to a column, the last its normal.
  Eigen::Matrix3d frame(const HalfEdgeMesh& coarse, std::size_t i) const;

 private:
  struct Stencil {
    HalfEdge leaving;
    std::uint32_t first;  // of its sources
    std::uint32_t count;
    Kind kind;
  };
  std::vector<Stencil> m_stencils;
  std::vector<Vertex> m_sources;
};

// Limits of a subdivision.
struct SubdivisionLimits {
  std::size_t mostFaces = 4'000'000;  // of the patch, afterwards
  NumberType numbers = NumberType::Float64;
  Progress progress = {};
};

// Reasons why a patch cannot be subdivided.
enum class SubdivisionFailure {
  None,
  NoEdgeInside,  // every edge of the patch is on its outline
  TooManyFaces,
  TooFine,  // the numbers of the file have no value between two vertices
  Cancelled,
};

// The first slots of what a subdivision step adds. The others follow without a gap.
struct FirstSlots {
  Vertex vertex = 0;
  Face face = 0;
};

// The result of one subdivision step.
struct SubdivisionStep {
  SubdivisionFailure failure = SubdivisionFailure::None;
  FaceSelection faces;       // the patch, finer
  LoopStencils stencils;     // one for each vertex of the finer patch
  std::vector<Face> parent;  // of the faces that were added; the others have the number of their parent
  FirstSlots firstAdded;
  std::size_t heldBack = 0;  // vertices placed nearer to the middle of their edge than Loop's place
};

// Subdivides a patch by Loop subdivision, modified as in He 2008, section 4.1.6. An edge on its outline gets no point,
// a triangle with two of them is split in two, one with one in three, along the shorter diagonal, any other in four.
// Vertices on the outline and all outside stay, bit for bit; no face gets a vertex in an edge. Where Loop's place would
// flip a face, the vertex stays nearer to where linear subdivision has it. Faces of the patch keep their number for one
// of their parts. A failure leaves the mesh as it was. O(patch).
SubdivisionStep subdivide(HalfEdgeMesh& mesh, const FaceSelection& patch, const SubdivisionLimits& limits = {});

// Recovers the subdivision step from a coarse to a fine mesh. Vertices of the latter may have been moved since; none
// where there was no such step: slot for slot, the faces must be those that subdivide() can make, but for the slots of
// those that were added. They begin with firstAdded, and are dead in the coarse mesh, or behind it.
// O(patch + pages of the mesh).
std::optional<SubdivisionStep> subdivisionBetween(const HalfEdgeMesh& coarse, const FaceSelection& patch,
                                                  const HalfEdgeMesh& fine, FirstSlots firstAdded);

// The number of subdivisions that match a patch to the density around it. Its edges are then no more than √2 times as
// long as those of the faces around it. 0 where nothing is around it.
int levelsToDensity(const HalfEdgeMesh& mesh, const FaceSelection& patch);

// The mean aspect ratio of the faces at the outline of a patch. That is the length of an edge on the outline to the
// height over it. The outline is not split, so this doubles with each level. 0 where there is no outline.
double outlineAspect(const HalfEdgeMesh& mesh, const FaceSelection& patch);
// From more levels than this on, the faces at the outline are too long to be good.
inline constexpr int kEvenLevels = 3;

}  // namespace handwheel

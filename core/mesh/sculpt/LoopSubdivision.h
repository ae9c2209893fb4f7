// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/selection/FaceSelection.h"

#include <optional>
#include <span>
#include <vector>

namespace handwheel {

// The Loop subdivision stencils of the vertices of a finer mesh. They define the position of a vertex and a frame for
// its displacement from that position. Position and frame follow the coarser mesh, so that detail rotates with it.
class LoopStencils {
 public:
  enum class Kind : std::uint8_t {
    Fixed,  // vertex on the outline of the patch, which stays; its frame is the global one
    Inner,  // vertex of the coarser mesh; sources: itself, then its neighbours counter-clockwise
    Edge,   // vertex in an edge; sources: the ends a and b of the edge, the corners left and right of it seen from a to
            // b
  };

  // Adds the stencil of a vertex. leaving: a half-edge of the finer mesh that starts at the vertex. sources: vertices
  // of the coarser mesh.
  void add(Kind kind, HalfEdge leaving, std::span<const Vertex> sources);

  std::size_t size() const { return m_stencils.size(); }
  HalfEdge leaving(std::size_t i) const { return m_stencils[i].leaving; }
  void setLeaving(std::size_t i, HalfEdge h) { m_stencils[i].leaving = h; }
  bool isFixed(std::size_t i) const { return m_stencils[i].kind == Kind::Fixed; }
  std::span<const Vertex> sources(std::size_t i) const;
  // Returns Loop's position (equations 4-1 and 4-2 of He 2008) over the coarser mesh.
  Vec3 position(const HalfEdgeMesh& coarse, std::size_t i) const;
  // Returns a right-handed orthonormal frame over the coarser mesh. Its columns are the axes, the last one the normal.
  Eigen::Matrix3d frame(const HalfEdgeMesh& coarse, std::size_t i) const;

 private:
  struct Stencil {
    HalfEdge leaving;
    std::uint32_t first;  // index of its first source
    std::uint32_t count;
    Kind kind;
  };
  std::vector<Stencil> m_stencils;
  std::vector<Vertex> m_sources;
};

// Limits of a subdivision.
struct SubdivisionLimits {
  std::size_t mostFaces = 4'000'000;  // faces of the finer patch
  NumberType numbers = NumberType::Float64;
  Progress progress = {};
};

// Reasons why a patch cannot be subdivided.
enum class SubdivisionFailure {
  None,
  NoEdgeInside,  // every edge of the patch is on its outline
  TooManyFaces,
  TooFine,      // the number type of the file has no value between two vertices
  NotManifold,  // the faces of the patch touch at a vertex without a common edge, or more than two share an edge
  Cancelled,
};

// The first slots that a subdivision step adds. The others follow without a gap.
struct FirstSlots {
  Vertex vertex = 0;
  Face face = 0;
};

// The result of one subdivision step.
struct SubdivisionStep {
  SubdivisionFailure failure = SubdivisionFailure::None;
  FaceSelection faces;       // the finer patch
  LoopStencils stencils;     // one stencil per vertex of the finer patch
  std::vector<Face> parent;  // parents of the added faces; the others have the number of their parent
  FirstSlots firstAdded;
  std::size_t heldBack = 0;  // number of vertices that stay nearer to the middle of their edge than Loop's position
};

// Subdivides a patch by Loop subdivision, modified as in He 2008, section 4.1.6. An edge on the outline of the patch
// gets no point. A triangle with two outline edges is split into two triangles, one with one outline edge into three
// along the shorter diagonal, and any other into four. Vertices on the outline and outside stay, bit for bit; no face
// gets a vertex in an edge. If Loop's position would flip a face, the vertex stays nearer to its position by linear
// subdivision. Faces of the patch keep their number for one of their parts. A failure leaves the mesh unchanged.
// O(patch).
SubdivisionStep subdivide(HalfEdgeMesh& mesh, const FaceSelection& patch, const SubdivisionLimits& limits = {});

// Recovers the subdivision step from a coarse to a fine mesh. Vertices of the fine mesh may have been moved after the
// step. Returns nothing if there was no such step: slot for slot, the faces must be those that subdivide() can make,
// except for the slots of the added faces. The slots of added elements start with firstAdded; in the coarse mesh, they
// are dead or beyond the last slot. O(patch + pages of the mesh).
std::optional<SubdivisionStep> subdivisionBetween(const HalfEdgeMesh& coarse, const FaceSelection& patch,
                                                  const HalfEdgeMesh& fine, FirstSlots firstAdded);

// Returns the mean aspect ratio of the faces at the outline of a patch. It is the length of an outline edge divided by
// the height over it. The outline is not split, so it doubles with each level. Returns 0 if there is no outline.
double outlineAspect(const HalfEdgeMesh& mesh, const FaceSelection& patch);
// The largest number of levels at which the faces at the outline are well shaped.
inline constexpr int kEvenLevels = 3;

}  // namespace handwheel

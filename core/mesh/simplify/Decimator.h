// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/FaceOctree.h"
#include "mesh/simplify/Decimation.h"
#include "mesh/simplify/ErrorTracker.h"
#include "mesh/simplify/VertexConstraints.h"

#include <queue>
#include <span>

namespace handwheel {

// Collapses edges of a mesh, the cheapest first, as decimate() describes. run() may be called once, and before
// insert().
class Decimator {
 public:
  struct Limits {
    ErrorTracker* error = nullptr;       // null: no error limit
    std::span<const Vertex> fixed = {};  // vertices that stay
  };
  Decimator(HalfEdgeMesh& mesh, const DecimationOptions& options, const Limits& limits, const Progress& progress)
      : m_mesh(mesh),
        m_options(options),
        m_error(limits.error),
        m_faces(mesh.liveFaceCount()),
        m_holds(mesh, options.keepBorders, options.creaseAngle, progress) {
    for (const Vertex v : limits.fixed) m_holds.fix(v);
  }

  // Returns false if cancelled.
  bool run(const Progress& progress);

  // Splits the edge of a face that is nearest to a point of it, by a vertex at another position. Returns the
  // box of the two faces before and after. Returns nothing, without a change, if there is no face beyond the edge, or
  // if the options or the error limit forbid it.
  std::optional<Box> insert(Face f, const Vec3& on, const Vec3& position);

 private:
  struct Candidate {
    std::uint32_t rank;  // rankOf() its cost
    HalfEdge edge;
    std::uint32_t fromStamp, toStamp;
    // The order is reversed, because the top of std::priority_queue is the largest element. Edges of one rank are taken
    // in the order of the mesh, because neighbours in it are near each other in memory, too.
    bool operator<(const Candidate& other) const { return rank != other.rank ? rank > other.rank : edge > other.edge; }
  };
  // Returns a number that does not decrease with the cost (not negative). Costs of one rank differ by less than a half.
  static std::uint32_t rankOf(double cost);

  // The effect of a change on the faces around the edge.
  struct Star {
    // All faces. Of a collapse, first those that stay, in the order of before and after, then those that are removed.
    std::vector<Face> faces;
    // Shapes of the faces that stay or are made, with the moved or new corner first, and what they were or came from.
    std::vector<TrianglePoints> before, after;
  };

  bool prepare(const Progress& progress);
  bool seed(const Progress& progress);
  bool drain(const Progress& progress);

  void offer(HalfEdge h);

  void takeStar(HalfEdge h, const Vec3& p);
  bool meetsNothing();
  bool isStarAllowed();
  bool isAllowed(HalfEdge h, const Vec3& p);
  void collapse(HalfEdge h, const Vec3& p);
  void removeFromOctree(std::span<const Face> faces);
  void addToOctree(std::span<const Face> faces);

  HalfEdgeMesh& m_mesh;
  const DecimationOptions& m_options;
  ErrorTracker* m_error;
  std::size_t m_faces;                 // number of live faces
  std::vector<std::uint32_t> m_stamp;  // numbers per vertex, incremented when its edges change
  VertexConstraints m_holds;
  std::vector<std::uint32_t> m_inStar;  // number of the last star that contained each face
  std::uint32_t m_stars = 0;
  FaceOctree m_octree;  // live faces; used only if intersections are avoided
  std::priority_queue<Candidate> m_queue;
  Star m_star;
};

}  // namespace handwheel

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

// Collapses edges of a mesh, the cheapest first, as decimate() describes. run() may be called once.
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

 private:
  struct Candidate {
    double cost;
    HalfEdge edge;
    std::uint32_t fromStamp, toStamp;
    // The order is reversed, because the top of std::priority_queue is the largest element.
    bool operator<(const Candidate& other) const { return cost != other.cost ? cost > other.cost : edge > other.edge; }
  };

  // The effect of a collapse on the faces around the edge.
  struct Star {
    // All faces: first those that stay, in the order of before and after, then those that are removed.
    std::vector<Face> faces;
    std::vector<TrianglePoints> before, after;  // shapes of the faces that stay; the moving corner comes first
  };

  bool prepare(const Progress& progress);
  bool seed(const Progress& progress);
  bool drain(const Progress& progress);

  void offer(HalfEdge h);

  void takeStar(HalfEdge h, const Vec3& p);
  bool meetsNothing();
  bool isAllowed(HalfEdge h, const Vec3& p);
  void collapse(HalfEdge h, const Vec3& p);

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

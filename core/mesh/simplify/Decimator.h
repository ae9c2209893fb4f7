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

// Collapses edges of a mesh, the cheapest first, as decimate() describes. To be run once.
class Decimator {
 public:
  struct Limits {
    ErrorTracker* error = nullptr;       // where one is asked for
    std::span<const Vertex> fixed = {};  // stay where they are
  };
  Decimator(HalfEdgeMesh& mesh, const DecimationOptions& options, const Limits& limits, const Progress& progress)
      : m_mesh(mesh),
        m_options(options),
        m_error(limits.error),
        m_faces(mesh.liveFaceCount()),
        m_holds(mesh, options.keepBorders, options.creaseAngle, progress) {
    for (const Vertex v : limits.fixed) m_holds.fix(v);
  }

  // False when cancelled.
  bool run(const Progress& progress);

 private:
  struct Candidate {
    double cost;
    HalfEdge edge;
    std::uint32_t fromStamp, toStamp;
    // For std::priority_queue, whose top is the largest.
    bool operator<(const Candidate& other) const { return cost != other.cost ? cost > other.cost : edge > other.edge; }
  };

  // What a collapse does to the faces around the edge.
  struct Star {
    std::vector<Face> faces;                    // of all: first those that stay, in the same order, then those that go
    std::vector<TrianglePoints> before, after;  // of those that stay; the corner that moves comes first
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
  std::size_t m_faces;                 // live
  std::vector<std::uint32_t> m_stamp;  // per vertex: grows when its edges change
  VertexConstraints m_holds;
  std::vector<std::uint32_t> m_inStar;  // per face: the number of the last star that it was in
  std::uint32_t m_stars = 0;
  FaceOctree m_octree;  // of the live faces, where intersections matter
  std::priority_queue<Candidate> m_queue;
  Star m_star;
};

}  // namespace handwheel

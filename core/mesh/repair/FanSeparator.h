// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/PositionKey.h"
#include "proximity/TriangleHierarchy.h"

#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace handwheel {

// Moves the vertices of single fans away from positions that other vertices share. Each vertex moves by the smallest
// step that the number type can represent and that makes no new self-intersection, to a position that no other vertex
// has. The caller must not move any vertex itself. The object is invalid after a cancellation.
class FanSeparator {
 public:
  // Builds the hierarchy in O(n log n). The cancel flag is that of `progress` during the construction, and that of
  // `watched` while vertices are moved.
  FanSeparator(HalfEdgeMesh& mesh, NumberType numbers, Progress progress, Progress watched);

  // Moves the fan's vertex away from its position. Returns false if every step would make degenerate faces or too many
  // new self-intersections.
  bool separate(const std::vector<HalfEdge>& fan);

  // Sets the total number of new self-intersections that may be made from now on.
  void mayCross(std::size_t n) { m_spare = n; }

  // Inserts a separate vertex in the middle of an edge whose end positions another pair of faces shares. Returns the
  // new vertex; returns kNone, without a change, if the vertex cannot be separated.
  Vertex separateEdge(HalfEdge h);

 private:
  struct Near {
    Face face;
    Box box;
  };
  // Some faces, and all faces that may meet one of them.
  struct Surroundings {
    std::vector<Face> faces;
    std::vector<Near> near;
  };
  struct PositionHash {
    std::size_t operator()(const PointKey& p) const;
  };

  Surroundings surroundings(std::vector<Face> faces, double move);
  void spend(std::size_t tests, std::size_t boxes);
  double longestMove(const std::vector<HalfEdge>& fan) const;
  void addHalf(Face of, Face half);
  bool separate(const std::vector<HalfEdge>& fan, const Surroundings& around, std::size_t allowed);
  std::vector<Vec3> separatingDirections(const std::vector<HalfEdge>& fan) const;
  bool hasFlatFace(const std::vector<Face>& faces) const;
  std::size_t intersections(const Surroundings& around, std::size_t most = ~std::size_t{0});

  HalfEdgeMesh& m_mesh;
  NumberType m_numbers;
  Progress m_watched;
  std::vector<Face> m_faces;  // face of each triangle in the hierarchy
  TriangleHierarchy m_hierarchy;
  std::unordered_map<Face, std::vector<Face>> m_halves;    // faces split off a face of the hierarchy
  std::unordered_map<Face, Face> m_whole;                  // inverse mapping of m_halves
  std::unordered_set<PointKey, PositionHash> m_positions;  // positions that the file will hold
  std::vector<std::uint32_t> m_seenIn;                     // number of the last search that found each face
  std::uint32_t m_search = 0;
  std::size_t m_uncounted = 0;  // boxes not yet counted as effort
  std::size_t m_spare = 0;
  double m_reach = 0.0;  // largest distance of a vertex from its position in the hierarchy
};

}  // namespace handwheel

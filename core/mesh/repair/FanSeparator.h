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

// Moves the vertices of single fans off positions that others have, too. By the smallest step that the number type can
// represent and that makes no new self-intersection, to a position that no other vertex has. Works on a mesh whose
// other vertices stay. Of no use once cancelled.
class FanSeparator {
 public:
  // watched: while vertices are moved. O(n log n).
  FanSeparator(HalfEdgeMesh& mesh, NumberType numbers, Progress progress, Progress watched);

  // Moves the fan's vertex off its position; false when every step would harm.
  bool separate(const std::vector<HalfEdge>& fan);

  // So many crossings may now be made in all.
  void mayCross(std::size_t n) { m_spare = n; }

  // Gives an edge that another pair of faces has too a vertex of its own in the middle. The new vertex; kNone, and
  // nothing changed, when that would harm.
  Vertex separateEdge(HalfEdge h);

 private:
  struct Near {
    Face face;
    Box box;
  };
  // Faces, and what else may meet one of them.
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
  std::vector<Vec3> waysOut(const std::vector<HalfEdge>& fan) const;
  bool hasFlatFace(const std::vector<Face>& faces) const;
  std::size_t intersections(const Surroundings& around, std::size_t most = ~std::size_t{0});

  HalfEdgeMesh& m_mesh;
  NumberType m_numbers;
  Progress m_watched;
  std::vector<Face> m_faces;  // of the hierarchy's triangles
  TriangleHierarchy m_hierarchy;
  std::unordered_map<Face, std::vector<Face>> m_halves;    // what was split off a face of the hierarchy
  std::unordered_map<Face, Face> m_whole;                  // the reverse
  std::unordered_set<PointKey, PositionHash> m_positions;  // that the file will hold
  std::vector<std::uint32_t> m_seenIn;                     // by face: the last search that came upon it
  std::uint32_t m_search = 0;
  std::size_t m_uncounted = 0;  // boxes
  std::size_t m_spare = 0;
  double m_reach = 0.0;  // no vertex is farther from where the hierarchy has it
};

}  // namespace handwheel

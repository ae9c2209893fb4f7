// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "mesh/boundary/Bridging.h"
#include "mesh/selection/FaceSelection.h"

#include <optional>
#include <set>

namespace handwheel {

class DefectList;
struct BoundaryLoop;

// The hole that RepairDemo repairs, with the loops that remain of it. These loops are recognised by the vertices of the
// original boundary.
class DemoHole {
 public:
  // Chooses the hole with the longest boundary; returns false if there is none.
  bool take(const HalfEdgeMesh& mesh, const DefectList& defectList);
  void forget() { m_rim.clear(); }
  bool isTaken() const { return !m_rim.empty(); }

  // The original region of the hole, and the direction from which it is seen best.
  const Box& region() const { return m_region; }
  const Vec3& outward() const { return m_outward; }

  bool holds(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) const;
  // Returns the shortest loop that remains of the hole, or null if the hole is closed.
  const BoundaryLoop* nextPart(const HalfEdgeMesh& mesh, const DefectList& defectList) const;
  // Returns the nearest two points of a loop that divide it into similar parts and can be bridged.
  static std::optional<BoundaryPair> waist(const HalfEdgeMesh& mesh, const BoundaryLoop& part);

 private:
  std::set<Vertex> m_rim;  // vertices on the rim of the original hole
  Box m_region;            // region of the original hole
  Vec3 m_outward = Vec3::Zero();
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "mesh/Bridging.h"
#include "mesh/FaceSelection.h"

#include <optional>
#include <set>

namespace handwheel {

class Inspection;
struct BoundaryLoop;

// The hole that RepairShow repairs, and what becomes of it: known again by the vertices that were on its edge.
class ShownHole {
 public:
  // The one with the longest edge; false when there is none.
  bool take(const HalfEdgeMesh& mesh, const Inspection& inspection);
  void forget() { m_rim.clear(); }
  bool isTaken() const { return !m_rim.empty(); }

  // Before anything was done: where it was, and from where it is seen best.
  const Box& place() const { return m_place; }
  const Vec3& outward() const { return m_outward; }

  bool holds(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) const;
  // The shorter of what is left of it; null when it is closed.
  const BoundaryLoop* nextPart(const HalfEdgeMesh& mesh, const Inspection& inspection) const;
  // The two points of a part nearest to each other that divide it into like parts, and between which a bridge can be
  // laid.
  static std::optional<BorderPair> waist(const HalfEdgeMesh& mesh, const BoundaryLoop& part);

 private:
  std::set<Vertex> m_rim;  // of the hole, before anything was done
  Box m_place;             // of it
  Vec3 m_outward = Vec3::Zero();
};

}  // namespace handwheel

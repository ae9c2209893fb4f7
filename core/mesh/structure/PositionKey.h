// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <algorithm>
#include <array>
#include <set>

namespace handwheel {

// Keys of points and edges by position, for sets and maps. Points of different vertices at one position are equal. The
// coordinates must be finite.
using PointKey = std::array<double, 3>;
using EdgeKey = std::array<PointKey, 2>;

inline PointKey positionKey(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

inline bool hasCornerAt(const HalfEdgeMesh& mesh, Face f, const std::set<PointKey>& positions) {
  const TrianglePoints corners = mesh.points(f);
  return std::any_of(corners.begin(), corners.end(), [&](const Vec3& p) { return positions.contains(positionKey(p)); });
}

// Returns the key of the edge between two points. It is the same for both directions.
inline EdgeKey positionKey(const Vec3& p, const Vec3& q) {
  const PointKey from = positionKey(p), to = positionKey(q);
  return from < to ? EdgeKey{from, to} : EdgeKey{to, from};
}

inline EdgeKey positionKey(const HalfEdgeMesh& mesh, HalfEdge h) {
  return positionKey(mesh.position(mesh.from(h)), mesh.position(mesh.to(h)));
}

}  // namespace handwheel

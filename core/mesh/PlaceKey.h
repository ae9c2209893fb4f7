// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HalfEdgeMesh.h"

#include <algorithm>
#include <array>
#include <set>

namespace handwheel {

// Points and edges by where they are, whatever their vertices are called: keys of sets and maps. Finite ones only.
using PointKey = std::array<double, 3>;
using EdgeKey = std::array<PointKey, 2>;

inline PointKey placeKey(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

inline bool hasCornerAt(const HalfEdgeMesh& mesh, Face f, const std::set<PointKey>& places) {
  const TrianglePoints corners = mesh.points(f);
  return std::any_of(corners.begin(), corners.end(), [&](const Vec3& p) { return places.contains(placeKey(p)); });
}

// The same for both directions.
inline EdgeKey placeKey(const Vec3& p, const Vec3& q) {
  const PointKey from = placeKey(p), to = placeKey(q);
  return from < to ? EdgeKey{from, to} : EdgeKey{to, from};
}

inline EdgeKey placeKey(const HalfEdgeMesh& mesh, HalfEdge h) {
  return placeKey(mesh.position(mesh.from(h)), mesh.position(mesh.to(h)));
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/MovedFaces.h"

#include "mesh/search/IncrementalHierarchy.h"
#include "mesh/structure/FaceNormal.h"

#include <algorithm>
#include <numeric>

namespace handwheel {
namespace {

constexpr double kSlimmest = 0.02;  // slimness() that any face may have
constexpr double kSlimmer = 0.5;    // share of its own that a slimmer one keeps

bool meet(const TrianglePoints& a, const TrianglePoints& b) {
  return !isDegenerate(a) && !isDegenerate(b) && trianglesMeet(a, b);
}

}  // namespace

double slimness(const TrianglePoints& t) {
  const Vec3 a = t[1] - t[0], b = t[2] - t[0], c = t[2] - t[1];
  const double longest = std::max({a.stableNorm(), b.stableNorm(), c.stableNorm()});
  return longest > 0.0 ? (a / longest).cross(b / longest).norm() : 0.0;
}

bool mayBecome(const TrianglePoints& before, const TrianglePoints& after) {
  const Vec3 was = unitNormal(before), is = unitNormal(after);
  if (was.isZero(0.0)) return true;
  return is.dot(was) > 0.0 && slimness(after) >= std::min(kSlimmest, kSlimmer * slimness(before));
}

bool forEachNewCrossing(const FaceLocator& near, const MovedFaces& moved,
                        const std::function<bool(std::size_t)>& visit) {
  const HalfEdgeMesh& mesh = near.mesh();
  const std::vector<Face>& faces = moved.faces;
  std::vector<Box> boxes;
  for (const TrianglePoints& t : moved.shapes) boxes.push_back(boxOf(t));
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return boxes[a].min().x() < boxes[b].min().x(); });
  for (std::size_t at = 0; at < order.size(); ++at) {
    const std::size_t i = order[at];
    const auto isNew = [&](const TrianglePoints& otherBefore, const TrianglePoints& other) {
      return meet(moved.shapes[i], other) && !meet(mesh.points(faces[i]), otherBefore);
    };
    for (std::size_t next = at + 1; next < order.size(); ++next) {
      const std::size_t k = order[next];
      if (boxes[k].min().x() > boxes[i].max().x()) break;
      if (!boxes[k].intersects(boxes[i]) || !isNew(mesh.points(faces[k]), moved.shapes[k])) continue;
      if (!visit(i) || !visit(k)) return false;
    }
    const bool goesOn = near.forEachInBox(boxes[i], [&](Face f) {
      if (std::binary_search(faces.begin(), faces.end(), f)) return true;
      const TrianglePoints other = mesh.points(f);
      return !isNew(other, other) || visit(i);
    });
    if (!goesOn) return false;
  }
  return true;
}

TriangleSoup soupOf(const std::vector<TrianglePoints>& triangles) {
  TriangleSoup soup;
  for (const TrianglePoints& t : triangles) {
    const auto n = static_cast<std::uint32_t>(soup.points.size());
    soup.points.insert(soup.points.end(), t.begin(), t.end());
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  return soup;
}

}  // namespace handwheel

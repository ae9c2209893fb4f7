// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/BoundaryPick.h"

#include <algorithm>

namespace handwheel {
namespace {

struct Candidate {
  double pixels;  // from the line of sight
  BoundaryPoint point;
};

}  // namespace

std::optional<BoundaryPoint> pickBoundaryPoint(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops,
                                               const FaceHierarchy& faces, const PickRay& pickRay,
                                               const std::optional<Vec3>& without) {
  if (!pickRay.ray.isUsable()) return std::nullopt;
  const Vec3 forward = pickRay.ray.direction.stableNormalized();
  const auto aside = [&](const Vec3& p) -> double {
    const Vec3 r = p - pickRay.ray.origin;
    return (r - r.dot(forward) * forward).norm();
  };
  std::vector<Candidate> near;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const double reach = 0.5 * loops[i].box.diagonal().norm();
    const Vec3 farthest = loops[i].box.center() + reach * forward;
    if (aside(loops[i].box.center()) > reach + kBoundaryPickRadius * pickRay.pixelAt(farthest)) continue;
    for (const HalfEdge h : loops[i].halfEdges) {
      const Vec3& p = mesh.position(mesh.from(h));
      if (p == without || (pickRay.eye && !((p - *pickRay.eye).dot(forward) > 0.0))) continue;
      const double pixels = aside(p) / pickRay.pixelAt(p);
      if (pixels <= kBoundaryPickRadius) near.push_back({pixels, {i, h}});
    }
  }
  std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.pixels < b.pixels; });
  for (const Candidate& c : near) {
    const Vec3& p = mesh.position(mesh.from(c.point.at));
    if (!faces.isHidden(p, pickRay.eye, forward, kPickHidingDepth * pickRay.pixelAt(p))) return c.point;
  }
  return std::nullopt;
}

}  // namespace handwheel

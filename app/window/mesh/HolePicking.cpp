// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/HolePicking.h"

#include <vector>

namespace handwheel {

namespace {

using Vec2 = Eigen::Vector2d;

Vec2 onScreen(const CameraState& camera, const Vec3& p) {
  return {p.dot(camera.right()), p.dot(camera.up())};
}

// Twice the signed area, and whether a ray to the right from p crosses the polygon an odd number of times.
struct Outline {
  double doubleArea = 0.0;
  bool encloses = false;
};

Outline look(const std::vector<Vec2>& polygon, const Vec2& p) {
  Outline outline;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    outline.doubleArea += a.x() * b.y() - b.x() * a.y();
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (x > p.x()) outline.encloses = !outline.encloses;
  }
  return outline;
}

}  // namespace

int loopAround(const DefectList& defectList, const CameraState& camera, const Vec3& onSight,
               const std::optional<Vec3>& hit) {
  const HalfEdgeMesh& mesh = defectList.document().mesh();
  const Vec3 towards = camera.towardsViewer();
  const Vec2 cursor = onScreen(camera, onSight);
  int best = -1;
  double least = 0.0;
  for (int id = 0; id < defectList.loopCount(); ++id) {
    const BoundaryLoop& loop = defectList.loop(id);
    if (loop.isSheetBoundary) continue;  // it surrounds the whole sheet
    if (hit && (loop.centre - *hit).dot(towards) <= 0.0) continue;
    const double reach = loop.box.diagonal().norm();
    if ((onScreen(camera, loop.centre) - cursor).norm() > reach) continue;
    std::vector<Vec2> polygon;
    for (HalfEdge h : loop.halfEdges) polygon.push_back(onScreen(camera, mesh.position(mesh.from(h))));
    const Outline outline = look(polygon, cursor);
    const double area = std::abs(outline.doubleArea);
    if (!outline.encloses || (best >= 0 && area >= least)) continue;
    best = id;
    least = area;
  }
  return best;
}

}  // namespace handwheel

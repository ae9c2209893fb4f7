// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/UnobstructedView.h"

#include "viewport/Viewport.h"
#include "viewport/camera/CameraNavigation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace handwheel {

namespace {

constexpr double kTilts[] = {30.0, 50.0, 70.0};  // degrees from outward
constexpr int kTurns = 8;                        // directions at each tilt
// Cost of a tilt relative to obstruction: at 70 degrees as much as a tenth of the region.
constexpr double kTiltCost = 0.15;
// A region is well visible if it has at least so many pixels, and its normal such a cosine to the viewer's direction;
constexpr double kLeastSize = 24.0;
constexpr double kLeastFacing = 0.25;
// such a share of its box lies in this share of the view from above, for below is the card;
constexpr double kLeastShown = 0.8;
constexpr double kFreeShare = 0.8;
// a surface less than so many pixels in front does not cover it.
constexpr double kDepthPixels = 2.0;
constexpr std::size_t kFacesLookedAt = 100000;  // roughly

std::vector<Vec3> candidates(const Vec3& outward) {
  const Vec3 side = outward.unitOrthogonal();
  const Vec3 other = outward.cross(side);
  std::vector<Vec3> directions{outward};
  for (double tilt : kTilts) {
    const double t = tilt * std::numbers::pi / 180.0;
    for (int i = 0; i < kTurns; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / kTurns;
      directions.push_back(std::cos(t) * outward + std::sin(t) * (std::cos(turn) * side + std::sin(turn) * other));
    }
  }
  return directions;
}

}  // namespace

Vec3 unobstructedDirection(const HalfEdgeMesh& mesh, const Box& region, const Vec3& outward) {
  if (outward.norm() == 0.0 || region.isEmpty()) return outward;
  const std::vector<Vec3> directions = candidates(outward.normalized());
  const Vec3 centre = region.center();
  const double radius = std::max(region.diagonal().norm() / 2.0, 1e-12);
  // Area of the mesh in front of the disc of this radius, seen from each direction. Faces nearer than a quarter of the
  // radius belong to the surroundings of the region itself.
  std::vector<double> hidden(directions.size(), 0.0);
  // For a large mesh a sample of the faces is sufficient.
  const auto step = static_cast<Face>(mesh.faceSlots() / kFacesLookedAt + 1);
  for (std::size_t slot = 0; slot < mesh.faceSlots(); slot += step) {
    const auto f = static_cast<Face>(slot);
    if (!mesh.isLive(f)) continue;
    const Triangle& t = mesh.triangle(f);
    const Vec3 &a = mesh.position(t[0]), &b = mesh.position(t[1]), &c = mesh.position(t[2]);
    const Vec3 from = (a + b + c) / 3.0 - centre;
    const double distance = from.squaredNorm();
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const double ahead = from.dot(directions[i]);
      if (ahead < radius / 4.0 || distance - ahead * ahead > radius * radius) continue;
      hidden[i] += step * std::abs((b - a).cross(c - a).dot(directions[i])) / 2.0;
    }
  }
  const double disc = std::numbers::pi * radius * radius;
  std::size_t best = 0;
  double least = 2.0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double tilted = 1.0 - directions[i].dot(directions.front());
    const double cost = std::min(hidden[i] / disc, 1.0) + kTiltCost * tilted;
    if (cost >= least) continue;
    best = i;
    least = cost;
  }
  return directions[best];
}

bool isWellSeen(const Viewport& view, const Box& region, const Vec3& outward) {
  if (region.isEmpty()) return false;
  const CameraNavigation navigation(view.camera(), {view.width(), view.height()});
  if (outward.dot(view.camera().towardsViewer()) < kLeastFacing * outward.norm()) return false;
  const Eigen::AlignedBox2d room(Vec2(0.0, 0.0), Vec2(view.width(), kFreeShare * view.height()));
  Eigen::AlignedBox2d shown;
  for (const Vec3& corner : cornersOf(region)) {
    if (!navigation.isBeforeEye(corner)) return false;
    shown.extend(navigation.toScreen(corner));
  }
  if (shown.diagonal().norm() < kLeastSize) return false;
  const Vec2 margin = Vec2::Ones();  // it may be a line
  shown = Eigen::AlignedBox2d(Vec2(shown.min() - margin), Vec2(shown.max() + margin));
  if (!room.intersects(shown) || room.intersection(shown).volume() < kLeastShown * shown.volume()) return false;
  const ViewRay ray = navigation.rayAt(navigation.toScreen(region.center()), view.bounds());
  const Pick first = view.pickAlong(ray.origin, ray.direction);
  const double depth = (region.center() - ray.origin).dot(ray.direction) - region.diagonal().norm() / 2.0;
  return first.isNothing() || first.distance >= depth - kDepthPixels * navigation.unitsPerPixelAt(region.center());
}

}  // namespace handwheel

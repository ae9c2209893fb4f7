// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/measure/WallThickness.h"

#include "base/Tolerance.h"
#include "mesh/search/SmoothNormal.h"
#include "mesh/structure/FaceNormal.h"

namespace handwheel {

namespace {

constexpr int kMostSkipped = 1000;  // largest number of faces that a ray passes
constexpr double kFree = 0.99;      // share of the radius without surface
constexpr int kMostShrinks = 64;

// Returns the point where a ray from a face leaves all bodies; if it never does, as among open pieces, the point where
// it leaves the first.
std::optional<Vec3> wallBehind(const FaceHierarchy& faces, Face own, const Vec3& p, const Vec3& inwards) {
  const double step = tolerance::kPastFace * faces.bounds().diagonal().norm();
  Ray ray{p, inwards};
  std::optional<Vec3> first;
  int depth = 1;
  for (int i = 0; i < kMostSkipped; ++i) {
    const auto hit = faces.firstHit(ray);
    if (!hit) break;
    const Vec3 normal = unitNormal(faces.mesh().points(hit->face));
    const double side = hit->face == own ? 0.0 : normal.dot(inwards);
    if (side > 0.0 && !first) first = hit->point;
    depth += side < 0.0 ? 1 : side > 0.0 ? -1 : 0;
    if (depth == 0) return hit->point;
    ray.origin = hit->point + step * inwards;
  }
  return first;
}

// within is the share of the radius at which the ball counts as free.
double ballRadius(const FaceHierarchy& faces, const Vec3& p, const Vec3& normal, double within, double radius) {
  for (int i = 0; i < kMostShrinks; ++i) {
    const Vec3 centre = p - radius * normal;
    const auto nearest = faces.nearest(centre);
    if (!nearest || (*nearest - centre).norm() >= within * radius) return radius;
    // The next ball touches at p and passes through the nearest point.
    const Vec3 to = p - *nearest;
    const double smaller = to.squaredNorm() / (2.0 * to.dot(normal));
    if (!(smaller > 0.0 && smaller < radius)) return radius;
    radius = smaller;
  }
  return radius;
}

}  // namespace

std::optional<WallThickness> wallThickness(const FaceHierarchy& faces, Face f, const Vec3& p) {
  const Vec3 normal = smoothNormal(faces.mesh(), f, p);
  if (normal.isZero(0.0)) return std::nullopt;
  const auto opposite = wallBehind(faces, f, p, -normal);
  if (!opposite) return std::nullopt;
  WallThickness thickness;
  thickness.alongNormal = (*opposite - p).norm();
  thickness.opposite = *opposite;
  // Facets that stand for a curved surface reach into each ball that touches that surface, as far as they are tilted
  // against it: without this, no ball between them would be small enough.
  const double tilt = normal.dot(unitNormal(faces.mesh().points(f)));
  const double within = kFree * (2.0 * tilt * tilt - 1.0);  // the cosine of twice the angle: neighbours are tilted too
  const double radius = ballRadius(faces, p, normal, within, 0.5 * thickness.alongNormal);
  thickness.ballDiameter = 2.0 * radius;
  thickness.ballCentre = p - radius * normal;
  return thickness;
}

}  // namespace handwheel

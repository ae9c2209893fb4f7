// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/Translatable.h"
#include "fidelity/Cases.h"
#include "robot/ShapeSurfaces.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kShapeRadius = 100.0, kLength = 300.0;  // mm

// Returns the depth of a point inside the ball.
double depthInBall(const Vec3& p) {
  return kShapeRadius - p.norm();
}
double depthInCylinder(const Vec3& p) {
  return std::min(kShapeRadius - std::hypot(p.x(), p.y()), 0.5 * kLength - std::abs(p.z()));
}

// Corners lie on the shape, so that the triangles are deepest in the middle of an edge or of a face.
FidelitySample sampleOf(const TriangleSoup& soup, double (*depth)(const Vec3&)) {
  double deepest = 0.0;
  for (const Triangle& t : soup.triangles) {
    const Vec3 &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
    for (const Vec3& p : {Vec3(0.5 * (a + b)), Vec3(0.5 * (b + c)), Vec3(0.5 * (c + a)), Vec3((a + b + c) / 3.0)})
      deepest = std::max(deepest, depth(p));
  }
  return {100.0 * deepest / kShapeRadius, static_cast<double>(soup.triangles.size())};
}

FidelityCase caseOn(const std::string& name, const Shape& shape, double (*depth)(const Vec3&)) {
  return {name, "closed form", [shape, depth](double sides, std::uint64_t, Progress) {
            return sampleOf(surfaceOf(shape, static_cast<std::uint32_t>(sides)), depth);
          }};
}

}  // namespace

FidelitySetting shapeSidesSetting() {
  FidelitySetting s;
  s.id = "cell.shape_sides";
  s.label = translatable("Fidelity", "Sides of the round shapes of robots");
  s.scale = FidelityScale::Logarithmic;
  s.least = 8.0;
  s.largest = 128.0;  // more, and the budget for the surfaces of a robot is soon used up
  s.whole = true;
  s.standard = kShapeSides;
  s.presets = {13.0, 32.0, 128.0};
  s.error = {translatable("Fidelity", "largest distance of the triangles from the shape, in radii"), "%"};
  s.cost = {translatable("Fidelity", "triangles of a shape"), translatable("Fidelity", "triangles")};
  return s;
}

std::vector<FidelityCase> shapeSidesCases() {
  return {caseOn("ball", SphereShape{kShapeRadius}, depthInBall),
          caseOn("cylinder 200 x 300 mm", CylinderShape{kShapeRadius, kLength}, depthInCylinder)};
}

}  // namespace handwheel

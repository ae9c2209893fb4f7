// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/CoordinateRounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace handwheel {
namespace {

// Powers of ten, by number of decimals.
constexpr std::array<double, 10> kPowers{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
constexpr double kMostDigits = 1e12;         // products beyond have too few bits left to tell integers from others
constexpr std::size_t kLeastLastDigits = 4;  // rounded numbers end in any digit, those of a grid in few
constexpr double kGrid = 1e-3;               // largest share of the diagonal
constexpr double kSlack = 1.01;              // allows for the rounding of this calculation itself

// Distance from a positive float to the next.
double floatSpacing(double v) {
  const auto single = static_cast<float>(v);
  if (!std::isfinite(single)) return 0.0;
  return static_cast<double>(std::nextafter(single, std::numeric_limits<float>::infinity())) - double(single);
}

bool hasDecimals(double v, std::size_t decimals) {
  const double scaled = std::abs(v) * kPowers[decimals];
  return scaled < kMostDigits &&
         std::abs(scaled - std::round(scaled)) <= 4.0 * std::numeric_limits<double>::epsilon() * scaled;
}

// Returns the distances of neighbouring numbers on the axes; 0 for integers. All are 0 if an axis has numbers of full
// length, because a file rounds all axes, and if the last digits are too few to be those of rounding.
Vec3 decimalSpacings(std::span<const Vec3> points) {
  Vec3 spacings = Vec3::Zero();
  std::set<int> lastDigits;
  for (int axis = 0; axis < 3; ++axis) {
    std::size_t count = 0;
    for (const Vec3& p : points) {
      while (count < kPowers.size() && !hasDecimals(p[axis], count)) ++count;
      if (count == kPowers.size()) return Vec3::Zero();
    }
    if (count == 0) continue;
    spacings[axis] = 1.0 / kPowers[count];
    for (const Vec3& p : points)
      lastDigits.insert(static_cast<int>(std::fmod(std::round(std::abs(p[axis]) * kPowers[count]), 10.0)));
  }
  return lastDigits.size() < kLeastLastDigits ? Vec3(Vec3::Zero()) : spacings;
}

}  // namespace

CoordinateSteps coordinateSteps(std::span<const Vec3> points) {
  CoordinateSteps found;
  Box box;
  for (const Vec3& p : points) box.extend(p);
  if (box.isEmpty()) return found;
  const Vec3 largest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs());
  const bool areFloats =
      std::all_of(points.begin(), points.end(), [](const Vec3& p) { return p == rounded(p, NumberType::Float32); });
  if (areFloats) {
    for (int axis = 0; axis < 3; ++axis) found.steps[axis] = kSlack * floatSpacing(largest[axis]);
    return found;
  }
  const Vec3 spacings = decimalSpacings(points);
  for (int axis = 0; axis < 3; ++axis)
    if (spacings[axis] <= kGrid * box.diagonal().norm()) found.steps[axis] = kSlack * spacings[axis];
  return found;
}

CoordinateSteps coordinateSteps(const HalfEdgeMesh& mesh) {
  std::vector<bool> isUsed(mesh.vertexSlots(), false);
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (const Vertex v : mesh.triangle(f)) isUsed[v] = true;
  }
  std::vector<Vec3> points;
  for (Vertex v = 0; v < isUsed.size(); ++v)
    if (isUsed[v]) points.push_back(mesh.position(v));
  return coordinateSteps(points);
}

}  // namespace handwheel

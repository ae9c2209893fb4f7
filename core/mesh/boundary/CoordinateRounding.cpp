// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/CoordinateRounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace handwheel {
namespace {

constexpr int kMostDecimals = 9;
constexpr double kMostDigits = 1e12;  // products beyond have too few bits left to tell integers from others
constexpr double kGrid = 1e-3;        // largest share of the diagonal
constexpr double kSlack = 1.01;       // allows for the rounding of this calculation itself

// Distance from a positive float to the next.
double floatSpacing(double v) {
  const auto single = static_cast<float>(v);
  if (!std::isfinite(single)) return 0.0;
  return static_cast<double>(std::nextafter(single, std::numeric_limits<float>::infinity())) - double(single);
}

bool hasDecimals(double v, int decimals) {
  const double scaled = std::abs(v) * std::pow(10.0, decimals);
  return scaled < kMostDigits &&
         std::abs(scaled - std::round(scaled)) <= 4.0 * std::numeric_limits<double>::epsilon() * scaled;
}

// Returns the distances of neighbouring numbers on the axes; 0 for integers. All are 0 if an axis has numbers of full
// length, because a file rounds all axes.
Vec3 decimalSpacings(std::span<const Vec3> points) {
  Vec3 spacings = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    int count = 0;
    for (const Vec3& p : points) {
      while (count <= kMostDecimals && !hasDecimals(p[axis], count)) ++count;
      if (count > kMostDecimals) return Vec3::Zero();
    }
    if (count > 0) spacings[axis] = std::pow(10.0, -count);
  }
  return spacings;
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
  std::vector<Vec3> points;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (const Vec3& p : mesh.points(f)) points.push_back(p);
  }
  return coordinateSteps(points);
}

}  // namespace handwheel

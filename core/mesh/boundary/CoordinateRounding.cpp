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

// Returns the distance of neighbouring numbers on an axis; 0 for integers and for numbers of full length.
double decimalSpacing(std::span<const Vec3> points, int axis) {
  int count = 0;
  for (const Vec3& p : points) {
    while (count <= kMostDecimals && !hasDecimals(p[axis], count)) ++count;
    if (count > kMostDecimals) return 0.0;
  }
  return count > 0 ? std::pow(10.0, -count) : 0.0;
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
  for (int axis = 0; axis < 3; ++axis) {
    const double spacing = areFloats ? floatSpacing(largest[axis]) : decimalSpacing(points, axis);
    if (areFloats || spacing <= kGrid * box.diagonal().norm()) found.steps[axis] = kSlack * spacing;
  }
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

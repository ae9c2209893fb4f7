// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/CoordinateRounding.h"

#include "mesh/structure/MeshBounds.h"

#include <cmath>
#include <limits>
#include <optional>

namespace handwheel {
namespace {

constexpr int kMostDecimals = 9;
constexpr double kMostDigits = 1e12;  // products beyond have too few bits left to tell integers from others
constexpr double kGrid = 1e-4;        // largest share of the diagonal
constexpr double kGridOfFarModels = 1e-3;
constexpr double kFar = 100.0;   // distance from the origin, in diagonals
constexpr double kSlack = 1.01;  // allows for the rounding of this calculation itself

bool areFloats(const HalfEdgeMesh& mesh) {
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (const Vec3& p : mesh.points(f))
      if (p != rounded(p, NumberType::Float32)) return false;
  }
  return true;
}

// Distance from a positive float to the next.
double floatSpacing(double v) {
  const auto single = static_cast<float>(v);
  if (!std::isfinite(single)) return 0.0;
  return static_cast<double>(std::nextafter(single, std::numeric_limits<float>::infinity())) - double(single);
}

// Finds the number of decimals of each axis in one pass; -1 if there are more than kMostDecimals.
class Decimals {
 public:
  explicit Decimals(const HalfEdgeMesh& mesh) {
    for (Face f = 0; f < mesh.faceSlots(); ++f) {
      if (!mesh.isLive(f)) continue;
      for (const Vec3& p : mesh.points(f))
        for (int axis = 0; axis < 3; ++axis) read(axis, p[axis]);
    }
  }

  // Returns the distance of two neighbouring numbers; 0 for integers and for numbers of full length.
  double spacing(int axis) const { return m_count[axis] > 0 ? std::pow(10.0, -m_count[axis]) : 0.0; }

 private:
  void read(int axis, double v) {
    int& count = m_count[axis];
    while (count >= 0 && !has(v, count)) count = count < kMostDecimals ? count + 1 : -1;
  }

  static bool has(double v, int decimals) {
    const double scaled = std::abs(v) * std::pow(10.0, decimals);
    return scaled < kMostDigits &&
           std::abs(scaled - std::round(scaled)) <= 4.0 * std::numeric_limits<double>::epsilon() * scaled;
  }

  int m_count[3] = {0, 0, 0};
};

}  // namespace

double coordinateRounding(const HalfEdgeMesh& mesh) {
  const Box box = boundsOf(mesh);
  if (box.isEmpty()) return 0.0;
  const Vec3 largest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs());
  if (areFloats(mesh))
    return kSlack * Vec3(floatSpacing(largest.x()), floatSpacing(largest.y()), floatSpacing(largest.z())).norm();
  const Decimals decimals(mesh);
  const double diagonal = box.diagonal().norm();
  const double most = (largest.norm() > kFar * diagonal ? kGridOfFarModels : kGrid) * diagonal;
  Vec3 grid = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (const double spacing = decimals.spacing(axis); spacing <= most) grid[axis] = spacing;
  }
  return kSlack * grid.norm();
}

}  // namespace handwheel

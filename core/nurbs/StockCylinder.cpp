// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/StockCylinder.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace handwheel {

bool StockCylinder::isSound() const {
  const auto isSize = [](double size) { return size >= kLeastSize && size <= kLargestSize; };
  return isSize(diameter) && isSize(length) && std::abs(position) <= kFurthest;
}

double StockCylinder::volume() const {
  return std::numbers::pi / 4.0 * diameter * diameter * length;
}

double StockCylinder::area() const {
  return std::numbers::pi * diameter * (diameter / 2.0 + length);
}

Box StockCylinder::bounds() const {
  const double r = diameter / 2.0;
  return {Vec3(-r, -r, position), Vec3(r, r, position + length)};
}

ProfileCurve StockCylinder::profile() const {
  assert(isSound());
  const double r = diameter / 2.0;
  return ProfileCurve::polyline({{r, position}, {r, position + length}}).value();
}

}  // namespace handwheel

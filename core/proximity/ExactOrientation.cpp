// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proximity/ExactOrientation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace handwheel::exact {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 point(const Vec2& p) {
  return {p.x(), p.y()};
}
Kernel::Point_3 point(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

}  // namespace

int side(const Vec2& p, const Vec2& q, const Vec2& r) {
  return static_cast<int>(CGAL::orientation(point(p), point(q), point(r)));
}

int side(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  return static_cast<int>(CGAL::orientation(point(p), point(q), point(r), point(s)));
}

}  // namespace handwheel::exact

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "nurbs/BezierArc.h"

// Vector products in the half plane.
namespace handwheel {

inline double crossProduct(const ProfilePoint& a, const ProfilePoint& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Returns a vector turned by 90° from r towards z.
inline ProfilePoint turnedLeft(const ProfilePoint& v) {
  return {-v.y(), v.x()};
}

}  // namespace handwheel

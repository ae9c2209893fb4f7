// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <cmath>

namespace handwheel::test {

// Returns the winding number of a surface about a point. It is the sum of the solid angles of its triangles, divided by
// 4π (van Oosterom and Strackee 1983), a whole number for a closed surface.
inline double windingNumber(const TriangleSoup& soup, const Vec3& p) {
  double sum = 0.0;
  for (const Triangle& t : soup.triangles) {
    const Vec3 a = soup.points[t[0]] - p, b = soup.points[t[1]] - p, c = soup.points[t[2]] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2.0 * M_PI);
}

}  // namespace handwheel::test

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

namespace handwheel::test {

// Returns the volume (mm³) within a closed surface that faces outwards, by the divergence theorem.
inline double volumeOf(const TriangleSoup& soup) {
  double six = 0.0;
  for (const Triangle& t : soup.triangles) six += soup.points[t[0]].dot(soup.points[t[1]].cross(soup.points[t[2]]));
  return six / 6.0;
}

}  // namespace handwheel::test

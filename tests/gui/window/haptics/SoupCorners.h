// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../StlFiles.h"
#include "mesh/structure/TriangleSoup.h"

namespace handwheel::test {

// Returns the triangles of a soup in the form that writeStl() requires.
inline std::vector<Corners> cornersOf(const TriangleSoup& soup) {
  std::vector<Corners> all;
  for (const Triangle& t : soup.triangles) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = soup.points[t[k]];
      corners[k] = {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
    }
    all.push_back(corners);
  }
  return all;
}

}  // namespace handwheel::test

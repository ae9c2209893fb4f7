// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"

#include <memory>
#include <vector>

namespace handwheel {

// The shape of a dab: heights from 0 to 1 over a rectangle. The longer side goes from -1 to 1, and the middle of the
// rectangle is at 0. Immutable, so threads share it.
class ClayStamp {
 public:
  // Heights row by row, the uppermost first, each from the left. There are width · height, each in 0 to 1, and both are
  // at least 1.
  ClayStamp(int width, int height, std::vector<float> heights);

  // By linear interpolation between the middles of four cells; 0 outside of the rectangle. x to the right, y up.
  double at(double x, double y) const;

  int width() const { return m_width; }
  int height() const { return m_height; }
  static constexpr int kMostSide = 512;  // cells that the readers of stamps make

 private:
  double cell(int column, int row) const;

  int m_width, m_height;
  std::vector<float> m_heights;
};

// The stamps that need no file.
enum class BuiltInStamp {
  Dome,     // half a ball
  Pyramid,  // four faces
  Ring,     // around a flat middle
  Ridges,   // waves along y
  Pebbles,  // domes of different sizes, always at the same places
  Scales,   // rows of overlapping plates
};
inline constexpr int kBuiltInStamps = 6;

std::shared_ptr<const ClayStamp> builtInStamp(BuiltInStamp which);

// How high the triangles lie over the xy plane: 1 for the highest place, 0 for the lowest and where there are none.
// Null where they cover nothing, all is of one height, or once cancelled. O(triangles + cells that they cover).
std::shared_ptr<const ClayStamp> stampOfSurface(const TriangleSoup& surface, Progress progress = {});

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"

#include <memory>
#include <vector>

namespace handwheel {

// The shape of a brush dab: heights from 0 to 1 over a rectangle. The longer side extends from -1 to 1, with the centre
// of the rectangle at 0. A stamp is immutable, so threads can share it.
class ClayStamp {
 public:
  // heights: width · height values in 0 to 1, row by row from the top, each from the left. width and height are at
  // least 1.
  ClayStamp(int width, int height, std::vector<float> heights);

  // Returns the height by linear interpolation between the centres of four cells; 0 outside the rectangle. x points to
  // the right, y up.
  double at(double x, double y) const;

  int width() const { return m_width; }
  int height() const { return m_height; }
  static constexpr int kMostSide = 512;  // largest number of cells per side of stamps that are read from files

 private:
  double cell(int column, int row) const;

  int m_width, m_height;
  std::vector<float> m_heights;
};

// The stamps that need no file.
enum class BuiltInStamp {
  Dome,     // half a ball
  Pyramid,  // four faces
  Ring,     // a ring around a flat middle
  Ridges,   // waves along y
  Pebbles,  // domes of different sizes, always at the same positions
  Scales,   // rows of overlapping plates
};
inline constexpr int kBuiltInStamps = 6;

std::shared_ptr<const ClayStamp> builtInStamp(BuiltInStamp which);

// Returns the height map of triangles over the xy plane: 1 for the highest point, 0 for the lowest and outside. Returns
// null if they cover nothing or are of one height, or if cancelled. O(triangles + cells that they cover).
std::shared_ptr<const ClayStamp> stampOfSurface(const TriangleSoup& surface, Progress progress = {});

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"
#include "viewport/MeshMarks.h"

#include <QImage>
#include <cstdlib>

// A square sheet with a known picture, and functions that find objects in a picture.
namespace handwheel {

inline constexpr int kCells = 20;

// Returns a square sheet from (0, 0) to (20, 20) at height 0, divided into cells × cells squares. Face 2 (j · cells +
// i) is the half of square (i, j) below its diagonal, and the next face is the other half.
inline TriangleSoup sheet(int cells) {
  TriangleSoup s;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) s.points.push_back(Vec3(i, j, 0) * kCells / cells);
  }
  const auto at = [cells](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      s.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      s.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return s;
}

inline LoopMark squareLoop(double z, const QColor& colour) {
  return {7, {{5, 5, z}, {15, 5, z}, {15, 15, z}, {5, 15, z}}, colour, false};
}

inline int pixelsNear(const QImage& image, const QColor& colour) {
  int n = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor c = image.pixelColor(x, y);
      n += std::abs(c.red() - colour.red()) < 24 && std::abs(c.green() - colour.green()) < 24 &&
           std::abs(c.blue() - colour.blue()) < 24;
    }
  }
  return n;
}

}  // namespace handwheel

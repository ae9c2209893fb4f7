// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <QImage>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>

// Solids with a mathematically known picture, and functions that measure a picture.
namespace handwheel {

// Returns a closed triangulated sphere. Its triangles are counter-clockwise when seen from outside, and its silhouette
// agrees with that of the exact sphere within a relative error of (π / 2n)².
inline TriangleSoup sphereSoup(int n, double radius = 1.0, const Vec3& centre = Vec3::Zero()) {
  TriangleSoup s;
  s.points = {centre + Vec3(0, 0, radius), centre - Vec3(0, 0, radius)};
  for (int i = 1; i < n; ++i) {
    for (int j = 0; j < 2 * n; ++j) {
      const double theta = std::numbers::pi * i / n, phi = std::numbers::pi * j / n;
      const Vec3 out(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      s.points.push_back(centre + radius * out);
    }
  }
  const auto at = [n](int i, int j) { return static_cast<std::uint32_t>(2 + (i - 1) * 2 * n + j % (2 * n)); };
  for (int j = 0; j < 2 * n; ++j) {
    s.triangles.push_back({0, at(1, j), at(1, j + 1)});
    s.triangles.push_back({1, at(n - 1, j + 1), at(n - 1, j)});
    for (int i = 1; i + 1 < n; ++i) {
      s.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      s.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return s;
}

inline TriangleSoup boxSoup(const Vec3& size, const Vec3& corner = Vec3::Zero()) {
  TriangleSoup s;
  for (int i = 0; i < 8; ++i) s.points.push_back(corner + Vec3(i & 1, i >> 1 & 1, i >> 2 & 1).cwiseProduct(size));
  s.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return s;
}

inline std::shared_ptr<const TriangleSoup> shared(TriangleSoup soup) {
  return std::make_shared<const TriangleSoup>(std::move(soup));
}

inline int difference(QRgb a, QRgb b) {
  return std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
}

// The pixels in which a picture differs from that of the empty background.
struct Silhouette {
  double area = 0.0;                   // pixels
  Eigen::Vector2d centroid{0.0, 0.0};  // centroid of the pixel centres, pixels
  int left = 1 << 30, right = -1, top = 1 << 30, bottom = -1;
};

// Returns the silhouette of a model. only: a predicate on the colour; only pixels for which it returns true are
// counted.
template <class Only>
Silhouette silhouette(const QImage& with, const QImage& without, Only only) {
  Silhouette s;
  for (int y = 0; y < with.height(); ++y) {
    for (int x = 0; x < with.width(); ++x) {
      const QRgb colour = with.pixel(x, y);
      if (difference(colour, without.pixel(x, y)) < 12 || !only(colour)) continue;
      s.area += 1;
      s.centroid += Eigen::Vector2d(x + 0.5, y + 0.5);
      s.left = std::min(s.left, x);
      s.right = std::max(s.right, x);
      s.top = std::min(s.top, y);
      s.bottom = std::max(s.bottom, y);
    }
  }
  if (s.area > 0) s.centroid /= s.area;
  return s;
}

inline Silhouette silhouette(const QImage& with, const QImage& without) {
  return silhouette(with, without, [](QRgb) { return true; });
}

}  // namespace handwheel

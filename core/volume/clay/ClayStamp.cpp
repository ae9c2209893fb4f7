// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/clay/ClayStamp.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

namespace handwheel {
namespace {

constexpr int kMadeSide = 128;  // cells of a stamp by formula

// Returns the height of a dome of a radius around the origin; 0 outside.
double domeAt(double x, double y, double radius) {
  return std::sqrt(std::max(0.0, 1.0 - (x * x + y * y) / (radius * radius)));
}

double ridgesAt(double x, double y) {
  constexpr double kWaves = 4.0, kEnd = 0.15;
  const double fade = std::clamp((1.0 - std::max(std::abs(x), std::abs(y))) / kEnd, 0.0, 1.0);
  return fade * 0.5 * (1.0 + std::cos(kWaves * M_PI * y));
}

double pebblesAt(double x, double y) {
  struct Pebble {
    double x, y, radius, height;
  };
  constexpr std::array<Pebble, 11> kPebbles = {{{-0.55, 0.55, 0.38, 1.0},
                                                {0.2, 0.66, 0.3, 0.8},
                                                {0.7, 0.5, 0.24, 0.65},
                                                {-0.1, 0.1, 0.34, 0.9},
                                                {0.55, -0.05, 0.36, 1.0},
                                                {-0.7, -0.1, 0.26, 0.7},
                                                {-0.35, -0.55, 0.32, 0.85},
                                                {0.25, -0.6, 0.3, 0.75},
                                                {0.75, -0.68, 0.22, 0.6},
                                                {-0.78, -0.7, 0.2, 0.55},
                                                {-0.12, 0.82, 0.15, 0.4}}};
  double most = 0.0;
  for (const Pebble& pebble : kPebbles)
    most = std::max(most, pebble.height * domeAt(x - pebble.x, y - pebble.y, pebble.radius));
  return most;
}

// Plates that rise from their upper end to their round lower one, each row over the one below it.
double scalesAt(double x, double y) {
  constexpr double kPitch = 0.4, kRadius = 0.5 * kPitch, kEnd = 0.8;
  double most = 0.0;
  for (int row = -2; row <= 2; ++row)
    for (int column = -2; column <= 2; ++column) {
      const double px = kPitch * (column + (row % 2 != 0 ? 0.5 : 0.0)), py = kPitch * row;
      const double along = (py - y) / kPitch + 0.5;  // 0 at the upper end, 1 at the lower
      const double down = std::max(0.0, py - y);
      const bool isOf = along >= 0.0 && std::hypot(x - px, down) <= kRadius && std::abs(px) < kEnd + kRadius / 2.0;
      if (isOf) most = std::max(most, 0.25 + 0.75 * along);
    }
  return most;
}

double heightOf(BuiltInStamp which, double x, double y) {
  switch (which) {
    case BuiltInStamp::Dome:
      return domeAt(x, y, 1.0);
    case BuiltInStamp::Pyramid:
      return 1.0 - std::max(std::abs(x), std::abs(y));
    case BuiltInStamp::Ring:
      return domeAt(std::hypot(x, y) - 0.7, 0.0, 0.3);
    case BuiltInStamp::Ridges:
      return ridgesAt(x, y);
    case BuiltInStamp::Pebbles:
      return pebblesAt(x, y);
    case BuiltInStamp::Scales:
      break;
  }
  return scalesAt(x, y);
}

// The cells of a rectangle in the xy plane, with the height of what covers their middles.
class HeightGrid {
 public:
  HeightGrid(const Vec3& low, double cell, int width, int height)
      : m_low(low), m_cell(cell), m_width(width), m_height(height) {
    m_heights.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kNothing);
  }

  // The middles that a triangle covers take its height where it is higher.
  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double area = across(a, b, c);
    if (!(std::abs(area) > 0.0)) return;
    const auto [left, right] = std::minmax({a.x(), b.x(), c.x()});
    const auto [lower, upper] = std::minmax({a.y(), b.y(), c.y()});
    const int lastColumn = std::min(m_width - 1, numberOf(right - m_low.x()));
    const int lastRow = std::min(m_height - 1, numberOf(upper - m_low.y()));
    for (int row = std::max(0, numberOf(lower - m_low.y())); row <= lastRow; ++row)
      for (int column = std::max(0, numberOf(left - m_low.x())); column <= lastColumn; ++column) {
        const Vec3 p(m_low.x() + (column + 0.5) * m_cell, m_low.y() + (row + 0.5) * m_cell, 0.0);
        const double u = across(p, b, c) / area, v = across(a, p, c) / area, w = 1.0 - u - v;
        constexpr double kStampRounding = -1e-9;  // on an edge between two triangles one has it
        if (u < kStampRounding || v < kStampRounding || w < kStampRounding) continue;
        double& height = m_heights[indexOf(column, row)];
        height = std::max(height, u * a.z() + v * b.z() + w * c.z());
      }
  }

  // From 0 to 1, the uppermost row first; none where all that is covered has one height.
  std::optional<std::vector<float>> shares() const {
    double least = std::numeric_limits<double>::infinity(), most = kNothing;
    for (const double height : m_heights) {
      if (height != kNothing) least = std::min(least, height);
      most = std::max(most, height);
    }
    if (!(most > least)) return std::nullopt;
    std::vector<float> shares;
    shares.reserve(m_heights.size());
    for (int row = m_height - 1; row >= 0; --row)
      for (int column = 0; column < m_width; ++column) {
        const double height = m_heights[indexOf(column, row)];
        shares.push_back(height != kNothing ? static_cast<float>((height - least) / (most - least)) : 0.0f);
      }
    return shares;
  }

 private:
  static constexpr double kNothing = -std::numeric_limits<double>::infinity();

  static double across(const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  }
  int numberOf(double along) const { return static_cast<int>(std::floor(along / m_cell)); }
  std::size_t indexOf(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(column);
  }

  Vec3 m_low;
  double m_cell;
  int m_width, m_height;
  std::vector<double> m_heights;
};

}  // namespace

ClayStamp::ClayStamp(int width, int height, std::vector<float> heights)
    : m_width(width), m_height(height), m_heights(std::move(heights)) {
  assert(width >= 1 && height >= 1);
  assert(m_heights.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

double ClayStamp::cell(int column, int row) const {
  const auto x = static_cast<std::size_t>(std::clamp(column, 0, m_width - 1)),
             y = static_cast<std::size_t>(std::clamp(row, 0, m_height - 1));
  return static_cast<double>(m_heights[y * static_cast<std::size_t>(m_width) + x]);
}

double ClayStamp::at(double x, double y) const {
  const double half = 0.5 * std::max(m_width, m_height);  // cells
  const double column = 0.5 * m_width + half * x, row = 0.5 * m_height - half * y;
  if (!(column >= 0.0 && column <= m_width && row >= 0.0 && row <= m_height)) return 0.0;
  const double left = std::floor(column - 0.5), top = std::floor(row - 0.5);
  const int i = static_cast<int>(left), j = static_cast<int>(top);
  const double u = column - 0.5 - left, v = row - 0.5 - top;
  return (1.0 - v) * ((1.0 - u) * cell(i, j) + u * cell(i + 1, j)) +
         v * ((1.0 - u) * cell(i, j + 1) + u * cell(i + 1, j + 1));
}

std::shared_ptr<const ClayStamp> builtInStamp(BuiltInStamp which) {
  std::vector<float> heights;
  heights.reserve(kMadeSide * kMadeSide);
  const auto middleOfCell = [](int i) { return 2.0 * (i + 0.5) / kMadeSide - 1.0; };
  for (int row = 0; row < kMadeSide; ++row)
    for (int column = 0; column < kMadeSide; ++column) {
      const double height = heightOf(which, middleOfCell(column), -middleOfCell(row));
      heights.push_back(static_cast<float>(std::clamp(height, 0.0, 1.0)));
    }
  return std::make_shared<const ClayStamp>(kMadeSide, kMadeSide, std::move(heights));
}

std::shared_ptr<const ClayStamp> stampOfSurface(const TriangleSoup& surface, Progress progress) {
  Box box;
  for (const auto& t : surface.triangles)
    for (const auto corner : t) box.extend(surface.points[corner]);
  if (box.isEmpty() || !box.min().allFinite() || !box.max().allFinite()) return nullptr;
  const Vec3 size = box.sizes();
  const double longest = std::max(size.x(), size.y()), cell = longest / ClayStamp::kMostSide;
  if (!(cell > 0.0) || !size.allFinite()) return nullptr;
  const auto count = [&](double side) {
    return std::clamp(static_cast<int>(std::ceil(side / cell - 1e-9)), 1, ClayStamp::kMostSide);
  };
  const int width = count(size.x()), height = count(size.y());
  HeightGrid grid(box.min(), cell, width, height);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    if (progress.cancelled()) return nullptr;  // one may cover all cells
    if (i % 256 == 0) progress.set(static_cast<double>(i) / static_cast<double>(surface.triangles.size()));
    const auto& t = surface.triangles[i];
    grid.add(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]);
  }
  auto shares = grid.shares();
  if (!shares) return nullptr;
  return std::make_shared<const ClayStamp>(width, height, std::move(*shares));
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fidelity/VirtualScanner.h"

#include "fidelity/SeededInput.h"

#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace handwheel {
namespace {

using Cell = std::array<int, 3>;

// Values of the distance at the points of a grid around the part.
class Grid {
 public:
  Grid(const ExactPart& part, double pitch) : m_pitch(pitch) {
    // Off the part's faces by no simple share of the pitch, so that none lies on points of the grid.
    m_low = part.box.min() - pitch * Vec3(2.39, 2.57, 2.71);
    for (int k = 0; k < 3; ++k) m_size[k] = static_cast<int>((part.box.max()[k] - m_low[k]) / pitch) + 3;
    m_values.reserve(static_cast<std::size_t>(m_size[0]) * m_size[1] * m_size[2]);
    for (int i = 0; i < m_size[0]; ++i)
      for (int j = 0; j < m_size[1]; ++j)
        for (int k = 0; k < m_size[2]; ++k) m_values.push_back(part.distance(positionOf({i, j, k})));
  }

  const Cell& size() const { return m_size; }
  Vec3 positionOf(const Cell& at) const { return m_low + m_pitch * Vec3(at[0], at[1], at[2]); }
  double value(const Cell& at) const {
    return m_values[(static_cast<std::size_t>(at[0]) * m_size[1] + at[1]) * m_size[2] + at[2]];
  }

 private:
  double m_pitch;
  Vec3 m_low;
  Cell m_size{};
  std::vector<double> m_values;
};

// One vertex in each cell that the surface passes, the mean of where it crosses the cell's edges; one quadrangle around
// each edge that it crosses.
class SurfaceNurbs {
 public:
  explicit SurfaceNurbs(const Grid& grid) : m_grid(grid) {
    for (int i = 1; i + 1 < grid.size()[0]; ++i)
      for (int j = 1; j + 1 < grid.size()[1]; ++j)
        for (int k = 1; k + 1 < grid.size()[2]; ++k)
          for (int axis = 0; axis < 3; ++axis) cross({i, j, k}, axis);
    for (std::size_t v = 0; v < m_soup.points.size(); ++v) m_soup.points[v] /= m_crossings[v];
  }

  TriangleSoup take() { return std::move(m_soup); }

 private:
  void cross(const Cell& from, int axis) {
    Cell to = from;
    ++to[axis];
    const double a = m_grid.value(from), b = m_grid.value(to);
    if ((a < 0.0) == (b < 0.0)) return;
    const Vec3 crossing = m_grid.positionOf(from) + a / (a - b) * (m_grid.positionOf(to) - m_grid.positionOf(from));
    std::array<std::uint32_t, 4> corners{};
    for (int n = 0; n < 4; ++n) {
      Cell cell = from;  // the four cells around the edge, in turn
      if (n == 1 || n == 2) --cell[(axis + 1) % 3];
      if (n >= 2) --cell[(axis + 2) % 3];
      corners[n] = vertexIn(cell);
      m_soup.points[corners[n]] += crossing;
      ++m_crossings[corners[n]];
    }
    if (a > 0.0) std::swap(corners[1], corners[3]);  // so that triangles look outwards
    m_soup.triangles.push_back({corners[0], corners[1], corners[2]});
    m_soup.triangles.push_back({corners[0], corners[2], corners[3]});
  }

  std::uint32_t vertexIn(const Cell& cell) {
    const auto [at, isNew] = m_vertices.try_emplace(cell, static_cast<std::uint32_t>(m_soup.points.size()));
    if (isNew) {
      m_soup.points.push_back(Vec3::Zero());
      m_crossings.push_back(0);
    }
    return at->second;
  }

  const Grid& m_grid;
  std::map<Cell, std::uint32_t> m_vertices;
  std::vector<int> m_crossings;
  TriangleSoup m_soup;
};

Vec3 normalAt(const ExactPart& part, const Vec3& p, double step) {
  Vec3 gradient;
  for (int k = 0; k < 3; ++k) {
    const Vec3 by = step * Vec3::Unit(k);
    gradient[k] = part.distance(p + by) - part.distance(p - by);
  }
  return gradient.normalized();
}

// Returns a normally distributed number, standard deviation 1 (Box and Muller, 1958).
double normalNumber(Random& random) {
  return std::sqrt(-2.0 * std::log(random.between(1e-300, 1.0))) * std::cos(random.between(0.0, 2.0 * M_PI));
}

}  // namespace

TriangleSoup scanOf(const ExactPart& part, const ScanOptions& options) {
  TriangleSoup scan = SurfaceNurbs(Grid(part, options.pitch)).take();
  Random random(options.seed);
  const double step = 1e-3 * options.pitch;
  for (Vec3& p : scan.points) {
    // Onto the surface; beside a sharp edge the first step may end on the other side of it.
    for (int i = 0; i < 3; ++i) p -= part.distance(p) * normalAt(part, p, step);
    p += options.noise * normalNumber(random) * normalAt(part, p, step);
  }
  return scan;
}

}  // namespace handwheel

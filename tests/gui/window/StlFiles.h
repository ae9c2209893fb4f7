// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QFile>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <vector>

// STL files for tests of the window, and an independent reader for its output. The reader uses no code of the program.
namespace handwheel::test {

using Corner = std::array<float, 3>;
using Corners = std::array<Corner, 3>;

// Returns a torus of rings × sides quads without the listed quads. Each missing quad leaves a hole of four edges.
inline std::vector<Corners> quadTorus(int rings, int sides, const std::set<std::pair<int, int>>& missing) {
  const auto at = [&](int i, int j) -> Corner {
    const double u = 2.0 * M_PI * (i % rings) / rings;
    const double v = 2.0 * M_PI * (j % sides) / sides;
    const double r = 30.0 + 10.0 * std::cos(v);
    return {float(r * std::cos(u)), float(r * std::sin(u)), float(10.0 * std::sin(v))};
  };
  std::vector<Corners> triangles;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sides; ++j) {
      if (missing.count({i, j})) continue;
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return triangles;
}

// Returns a torus with one hole of 6 × 4 cells.
inline std::vector<Corners> torusWithHole() {
  std::set<std::pair<int, int>> missing;
  for (int i = 3; i < 9; ++i) {
    for (int j = 5; j < 9; ++j) missing.emplace(i, j);
  }
  return quadTorus(48, 24, missing);
}

inline void writeStl(const QString& path, const std::vector<Corners>& triangles) {
  QByteArray bytes(84 + 50 * qsizetype(triangles.size()), '\0');
  const auto count = quint32(triangles.size());
  std::memcpy(bytes.data() + 80, &count, 4);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    std::memcpy(bytes.data() + 84 + 50 * i + 12, triangles[i].data(), 36);
  }
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("no room for test files");
}

inline std::vector<Corners> readStl(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QByteArray bytes = file.readAll();
  quint32 count = 0;
  if (bytes.size() < 84) return {};
  std::memcpy(&count, bytes.data() + 80, 4);
  if (bytes.size() != 84 + 50 * qsizetype(count)) return {};
  std::vector<Corners> triangles(count);
  for (std::size_t i = 0; i < count; ++i) std::memcpy(triangles[i].data(), bytes.data() + 84 + 50 * i + 12, 36);
  return triangles;
}

// Returns the number of edges that only one triangle uses. The result is -1 if an edge is used twice in the same
// direction or by more than two triangles.
inline int openEdges(const std::vector<Corners>& triangles) {
  std::map<std::pair<Corner, Corner>, int> directed;
  for (const Corners& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++directed[{t[k], t[(k + 1) % 3]}];
  }
  int open = 0;
  for (const auto& [edge, uses] : directed) {
    if (uses > 1) return -1;
    open += directed.count({edge.second, edge.first}) == 0;
  }
  return open;
}

}  // namespace handwheel::test

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <array>
#include <cmath>
#include <vector>

namespace handwheel {

// A mesh that can be written as an OFF file. The numbers in the comments of the shapes follow from their geometry.
struct Shape {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> faces;

  QByteArray off() const {
    QByteArray text = "OFF\n" + QByteArray::number(static_cast<int>(points.size())) + " " +
                      QByteArray::number(static_cast<int>(faces.size())) + " 0\n";
    for (const auto& p : points) {
      for (double x : p) text += QByteArray::number(x, 'g', 17) + " ";
      text += "\n";
    }
    for (const auto& f : faces) {
      text += "3";
      for (int v : f) text += " " + QByteArray::number(v);
      text += "\n";
    }
    return text;
  }

  Shape& add(const Shape& other, const std::array<double, 3>& shift) {
    const int n = static_cast<int>(points.size());
    for (const auto& p : other.points) points.push_back({p[0] + shift[0], p[1] + shift[1], p[2] + shift[2]});
    for (const auto& f : other.faces) faces.push_back({f[0] + n, f[1] + n, f[2] + n});
    return *this;
  }
};

// Returns an axis-aligned cube with one corner at the origin. It has 8 vertices and 12 triangles, two per side; the
// bottom and the top come first.
inline Shape cube(double side = 1.0) {
  Shape shape;
  for (int i = 0; i < 8; ++i) shape.points.push_back({side * (i & 1), side * (i >> 1 & 1), side * (i >> 2 & 1)});
  shape.faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return shape;
}

// Returns the cube without its top. It has one boundary loop of 4 edges.
inline Shape openCube(double side = 1.0) {
  Shape shape = cube(side);
  shape.faces.erase(shape.faces.begin() + 2, shape.faces.begin() + 4);
  return shape;
}

// Returns a tetrahedron with a volume of 1/6.
inline Shape tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

// Returns a band of n quads with a half turn. It has one boundary loop of 2n edges, and is not orientable.
inline Shape moebiusStrip(int n) {
  Shape shape;
  for (int i = 0; i < n; ++i) {
    const double t = 2.0 * M_PI * i / n;
    for (double s : {-0.4, 0.4}) {
      const double r = 2.0 + s * std::cos(t / 2);
      shape.points.push_back({r * std::cos(t), r * std::sin(t), s * std::sin(t / 2)});
    }
  }
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i, b = 2 * i + 1;
    const int c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? b + 2 : 0;  // the last quad joins the ends crosswise
    shape.faces.push_back({a, c, d});
    shape.faces.push_back({a, d, b});
  }
  return shape;
}

// Returns a surface of quads (x, y), 0 <= x < width, 0 <= y < height, each divided into two triangles. "at" returns the
// position of a corner. Quads for which "hole" returns true are missing.
template <class At, class Hole>
Shape grid(int width, int height, At at, Hole hole) {
  Shape shape;
  for (int y = 0; y <= height; ++y) {
    for (int x = 0; x <= width; ++x) shape.points.push_back(at(x, y));
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (hole(x, y)) continue;
      const int a = y * (width + 1) + x, b = a + width + 1;
      shape.faces.push_back({a, a + 1, b + 1});
      shape.faces.push_back({a, b + 1, b});
    }
  }
  return shape;
}

// Returns a box of 10 × 10 × 10 with 10 × 10 quads per side. Its top has three holes: A of one quad (4 edges), B of 1 ×
// 2 (6 edges) and C of 1 × 3 (8 edges), so that every loop can be identified by its number of edges.
inline Shape holedBox() {
  const auto none = [](int, int) { return false; };
  const auto side = [&](const std::array<double, 3>& o, const std::array<double, 3>& u,
                        const std::array<double, 3>& v) {
    return grid(
        10, 10,
        [=](int x, int y) {
          return std::array<double, 3>{o[0] + x * u[0] + y * v[0], o[1] + x * u[1] + y * v[1],
                                       o[2] + x * u[2] + y * v[2]};
        },
        none);
  };
  const auto top = [](int x, int y) {
    return (x == 2 && y == 2) || ((x == 5 || x == 6) && y == 2) || (x >= 3 && x <= 5 && y == 6);
  };
  Shape box = grid(
      10, 10,
      [](int x, int y) {
        return std::array<double, 3>{1.0 * x, 1.0 * y, 10.0};
      },
      top);
  box.add(side({0, 0, 0}, {0, 1, 0}, {1, 0, 0}), {0, 0, 0});
  box.add(side({0, 0, 0}, {1, 0, 0}, {0, 0, 1}), {0, 0, 0});
  box.add(side({0, 10, 0}, {0, 0, 1}, {1, 0, 0}), {0, 0, 0});
  box.add(side({0, 0, 0}, {0, 0, 1}, {0, 1, 0}), {0, 0, 0});
  box.add(side({10, 0, 0}, {0, 1, 0}, {0, 0, 1}), {0, 0, 0});
  return box;
}

// Returns a flat sheet of n × n unit squares. Its only boundary loop is its outer edge.
inline Shape flatSheet(int n) {
  return grid(
      n, n,
      [](int x, int y) {
        return std::array<double, 3>{1.0 * x, 1.0 * y, 0.0};
      },
      [](int, int) { return false; });
}

}  // namespace handwheel

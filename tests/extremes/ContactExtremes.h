// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Extremes.h"

// Extreme surfaces and paths of the tip for the tests of contact. All contact tests use them.
namespace handwheel::test {

// The plane z = 0 from -1 to 1 along x and y, made of extreme triangles.
struct ExtremeFloor {
  std::string name;
  std::function<TriangleSoup()> soup;
  double breadth = 1e-3;  // width of the thinnest triangle with area; the thinner it is, the more it is tilted by
                          // rounding of a corner
};

inline TriangleSoup floorIn(std::uint32_t rows, std::uint32_t columns) {
  return grid(rows + 1, columns + 1, false, false,
              [&](std::uint32_t i, std::uint32_t j) { return Vec3(2.0 * i / rows - 1, 2.0 * j / columns - 1, 0); });
}

inline TriangleSoup halfTurnedFloor() {
  TriangleSoup s = floorIn(20, 20);
  for (std::size_t i = 0; i < s.triangles.size(); i += 3) std::swap(s.triangles[i][0], s.triangles[i][1]);
  return s;
}

inline TriangleSoup doubledFloor() {
  TriangleSoup s = floorIn(20, 20);
  append(s, turnedOver(floorIn(20, 20)));
  append(s, floorIn(7, 11));
  return s;
}

// Returns a floor with points, lines, and needles without area.
inline TriangleSoup degenerateFloor() {
  TriangleSoup s = floorIn(12, 12);
  for (std::size_t f = 0; f < 60; f += 4) addNeedles(s, f, 0, {0.25, 0.5, 1.0 - 1e-9});
  const std::size_t count = s.triangles.size();
  for (std::size_t i = 0; i < count; i += 5) {
    const auto [a, b, c] = s.triangles[i];
    s.triangles.insert(s.triangles.end(), {{a, a, a}, {a, b, b}, {c, b, c}});
  }
  return s;
}

// Returns a floor in which every second row is about a millionth as wide as the others.
inline TriangleSoup sliverFloor() {
  return grid(42, 3, false, false, [](std::uint32_t i, std::uint32_t j) {
    return Vec3((i / 2) / 10.0 - 1.0 + (i % 2 == 1 && i < 41 ? 1e-7 : 0.0), j - 1.0, 0.0);
  });
}

// Returns a fan of triangles around a point on the path of the tip.
inline TriangleSoup fanFloor(std::uint32_t count) {
  TriangleSoup s{{Vec3::Zero()}, {}};
  for (std::uint32_t i = 0; i < count; ++i) {
    s.points.emplace_back(2.0 * std::cos(2.0 * M_PI * i / count), 2.0 * std::sin(2.0 * M_PI * i / count), 0.0);
    s.triangles.push_back({0, i + 1, (i + 1) % count + 1});
  }
  return s;
}

// Returns a floor and additional triangles that have a corner with a coordinate that is not finite.
inline TriangleSoup floorAmongNoNumbers() {
  TriangleSoup s = floorIn(10, 10);
  const auto first = static_cast<std::uint32_t>(s.points.size());
  for (const double bad : strangeNumbers())
    if (!std::isfinite(bad)) s.points.emplace_back(0.1, bad, 0.2);
  for (std::uint32_t i = first; i < s.points.size(); ++i) s.triangles.push_back({0, 1, i});
  return s;
}

inline std::vector<ExtremeFloor> extremeFloors() {
  return {
      {"squares", [] { return floorIn(20, 20); }},
      {"a third turned over", halfTurnedFloor},
      {"three times over", doubledFloor},
      {"a soup", [] { return unshared(floorIn(20, 20)); }},
      {"triangles without area", degenerateFloor},
      {"slivers 1e7 : 1", sliverFloor, 1e-7},
      {"strips", [] { return floorIn(2000, 1); }},
      {"a fan of three", [] { return fanFloor(3); }},
      {"a fan of 1,000", [] { return fanFloor(1000); }},
      {"beside corners that are no numbers", floorAmongNoNumbers},
      {"one triangle, a thousand times as large",
       [] {
         return TriangleSoup{{{-1000, -1000, 0}, {2000, -1000, 0}, {-1000, 2000, 0}}, {{0, 1, 2}}};
       }},
  };
}

// A path of the tip from above to half a unit below the floor, across the floor, and up again.
struct FloorPath {
  static constexpr int kDown = 20, kAcross = 300, kUp = 40;
  static constexpr int kTicks = kDown + kAcross + kUp;
  static constexpr double kDepth = 0.5;

  static bool isPressed(int tick) { return tick >= kDown && tick < kDown + kAcross; }
  // Returns the position at a tick. The middle of the path is exactly below the middle of the floor.
  static Vec3 at(int tick) {
    const double share = std::clamp(2.0 * (tick - kDown) / kAcross - 1.0, -1.0, 1.0);
    const Vec3 foot(0.8 * share, 0.3 * share, -kDepth);
    if (tick < kDown) return foot + (1.0 - double(tick) / kDown) * Vec3(0, 0, 1.0);
    return foot + std::max(0, tick - kDown - kAcross) * Vec3(0, 0, 1.0 / kUp);
  }
};

// A tip that moves at random around a box in steps of all sizes. It sometimes jumps far away, or to the centre of the
// box.
class WildTip {
 public:
  WildTip(const Box& box, unsigned seed)
      : m_random(seed), m_middle(box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center())), m_size(sizeOf(box)) {}

  Vec3 start() const { return m_middle + Vec3(1.5 * m_size, 0, 0); }

  Vec3 next() {
    if (m_tick++ == 0) m_tip = start();
    const double step = m_size * std::pow(10.0, -9.0 + 9.3 * unit());
    m_tip += step * direction();
    if ((m_tip - m_middle).norm() > 2.0 * m_size) m_tip = m_middle + 0.5 * m_size * direction();
    if (m_tick % 97 == 0) m_tip = m_middle + 1e3 * m_size * direction();
    if (m_tick % 101 == 0) m_tip = m_middle;
    return m_tip;
  }

 private:
  static double sizeOf(const Box& box) {
    const double size = box.isEmpty() ? 0.0 : box.diagonal().norm();
    return size > 0.0 && std::isfinite(size) ? size : 1.0;
  }
  double unit() { return m_random() / 4294967296.0; }
  Vec3 direction() {
    const double x = 2.0 * unit() - 1.0, y = 2.0 * unit() - 1.0;
    return {x, y, 2.0 * unit() - 1.0};
  }

  std::mt19937 m_random;
  Vec3 m_middle;
  double m_size;
  Vec3 m_tip = Vec3::Zero();
  int m_tick = 0;
};

}  // namespace handwheel::test

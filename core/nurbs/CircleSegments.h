// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace handwheel {

// The numbers of chords that approximate the circles of one part. The largest circle has a power of two times 8 to 15
// chords. Smaller circles have a half, a quarter, ... of this number, so that chords of neighbouring circles meet in a
// regular pattern.
class CircleSegments {
 public:
  static constexpr std::uint32_t kLeast = 8;

  // Returns the numbers of chords for circles up to a radius (mm). No chord is further from its circle than the
  // tolerance (mm). Returns nothing if the largest circle needs more than 2³⁰ chords.
  static std::optional<CircleSegments> make(double largestRadius, double tolerance);

  int levels() const { return m_levels; }  // number of times that the count can be halved
  std::uint32_t count(int level) const { return m_most >> level; }
  int levelOf(std::uint32_t count) const;  // level with this number of chords
  int levelAt(double radius) const;        // last level that keeps the tolerance at this radius
  double reach(int level) const;           // largest radius (mm) at which a level keeps the tolerance

 private:
  CircleSegments(std::uint32_t most, int levels, double tolerance)
      : m_most(most), m_levels(levels), m_tolerance(tolerance) {}

  std::uint32_t m_most;
  int m_levels;
  double m_tolerance;
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace handwheel {

// The numbers of chords that approximate the circles of one part. Some power of two times 8 to 15 for its largest, and
// halves, quarters, ... of that for smaller ones, so that chords of neighbouring circles meet in a regular pattern.
class CircleSegments {
 public:
  static constexpr std::uint32_t kLeast = 8;

  // For circles up to this radius; no chord is further from its circle than the tolerance (mm). nullopt where that
  // needs more than 2³⁰ chords.
  static std::optional<CircleSegments> make(double largestRadius, double tolerance);

  int levels() const { return m_levels; }  // how often the count can be halved
  std::uint32_t count(int level) const { return m_most >> level; }
  int levelOf(std::uint32_t count) const;  // of one of these counts
  int levelAt(double radius) const;        // the last that keeps the tolerance there
  double reach(int level) const;           // the largest radius (mm) at which a level keeps it

 private:
  CircleSegments(std::uint32_t most, int levels, double tolerance)
      : m_most(most), m_levels(levels), m_tolerance(tolerance) {}

  std::uint32_t m_most;
  int m_levels;
  double m_tolerance;
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/CircleSegments.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace handwheel {

namespace {

constexpr int kShare = 4;  // significant bits of a count

// The sagitta of one of n chords is r(1 - cos(π/n)) = 2r sin²(π/2n); the second form keeps its digits where it is far
// below the radius.
double chordsFor(double radius, double tolerance) {
  const double sine = std::sqrt(tolerance / (2.0 * radius));
  const double least = CircleSegments::kLeast;
  if (!(sine < std::sin(std::numbers::pi / (2.0 * least)))) return least;  // also on the axis, where it is infinite
  return std::ceil(std::numbers::pi / (2.0 * std::asin(sine)));
}

}  // namespace

std::optional<CircleSegments> CircleSegments::make(double largestRadius, double tolerance) {
  const double chords = chordsFor(largestRadius, tolerance);
  if (!(chords <= 0x1p30)) return std::nullopt;
  const auto least = static_cast<std::uint32_t>(chords);
  const int shift = std::max(0, static_cast<int>(std::bit_width(least)) - kShare);
  const std::uint32_t most = ((least + (1u << shift) - 1) >> shift) << shift;
  return CircleSegments(most, std::bit_width(most) - kShare, tolerance);
}

int CircleSegments::levelOf(std::uint32_t count) const {
  return std::bit_width(m_most) - std::bit_width(count);
}

int CircleSegments::levelAt(double radius) const {
  const double chords = chordsFor(radius, m_tolerance);
  int level = 0;
  while (level < m_levels && count(level + 1) >= chords) ++level;
  return level;
}

double CircleSegments::reach(int level) const {
  const double sine = std::sin(std::numbers::pi / (2.0 * count(level)));
  return m_tolerance / (2.0 * sine * sine);
}

}  // namespace handwheel

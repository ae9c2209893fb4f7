// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/RestToRest.h"
#include "robot/arm/SerialArm.h"

#include <span>
#include <vector>

namespace handwheel {

// The largest rates of the joints: their velocities, accelerations and jerks.
struct JointRates {
  ArmValues velocity, acceleration, jerk;  // rad/s, mm/s and so on; above 0
};

// The motions of a path from one stop to the next, in time. A run has an extent, which grows along it: each motion has
// a share of it, as a length or a duration.
class TimedRun {
 public:
  // Returns a run that keeps all rates, jerks included. It passes exactly through all points, along curves without
  // kinks: points of a line of the tool are close to each other. extents: of each motion, at least 0. speed: extent per
  // second that is wanted.
  static TimedRun stopping(std::span<const ArmValues> points, std::span<const double> extents, double speed,
                           const JointRates& most);
  // Returns a run that keeps velocities and accelerations, and rounds its corners. extents: s, of each motion at its
  // own speed. zones: s, the extent before and behind the end of each motion within which the run may leave it; 0: a
  // point of a line, whose neighbours go in nearly the same direction.
  static TimedRun blended(std::span<const ArmValues> points, std::span<const double> extents,
                          std::span<const double> zones, const JointRates& most);

  double duration() const { return m_speeds.empty() ? m_profile.duration() : m_speeds.back().time; }
  double extentAt(double time) const;  // clamped before and after the run
  double timeOf(double extent) const;  // 0 ≤ extent ≤ that of the whole run
  ArmValues valuesAt(double extent) const;

 private:
  // The values are a cubic polynomial of the extent from the beginning of the piece.
  struct Piece {
    double begin;
    ArmValues value, first, second, third;  // derivatives at the beginning
  };
  // Between two of these points the extent is accelerated evenly.
  struct SpeedPoint {
    double extent, squaredSpeed, time;
  };

  static std::vector<Piece> smoothPieces(std::span<const ArmValues> points, std::span<const double> extents);
  // ends: where the pieces end. fastest: the largest speed in each of them, at most 1.
  void findSpeeds(std::span<const double> ends, std::span<const double> fastest, const JointRates& most);

  std::vector<Piece> m_pieces;
  double m_extent = 0.0;
  RestToRest m_profile{0.0, 1.0, 1.0, 1.0};
  std::vector<SpeedPoint> m_speeds;  // empty: the profile counts
};

}  // namespace handwheel

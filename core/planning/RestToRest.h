// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// A time-optimal motion from rest to rest with limited velocity, acceleration and jerk. It has a double-S profile
// (Biagiotti and Melchiorri 2008, Trajectory Planning for Automatic Machines and Robots, section 3.4).
class RestToRest {
 public:
  // Computes the motion over a distance within these limits. All values must be above 0, except the distance, which may
  // be 0.
  RestToRest(double distance, double velocity, double acceleration, double jerk);

  double duration() const { return 2.0 * m_ramp + m_cruise; }
  double timeOf(double distance) const;  // time at which a distance is covered, s; 0 ≤ distance ≤ the whole distance
  double at(double time) const;          // distance covered at a time, clamped before and after the motion

 private:
  double rampAt(double time) const;  // distance covered at a time in the first ramp

  double m_distance, m_jerk;
  double m_turn = 0.0;    // s with constant jerk, at each end of a ramp
  double m_ramp = 0.0;    // s of acceleration
  double m_cruise = 0.0;  // s
};

}  // namespace handwheel

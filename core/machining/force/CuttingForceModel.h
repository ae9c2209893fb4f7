// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// What a turning tool cuts at one moment.
struct CutConditions {
  double depth = 0.0;  // mm, of cut, along the radius
  double feed = 0.0;   // mm per revolution
  double speed = 0.0;  // m/min, of cutting

  bool operator==(const CutConditions&) const = default;
};

// The force of the work on a turning tool, N: along the speed of the work, against the feed, and away from the axis.
struct CutForces {
  double cutting = 0.0;
  double feed = 0.0;
  double radial = 0.0;

  double norm() const;
  bool operator==(const CutForces&) const = default;
};

// The conditions as every model takes them. What is not a number, or below zero, cuts nothing: all is 0 then. Depth,
// feed and speed are at most these, and the speed at least kLeastSpeed: laws with a negative power of it have a pole at
// a standstill, where none was measured.
CutConditions bounded(const CutConditions& cut) noexcept;
inline constexpr double kMostDepth = 1e3, kMostFeed = 1e3;       // mm, mm/rev
inline constexpr double kLeastSpeed = 1.0, kLargestSpeed = 1e5;  // m/min

// A law for the forces of turning, for one material and one tool.
//
// Evaluated in the servo loop: at() neither allocates nor locks, and costs less than a microsecond. Every result is
// finite and not negative, for any conditions; where depth or feed is 0, all forces are. Thread: any, at once.
class CuttingForceModel {
 public:
  virtual ~CuttingForceModel() = default;

  virtual CutForces at(const CutConditions& cut) const noexcept = 0;

  // Whether the law was measured, or fitted, for such a cut. Outside a model says the best it can.
  virtual bool covers(const CutConditions& cut) const noexcept = 0;
};

// The power of a cut, kW: Pc = Fc·v / 60000.
double cuttingPower(const CutForces& forces, const CutConditions& cut) noexcept;
// The torque at the spindle, N·m, of a cut at this diameter (mm).
double cuttingTorque(const CutForces& forces, double diameter) noexcept;
// The power that the motor gives, kW, where the drive has this efficiency in (0, 1].
double motorPower(double cuttingPower, double efficiency) noexcept;
// The spindle speed, r/min, at which the work has this speed (m/min) at a diameter (mm); 0 where that is 0.
double spindleSpeed(double speed, double diameter) noexcept;
// The speed of the work, m/min, at a spindle speed (r/min) and a diameter (mm).
double surfaceSpeed(double spindle, double diameter) noexcept;

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// The conditions of a turning cut at one moment.
struct CutConditions {
  double depth = 0.0;  // mm, depth of cut along the radius
  double feed = 0.0;   // mm per revolution
  double speed = 0.0;  // m/min, cutting speed

  bool operator==(const CutConditions&) const = default;
};

// The force of the work on a turning tool, N. Its components point along the speed of the work, against the feed, and
// away from the axis.
struct CutForces {
  double cutting = 0.0;
  double feed = 0.0;
  double radial = 0.0;
  // The cutting force is a couple: those of two lips of a drill, which turn the tool but do not push it.
  bool isCouple = false;

  double norm() const;  // N, of the resultant
  bool operator==(const CutForces&) const = default;
};

// Returns the conditions within the range of every model. Values that are not a number, or below zero, cut nothing: all
// are 0 then. Depth, feed and speed are limited to kMostDepth, kMostFeed and kLargestSpeed. The speed is at least
// kLeastSpeed, because laws with a negative power of the speed have a pole at a speed of 0, where no law was measured.
CutConditions bounded(const CutConditions& cut) noexcept;
inline constexpr double kMostDepth = 1e3, kMostFeed = 1e3;       // mm, mm/rev
inline constexpr double kLeastSpeed = 1.0, kLargestSpeed = 1e5;  // m/min

// A law for the forces of turning, for one material and one tool.
//
// The servo loop evaluates the law: at() neither allocates nor locks, and costs less than a microsecond. Every result
// is finite and not negative, for any conditions. If depth or feed is 0, all forces are 0. The functions may be called
// by several threads at once.
class CuttingForceModel {
 public:
  virtual ~CuttingForceModel() = default;

  virtual CutForces at(const CutConditions& cut) const noexcept = 0;

  // Returns the forces on a twist drill with two lips, each of which takes half of the feed: the cutting forces of both
  // lips, and the thrust (Sandvik's handbook: Mc = kc D² f / 8, Ff = kc D f sin κ / 4). cut: the depth is the width of
  // the ring that the drill removes, half its diameter in solid work; the speed is that in the middle of the ring.
  virtual CutForces onDrill(const CutConditions& cut) const noexcept;

  // Returns true if the law was measured or fitted for such cuts. For other cuts at() extrapolates.
  virtual bool covers(const CutConditions& cut) const noexcept = 0;
};

inline constexpr double kDrillPoint = 59.0 / 180.0 * 3.14159265358979323846;  // rad, κ of a drill with a point of 118°
// Returns the forces on a drill whose lips have this cutting force each, N.
CutForces drillForces(double lip) noexcept;

// Returns the power of a cut, kW: Pc = Fc·v / 60000.
double cuttingPower(const CutForces& forces, const CutConditions& cut) noexcept;
// Returns the torque at the spindle, N·m, of a cut at this diameter (mm).
double cuttingTorque(const CutForces& forces, double diameter) noexcept;
// Returns the power of the motor, kW, for a drive of this efficiency in (0, 1].
double motorPower(double cuttingPower, double efficiency) noexcept;
// Returns the spindle speed, r/min, that gives the work this surface speed (m/min) at a diameter (mm); 0 if the
// diameter is 0.
double spindleSpeed(double speed, double diameter) noexcept;
// Returns the surface speed of the work, m/min, at a spindle speed (r/min) and a diameter (mm).
double surfaceSpeed(double spindle, double diameter) noexcept;

}  // namespace handwheel

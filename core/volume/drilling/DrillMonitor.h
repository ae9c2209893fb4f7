// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/VolumeShapes.h"
#include "volume/drilling/DrillRun.h"

#include <deque>
#include <vector>

namespace handwheel {

// The planned drill path of a hole, with its tolerance and forbidden regions.
struct DrillPlan {
  Vec3 entry = Vec3::Zero();         // mm, position on the surface
  Vec3 direction = -Vec3::UnitZ();   // unit vector in the direction of feed
  double tolerance = 1.0;            // mm, largest allowed distance from the planned line
  std::vector<SolidBall> forbidden;  // regions that the head must not enter
};

// A cycle of a drill, compared with a plan. The loads and the feed are means over the last kMeanTime, like those of a
// filtered sensor. Means are used because the single cycles of a contact mislead: a hand that meets the material feels
// the resistance only some cycles later, and until then moves as fast as in air.
struct DrillMoment {
  static constexpr double kMeanTime = 0.05;  // s

  double time = 0.0;    // s, time since the start of the first hole, without pauses between holes
  double thrust = 0.0;  // N
  double torque = 0.0;  // N·mm
  double feed = 0.0;    // mm/s
  double depth = 0.0;   // mm, depth of the tip along the plan, from the entry
  // Depth of the tip along the drill, from this hole's first contact with the material; mm.
  double holeDepth = 0.0;
  double deviation = 0.0;  // mm, the larger distance of centre and tip from the line
  double forbidden = 0.0;  // mm, depth of the head in the forbidden region; negative: distance from it; −∞: no region
  double temperature = 0.0;  // K, estimated temperature rise of the bone at the head
  bool isCutting = false;    // true if material was removed
  bool isThrough = false;    // true after the breakthrough
};

// A summary of the moments of drilling. Times are in s, from the same start.
struct DrillStatistics {
  std::optional<double> contact;       // time when material was first removed
  std::optional<double> breakthrough;  // time when the tip emerged on the other side
  double deviation = 0.0;              // mm, largest deviation while material was removed
  double plunge = 0.0;                 // mm, largest travel of the tip along the drill beyond its exit, of all holes
  double forbidden = 0.0;              // mm, largest depth in the forbidden region; 0: not entered
  double thrust = 0.0, torque = 0.0;   // largest values; N, N·mm
  double temperature = 0.0;            // K, largest temperature rise
  double end = 0.0;                    // s, time of the last moment
};

// The model of heat. Friction at the edges, torque times spindle speed, warms a layer of bone around the head, and the
// heat leaves the layer by diffusion: dT/dt = share · P / (heat · V) − T / time. The model distinguishes hot drilling
// from cool drilling, but does not predict the temperature in a patient.
struct DrillHeat {
  static constexpr double kShare = 0.15;       // fraction of the power that stays in the bone; an assumption
  static constexpr double kHeat = 2.4e-3;      // J/(mm³·K): 1.9 g/cm³ times 1.26 J/(g·K), for cortical bone
  static constexpr double kLayer = 1.0;        // mm, thickness of the layer
  static constexpr double kTime = 4.4;         // s: kLayer² / (0.23 mm²/s), by the diffusivity of cortical bone
  static double volume(const DrillBit& tool);  // mm³, volume of the layer in front of the head
};

// Compares drilling with a plan, cycle by cycle.
class DrillMonitor {
 public:
  explicit DrillMonitor(DrillPlan plan) : m_plan(std::move(plan)) {}

  // Starts another hole. The times of its ticks start at 0.
  void beginHole(const DrillSetup& setup);
  // Evaluates a tick. axis: unit vector towards the shank. isThrough: true after the breakthrough of the run.
  DrillMoment add(const DrillTick& tick, const Vec3& axis, bool isThrough);

  const DrillPlan& plan() const { return m_plan; }
  const DrillStatistics& figures() const { return m_figures; }

 private:
  double forbiddenDepth(const Vec3& centre, const Vec3& axis) const;
  double deviation(const Vec3& p) const;
  void takeMeans(DrillMoment& moment, const DrillTick& tick, double dt);
  void count(const DrillMoment& moment, const Vec3& tip, const Vec3& axis);

  DrillPlan m_plan;
  DrillSetup m_setup;
  DrillStatistics m_figures;
  double m_begin = 0.0, m_time = 0.0;  // s, start of the hole and time of the last tick
  std::optional<Vec3> m_position;
  struct Passage {
    double seconds, travel;   // s, mm
    double impulse, angular;  // N·s, N·mm·s
  };
  std::deque<Passage> m_last;             // passages of the last kMeanTime
  double m_temperature = 0.0;             // K
  std::optional<Vec3> m_contact, m_exit;  // positions of the tip at the contact and at the exit, for this hole
};

}  // namespace handwheel

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
  Vec3 entry = Vec3::Zero();         // mm, on the surface
  Vec3 direction = -Vec3::UnitZ();   // of the drill, of length 1
  double tolerance = 1.0;            // mm, from the line at most
  std::vector<SolidBall> forbidden;  // where the head must not be
};

// A cycle of a drill, as it is judged by a plan. Loads and feed are means over the last kMeanTime, as a sensor that is
// filtered shows them: a hand that meets the material gets its resistance some cycles later, and until then goes on as
// in air.
struct DrillMoment {
  static constexpr double kMeanTime = 0.05;  // s

  double time = 0.0;         // s, since the first hole was begun; pauses between holes do not count
  double thrust = 0.0;       // N
  double torque = 0.0;       // N·mm
  double feed = 0.0;         // mm/s
  double depth = 0.0;        // mm, of the tip along the plan, from the entry
  double holeDepth = 0.0;    // mm, of the tip along the drill, from where this hole was begun in the material
  double deviation = 0.0;    // mm, of centre or tip from the line, whichever is further
  double forbidden = 0.0;    // mm, of the head in the forbidden region; below 0: so far from it. No region: −∞
  double temperature = 0.0;  // K, estimated rise of the bone at the head
  bool isCutting = false;    // it took something
  bool isThrough = false;    // since the breakthrough
};

// What the moments amount to. Times: s, as those of the moments.
struct DrillStatistics {
  std::optional<double> contact;       // when something was taken first
  std::optional<double> breakthrough;  // when the tip came out on the other side
  double deviation = 0.0;              // mm, largest while something was taken
  double plunge = 0.0;                 // mm, of the tip along the drill beyond where it came out; of any hole
  double forbidden = 0.0;              // mm, deepest in the region; 0: it was not entered
  double thrust = 0.0, torque = 0.0;   // largest; N, N·mm
  double temperature = 0.0;            // K, largest
  double end = 0.0;                    // of the last moment
};

// The estimate of heat: the friction of the edges, torque times speed of the spindle, warms a layer of bone around the
// head, and the warmth leaves the layer as it spreads through it: dT/dt = share · P / (heat · V) − T / time. It tells
// hot drilling from cool, and is no temperature of a patient.
struct DrillHeat {
  static constexpr double kShare = 0.15;       // of the power that stays in the bone; an assumption
  static constexpr double kHeat = 2.4e-3;      // J/(mm³·K): 1.9 g/cm³ times 1.26 J/(g·K), of cortical bone
  static constexpr double kLayer = 1.0;        // mm
  static constexpr double kTime = 4.4;         // s: layer² / 0.23 mm²/s, the diffusivity of cortical bone
  static double volume(const DrillBit& tool);  // mm³, of the layer in front of the head
};

// Judges drilling by a plan, cycle by cycle.
class DrillMonitor {
 public:
  explicit DrillMonitor(DrillPlan plan) : m_plan(std::move(plan)) {}

  // Another hole is begun: times of its ticks begin at 0.
  void beginHole(const DrillSetup& setup);
  // axis: to the shank, of length 1. isThrough: the run has found a breakthrough.
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
  double m_begin = 0.0, m_time = 0.0;  // s: of the hole, and of the last tick in it
  std::optional<Vec3> m_place;
  struct Passage {
    double seconds, way;      // mm
    double impulse, angular;  // N·s, N·mm·s
  };
  std::deque<Passage> m_last;             // of kMeanTime
  double m_temperature = 0.0;             // K
  std::optional<Vec3> m_contact, m_exit;  // of the tip in this hole: where it met the material, and where it came out
};

}  // namespace handwheel

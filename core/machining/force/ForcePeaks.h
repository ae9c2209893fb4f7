// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/force/CuttingForceModel.h"

#include <optional>
#include <span>

namespace handwheel {

// The largest loads of drills.
struct DrillPeaks {
  double diameter = 0.0;  // mm, of the drill with the largest torque; 0: nothing was drilled
  double thrust = 0.0;    // N
  double torque = 0.0;    // N·m
  double power = 0.0;     // kW
};

// The largest values of force, power and torque on a path.
struct ForcePeaks {
  double force = 0.0;           // N, of the resultant; for a drill its thrust
  double power = 0.0;           // kW, power of the cut
  double torque = 0.0;          // N·m, torque at the spindle
  DrillPeaks drilling;          // loads of drills, which count in the values above as well
  CutConditions cut;            // the cut with the largest force
  double time = 0.0;            // s, time of the largest force since the start of the path
  bool isOutsideModel = false;  // the model does not cover all cuts of the path
};

// Finds the peaks of force during a cut, from the material that each short move removes. A cut is evaluated over at
// least one turn of the spindle and a length that the samples of the profile can resolve, because a sample is never
// removed in part.
class ForcePeakMeter {
 public:
  // resolution: the spacing of the samples of the profile, mm. The model must outlive the meter.
  ForcePeakMeter(const CuttingForceModel& model, double resolution);

  // A short move of the tool.
  struct Move {
    double length = 0.0;   // mm
    double seconds = 0.0;  // s; above zero if material is removed, except for a rapid move
    double area = 0.0;     // mm², removed from the half section of the part
    double radius = 0.0;   // mm, largest radius at which the edge cuts
    double spindle = 0.0;  // r/min, mean speed of the spindle
    double speed = 0.0;    // m/min, surface speed of the work at that radius
    bool isDrill = false;  // the tool is a drill of that radius
  };
  // Adds a move. A rapid move through material is evaluated with the feed kRapidFeed.
  void add(const Move& move);
  // Adds a cut whose chip is known: width and thickness (mm), time (s), and the radius of the work (mm) with its
  // surface speed (m/min). It is used for threads, whose lead is not a feed.
  void addChip(double width, double thickness, double seconds, double radius, double speed);
  // Ends the present cut and returns the peaks of all moves.
  ForcePeaks finish();

  static constexpr double kRapidFeed = 10.0;  // mm per turn

 private:
  void judge();
  void take(const CutConditions& cut, const CutForces& forces, double radius);
  void takeDrill(const CutConditions& cut);

  const CuttingForceModel* m_model;
  double m_resolution;
  double m_time = 0.0;
  double m_length = 0.0, m_area = 0.0, m_turns = 0.0;  // the cut that is being evaluated
  double m_radius = 0.0, m_speed = 0.0;
  bool m_isDrill = false;
  ForcePeaks m_peaks;
};

// Returns the radius of the drill that makes a move of a pass between two points, mm; 0: another tool.
double drillRadius(const TurningPass& pass, const ProfilePoint& a, const ProfilePoint& b);

// Returns the peaks of passes that cut a profile one after the other. The time of each pass continues from the pass
// before. spindle: its speed, r/min. The profile is a copy, which shares its pages with the original. Returns nothing
// if it was cancelled. The cost is the cost of cutting the passes.
std::optional<ForcePeaks> forcePeaks(TurnedProfile profile, std::span<const TurningPass> passes, double spindle,
                                     const CuttingForceModel& model, Progress progress = {});

}  // namespace handwheel

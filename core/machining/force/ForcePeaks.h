// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/force/CuttingForceModel.h"

#include <optional>
#include <span>

namespace handwheel {

// The rotation of the spindle while a path is cut.
struct SpindleSetting {
  double speed = 0.0;         // r/min; with a constant surface speed, the largest speed, where 0 means no limit
  double surfaceSpeed = 0.0;  // m/min, constant surface speed (G96); 0: the spindle speed is constant

  double at(double radius) const noexcept;  // r/min, for work of this radius (mm)
};

// The largest values of force, power and torque on a path.
struct ForcePeaks {
  double force = 0.0;           // N, norm of all three components
  double power = 0.0;           // kW, power of the cut
  double torque = 0.0;          // N·m, torque at the spindle
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
  ForcePeakMeter(const CuttingForceModel& model, const SpindleSetting& spindle, double resolution);

  // Adds a move of the tool: its length (mm) and time (s), the area that it removes from the half section of the part
  // (mm²), and the largest radius of the removed material (mm). If material is removed, the time must be above zero,
  // except for a rapid move. A rapid move through material is evaluated with the feed kRapidFeed.
  void add(double length, double seconds, double area, double radius);
  // Adds a cut whose chip is known: width and thickness (mm), time (s), and the radius of the work (mm). It is used for
  // threads, whose lead is not a feed.
  void addChip(double width, double thickness, double seconds, double radius);
  // Ends the present cut and returns the peaks of all moves.
  ForcePeaks finish();

  static constexpr double kRapidFeed = 10.0;  // mm per turn

 private:
  void judge();
  void take(const CutConditions& cut, double radius);

  const CuttingForceModel* m_model;
  SpindleSetting m_spindle;
  double m_resolution;
  double m_time = 0.0;
  double m_length = 0.0, m_area = 0.0, m_turns = 0.0, m_radius = 0.0;  // the cut that is being evaluated
  ForcePeaks m_peaks;
};

// Returns the peaks of passes that cut a profile one after the other. The time of each pass continues from the pass
// before. The profile is a copy, which shares its pages with the original. Returns nothing if it was cancelled. The
// cost is the cost of cutting the passes.
std::optional<ForcePeaks> forcePeaks(TurnedProfile profile, std::span<const TurningPass> passes,
                                     const SpindleSetting& spindle, const CuttingForceModel& model,
                                     Progress progress = {});

}  // namespace handwheel

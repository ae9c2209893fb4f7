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
  double speed = 0.0;         // r/min; with a constant surface speed the largest, and 0: no limit
  double surfaceSpeed = 0.0;  // m/min, kept constant (G96); 0: the spindle speed is constant

  double at(double radius) const noexcept;  // r/min, for work of this radius (mm)
};

// The largest values of a path.
struct ForcePeaks {
  double force = 0.0;           // N, norm of all three components
  double power = 0.0;           // kW, power of the cut
  double torque = 0.0;          // N·m, at the spindle
  CutConditions cut;            // the cut with the largest force
  double time = 0.0;            // s since the path began; time of the largest force
  bool isOutsideModel = false;  // the model does not cover all cuts
};

// Finds the peaks of force during a cut: it receives the material that each short move removes. A cut is judged over at
// least one turn of the spindle and a length that the samples of the profile can resolve, because a sample is never
// removed in part.
class ForcePeakMeter {
 public:
  // resolution: mm, spacing of the profile. The model must outlive the meter.
  ForcePeakMeter(const CuttingForceModel& model, const SpindleSetting& spindle, double resolution);

  // Adds a move of the tool: its length (mm) and time (s), the area that it removes from the part's half section (mm²),
  // and the largest radius of the removed material (mm). Times must be above zero if something is removed, unless the
  // move is rapid: a rapid move through material has no feed, and counts as kRapidFeed.
  void add(double length, double seconds, double area, double radius);
  // Adds a cut whose chip is known, like that of a thread, whose lead is no feed: width and thickness (mm), time (s),
  // and the radius of the work (mm).
  void addChip(double width, double thickness, double seconds, double radius);
  // Returns the peaks of all moves. Ends the cut that is being judged.
  ForcePeaks finish();

  static constexpr double kRapidFeed = 10.0;  // mm per turn

 private:
  void judge();
  void take(const CutConditions& cut, double radius);

  const CuttingForceModel* m_model;
  SpindleSetting m_spindle;
  double m_resolution;
  double m_time = 0.0;
  double m_length = 0.0, m_area = 0.0, m_turns = 0.0, m_radius = 0.0;  // the cut that is being judged
  ForcePeaks m_peaks;
};

// Returns the peaks of passes that cut a profile, one after the other; the time of each continues from the one before.
// The profile is a copy, which shares its pages. Cost: that of cutting. Returns nothing if it was cancelled.
std::optional<ForcePeaks> forcePeaks(TurnedProfile profile, std::span<const TurningPass> passes,
                                     const SpindleSetting& spindle, const CuttingForceModel& model,
                                     Progress progress = {});

}  // namespace handwheel

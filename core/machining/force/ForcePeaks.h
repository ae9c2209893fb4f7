// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/force/CuttingForceModel.h"

#include <optional>
#include <span>

namespace handwheel {

// How the spindle turns while a path is cut.
struct SpindleSetting {
  double speed = 0.0;         // r/min; with a constant surface speed the largest; 0 there: no limit
  double surfaceSpeed = 0.0;  // m/min, kept constant (G96); 0: the spindle speed is

  double at(double radius) const noexcept;  // r/min where the work has this radius (mm)
};

// The largest values of a path.
struct ForcePeaks {
  double force = 0.0;           // N, of all three components
  double power = 0.0;           // kW, of the cut
  double torque = 0.0;          // N·m, at the spindle
  CutConditions cut;            // where the force is largest
  double time = 0.0;            // s, of that, since the path began
  bool isOutsideModel = false;  // the model does not cover all that was cut
};

// Finds the peaks while something cuts: it receives what each short move removes. A cut is judged over at least one
// turn of the spindle and a length that the samples of the profile can resolve, for no sample goes in part.
class ForcePeakMeter {
 public:
  // resolution: mm, spacing of the profile. The model must outlive it.
  ForcePeakMeter(const CuttingForceModel& model, const SpindleSetting& spindle, double resolution);

  // A move of the tool: its length (mm) and time (s), the area that it removes of the part's half section (mm²), and
  // the largest radius of what goes (mm). Times must be above zero where something is removed, or the move is rapid:
  // through material that has no feed, and is counted as kRapidFeed.
  void add(double length, double seconds, double area, double radius);
  // A cut whose chip is known, as that of a thread, which no feed tells: how wide and thick it is (mm), its time (s),
  // and the radius of the work (mm).
  void addChip(double width, double thickness, double seconds, double radius);
  // The peaks of all moves. Ends the cut that is being judged.
  ForcePeaks finish();

  static constexpr double kRapidFeed = 10.0;  // mm per turn

 private:
  void judge();
  void take(const CutConditions& cut, double radius);

  const CuttingForceModel* m_model;
  SpindleSetting m_spindle;
  double m_resolution;
  double m_time = 0.0;
  double m_length = 0.0, m_area = 0.0, m_turns = 0.0, m_radius = 0.0;  // of the cut that is being judged
  ForcePeaks m_peaks;
};

// The peaks of passes that cut a profile, one after the other; the time of each goes on from the one before. The
// profile is a copy, which shares its pages. Cost: that of cutting. None: cancelled.
std::optional<ForcePeaks> forcePeaks(TurnedProfile profile, std::span<const TurningPass> passes,
                                     const SpindleSetting& spindle, const CuttingForceModel& model,
                                     Progress progress = {});

}  // namespace handwheel

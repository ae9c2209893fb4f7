// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/ChipGrowth.h"
#include "machining/force/CuttingForceModel.h"
#include "nurbs/StockCylinder.h"

namespace handwheel {

// The cut of a lathe at one moment, and the load on its spindle.
struct LatheLoad {
  bool isCutting = false;
  CutConditions cut;            // mean over the last samples of the profile
  double radius = 0.0;          // mm, mean radius of the removed material
  CutForces forces;             // N
  ProfilePoint press{0, 0};     // N, force that presses on a grinding tool, (r, z); it is part of `forces`
  ProfilePoint passive{1, 0};   // direction of the radial force on the tool, (r, z); its length is at most 1
  double torque = 0.0;          // N·m, torque at the spindle
  double power = 0.0;           // kW, power of the motor
  bool isOutsideModel = false;  // the law does not cover this cut
  double chatter = 0.0;         // strength of chatter, from 0 (none) to 1 (as strong as the cut)
  bool isOverloaded = false;    // the drive cannot hold the speed

  bool operator==(const LatheLoad&) const = default;
};

// Measures a cut while it is made. A step usually covers a fraction of a sample, so that material is removed in bursts.
// The values are therefore means over the last few samples, with weights that decay along the path. A meter may be used
// by one thread at a time.
class CutMeter {
 public:
  static constexpr double kSamples = 8.0;  // number of samples over which the weight falls to 1/e

  // The result of one step.
  struct Move {
    double length = 0.0;  // mm, travel of the tool
    double area = 0.0;    // mm², removed area of the half section, so that volume = 2π r · area
    double volume = 0.0;  // mm³, removed volume
    double turns = 0.0;   // spindle revolutions
    double time = 0.0;    // s
    // mm, length of the edge that cuts a thread; 0 for other cuts. It is the width of the chip. The thickness of the
    // chip is the growth of the groove divided by this width, because the lead of a thread is not a feed.
    double edge = 0.0;
  };
  // Adds a step. spacing: the distance between the samples of the profile, mm.
  void add(const Move& move, double spacing);

  bool isCutting() const { return m_isCutting; }
  double sinceCut() const { return m_sinceCut; }  // s, time since material was last removed
  // Returns the conditions of the cut. speed: the spindle speed, r/min.
  CutConditions cut(double speed) const;
  // Returns the conditions of the cut with the thickness of the chip as the feed. In the first turn in the material the
  // chip is thinner than the feed. speed: the spindle speed, r/min.
  CutConditions chip(double speed) const;
  double radius() const;  // mm, mean radius of the removed material

 private:
  double m_spacing = 1.0;
  double m_area = 0.0, m_volume = 0.0, m_distance = 0.0, m_turns = 0.0;  // weighted sums
  double m_edge = 0.0;                                                   // mm, edge of the last cut of a thread
  double m_distanceClear = 0.0;                                          // mm, travel since material was last removed
  double m_sinceCut = 0.0;
  ChipGrowth m_growth;
  bool m_isCut = false;  // true once anything was cut
  bool m_isCutting = false;
};

}  // namespace handwheel

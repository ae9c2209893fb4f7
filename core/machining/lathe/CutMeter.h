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
  ProfilePoint press{0, 0};     // N, part of the forces that presses on a grinding tool, in (r, z)
  ProfilePoint passive{1, 0};   // direction of the radial force on the tool, in (r, z), of length 1 at most
  double torque = 0.0;          // N·m, at the spindle
  double power = 0.0;           // kW, power of the motor
  bool isOutsideModel = false;  // the law does not cover this cut
  double chatter = 0.0;         // strength, from 0 (none) to 1 (as strong as the cut)
  bool isOverloaded = false;    // the drive cannot hold the speed

  bool operator==(const LatheLoad&) const = default;
};

// Measures a cut while it is made. A step mostly covers a fraction of a sample, so that material is removed in bursts:
// the values are those of the last few samples, with weights that decay along the path. One thread.
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
    // mm; for a thread, length of the edge that cuts. It is the width of the chip, whose thickness is the growth of the
    // groove over it: the lead is no feed.
    double edge = 0.0;
  };
  // spacing: mm, between the samples of the profile.
  void add(const Move& move, double spacing);

  bool isCutting() const { return m_isCutting; }
  double sinceCut() const { return m_sinceCut; }  // s since material was removed
  // Returns the conditions of the cut. speed: spindle speed, r/min.
  CutConditions cut(double speed) const;
  // The same as the edge feels them: in the first turn in the material the chip is thinner than the feed.
  CutConditions chip(double speed) const;
  double radius() const;  // mm, mean radius of the removed material

 private:
  double m_spacing = 1.0;
  double m_area = 0.0, m_volume = 0.0, m_distance = 0.0, m_turns = 0.0;  // weighted
  double m_edge = 0.0;                                                   // mm, edge of the last cut of a thread
  double m_distanceClear = 0.0;                                          // mm since material was removed
  double m_sinceCut = 0.0;
  ChipGrowth m_growth;
  bool m_isCut = false;  // anything was ever cut
  bool m_isCutting = false;
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/ChipGrowth.h"
#include "machining/force/CuttingForceModel.h"
#include "nurbs/StockCylinder.h"

namespace handwheel {

// What a lathe cuts at a moment, and what that asks of its spindle.
struct LatheLoad {
  bool isCutting = false;
  CutConditions cut;            // over the last samples of the profile
  double radius = 0.0;          // mm, mean, of what leaves
  CutForces forces;             // N
  ProfilePoint press{0, 0};     // N, of these on what grinds, in (r, z)
  ProfilePoint passive{1, 0};   // the way of the radial one on the tool, in (r, z), of length 1 at most
  double torque = 0.0;          // N·m, at the spindle
  double power = 0.0;           // kW, of the motor
  bool isOutsideModel = false;  // the law was not made for such a cut
  double chatter = 0.0;         // 0 none, 1 as strong as the cut
  bool isOverloaded = false;    // the drive cannot hold the speed

  bool operator==(const LatheLoad&) const = default;
};

// Measures a cut while it is made. A step goes over a part of a sample mostly, so that what it removes comes in bursts:
// the figures are those of the last few samples, with weights that fall along the way. One thread.
class CutMeter {
 public:
  static constexpr double kSamples = 8.0;  // over which the weight falls to 1/e

  // What a step did.
  struct Move {
    double length = 0.0;  // mm, of the way of the tool
    double area = 0.0;    // mm², of the half section, that left; so that volume = 2π r · area
    double volume = 0.0;  // mm³, that left
    double turns = 0.0;   // of the spindle
    double time = 0.0;    // s
    // mm, of a thread: of the edge that cuts. Its chip is as wide as that, and as thick as what the groove has grown by
    // over it: the lead is no feed.
    double edge = 0.0;
  };
  // spacing: mm, between the samples of the profile.
  void add(const Move& move, double spacing);

  bool isCutting() const { return m_isCutting; }
  double sinceCut() const { return m_sinceCut; }  // s since material left
  // speed: of the spindle, r/min.
  CutConditions cut(double speed) const;
  // The same as the edge feels it: in the first turn in the material the chip is thinner than the feed.
  CutConditions chip(double speed) const;
  double radius() const;  // mm, mean, of what leaves

 private:
  double m_spacing = 1.0;
  double m_area = 0.0, m_volume = 0.0, m_way = 0.0, m_turns = 0.0;  // weighted
  double m_edge = 0.0;                                              // mm, of the last cut of a thread
  double m_wayClear = 0.0;                                          // mm since material left
  double m_sinceCut = 0.0;
  ChipGrowth m_growth;
  bool m_isCut = false;  // ever
  bool m_isCutting = false;
};

}  // namespace handwheel

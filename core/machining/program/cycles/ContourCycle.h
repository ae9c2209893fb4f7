// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/cycles/ContourSegment.h"
#include "machining/program/cycles/CycleBudget.h"

namespace handwheel {

// The cycles that cut a contour: G71, G72 and G70. They are roughing along z or r in levels (G71, G72) and finishing
// passes (G70).
//
// The moves are those of LinuxCNC 2.9 (interp_g7x.cc), which its documentation describes: levels from the start on, an
// escape of 45 degrees, pockets cut once the level that meets them is reached, then along the contour. The contour
// begins at the start of the cycle; its first segment is the approach.
class ContourCycle {
 public:
  enum class Pockets { Cut, Leave, Only };  // G71, G71.1, G71.2
  struct Roughing {
    Pockets pockets = Pockets::Cut;
    bool isFacing = false;    // G72: levels across
    PlanePoint start;         // X and Z of the cycle
    PlanePoint displacement;  // U and W
    double allowance = 0.0;   // D, left on the contour
    double depth = 1.0;       // I, depth of a level
    double retract = 0.5;     // R
  };
  struct Finishing {
    PlanePoint start;
    double first = 0.0, last = 0.0;  // D and E, distances from the contour
    int passes = 1;                  // P
  };

  // location: location of the cycle, for refusals (ProgramRefusal): a contour that goes back, or does not have room for
  // the allowance. work: budget of all cycles of the program; must outlive the cycle.
  ContourCycle(std::vector<ContourSegment> contour, const SourceLocation& location, CycleBudget& work);

  void rough(const Roughing& how, const CycleOutput& out);
  void finish(const Finishing& how, const CycleOutput& out);

 private:
  using Segments = std::vector<ContourSegment>;

  CycleOutput turned(const CycleOutput& out) const;
  void rotate();
  void orient();  // turns the contour so that z and r decrease
  void finishCorners();
  void finishCorner(std::size_t i);
  void checkMonotonic();
  void offsetBy(double distance);
  void offsetStep(double step, bool isOutward);

  CycleBudget& m_work;
  Segments m_segments;
  SourceLocation m_location;
  int m_turned = 0;  // bits: 1 z mirrored, 2 r mirrored, 4 turned by a quarter
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/cycles/ContourLevels.h"
#include "machining/program/cycles/CycleBudget.h"

namespace handwheel {

// The cycles that cut a contour: G71, G72 and G70. G71 and G72 rough it in levels along z or r; G70 makes the finishing
// passes.
//
// The moves are the moves of LinuxCNC 2.9 (interp_g7x.cc), which its documentation describes. Levels are cut from the
// start of the cycle on, each with an escape of 45 degrees. Pockets are cut when the level that meets them is reached;
// a pass along the contour follows. The contour begins at the start of the cycle, and its first segment is the
// approach.
class ContourCycle {
 public:
  enum class Pockets { Cut, Leave, Only };  // G71, G71.1, G71.2
  struct Roughing {
    Pockets pockets = Pockets::Cut;
    bool isFacing = false;    // G72: levels along r
    PlanePoint start;         // X and Z, start of the cycle
    PlanePoint displacement;  // U and W, displacement of the contour
    double allowance = 0.0;   // D, material left on the contour
    double depth = 1.0;       // I, depth of a level
    double retract = 0.5;     // R, length of the escape
    RoughingMode mode = {};
    bool isMonotonic = false;  // the contour must not go back in the depth either; true for type I of a Fanuc
  };
  struct Finishing {
    PlanePoint start;
    double first = 0.0, last = 0.0;  // D and E, distances from the contour
    int passes = 1;                  // P, number of passes
  };

  // Throws ProgramRefusal if the contour goes back, or has no room for the allowance. location: the location of the
  // cycle, for refusals. work: the budget of all cycles of the program, which must outlive the cycle.
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
  void checkRising();
  void offsetBy(double distance);
  void offsetStep(double step, bool isOutward);

  CycleBudget& m_work;
  Segments m_segments;
  SourceLocation m_location;
  int m_turned = 0;  // bits: 1 z is mirrored, 2 r is mirrored, 4 the contour is turned by a quarter
};

}  // namespace handwheel

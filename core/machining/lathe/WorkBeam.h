// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"
#include "machining/force/CutWarnings.h"

#include <vector>

namespace handwheel {

// Bending of a part in the jaws, while the part is cut. The part is described by a beam that deflects as much as the
// part does at a position (z, mm): the shaft of one diameter that has the same ∫ (position - s)² / I(s) ds from the
// jaws to the position, where I(s) is the second moment of area at s. The beam ends at the end of the material. Sums
// along the axis are kept, so that each step of a tool can ask for a beam.
class WorkBeam {
 public:
  // grip: z of the front of the jaws, mm. O(samples).
  WorkBeam(const TurnedProfile& part, double grip);

  // Takes note of changed samples. It must be called after each cut. O(changed samples).
  void change(const TurnedProfile& part, const TurnedProfile::Range& changed);
  // Returns the beam for a cut at a position (z, mm), with the modulus and the tailstock of SlenderWork(). O(samples
  // below the position that were not asked for since their last change).
  SlenderWork at(const TurnedProfile& part, double position);

 private:
  // Sums over the samples from the jaws up to one of them, with their distances s from the jaws.
  struct Sums {
    double count = 0.0, first = 0.0, second = 0.0;         // sums of 1, s and s²
    double soft = 0.0, softFirst = 0.0, softSecond = 0.0;  // sums of the same, divided by r⁴ - inner⁴
  };
  void sumUpTo(const TurnedProfile& part, std::size_t end);

  double m_grip;
  std::size_t m_first, m_end;  // range of the samples with material that the jaws hold, from their front
  std::vector<Sums> m_sums;    // sums of the first samples of that range, with those of none at the beginning
};

// Returns the beam of a part for one position. O(samples).
SlenderWork beamOf(const TurnedProfile& part, double grip, double position);

}  // namespace handwheel

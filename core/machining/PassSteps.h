// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"

namespace handwheel {

// Cuts a pass into a part point by point. The part has the section of the pass only after settlePass().
class PassSteps {
 public:
  // number: the index of the pass in the part. The pass must outlive the steps. O(points).
  PassSteps(const TurningPass& pass, std::uint32_t number);

  // Cuts the move to a point of the pass, or the part of it between two fractions. Returns the samples that changed.
  TurnedProfile::Range cut(TurnedProfile& profile, std::size_t point, double from = 0.0, double to = 1.0) const;

 private:
  const TurningPass& m_pass;
  std::uint32_t m_number;
  std::vector<ProfilePoint> m_ends;  // WholeMove::end of each move; empty if no move faces
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/snap/SnapField.h"
#include "haptics/snap/SnapProfile.h"
#include "haptics/snap/SnapResult.h"

namespace handwheel {

// Snap force by the force method: the sum over all features in reach. The force is continuous if the profile is,
// because features enter and leave the reach with zero force.
//
// At most `most` items act at once. If more are in reach, the snap distance shrinks to the distance of the nearest item
// that is omitted. So features still enter and leave with zero force, and the force still depends on the position
// alone. Thousands of features within reach of one another pull the tip to the nearest of them instead of to their
// centre. (Inside a bend of a curve, the force may be discontinuous if more than `most` items are in reach.) Equal
// features count as one item, weighted by their number. If more than `most` features are nearly but not exactly at one
// point, there is almost no force around it.
//
// The time of a step grows with the number of items in reach, about 30 ns each. All segments and joints of a curve in
// reach take this time, even those whose forces cancel (SnapItem). A curve should have no more than a few dozen points
// within the snap distance. With thousands of points the work limit of a tick is reached (SnapResult::isCutShort).
//
// The class is used on the servo thread only, and does not allocate.
class SnapSum {
 public:
  static constexpr std::size_t kMost = 64;  // default of the fidelity setting snap.features

  explicit SnapSum(std::size_t most = kMost) : m_most(std::clamp<std::size_t>(most, 1, kLargest)) {}

  // Returns the pull on the device tip at `hand` (mm) in this tick. The pull is zero if the position is not finite.
  SnapResult step(const SnapField& field, const SnapProfile& profile, const Vec3& hand);

  static constexpr std::size_t kLargest = 1024;  // largest value of snap.features, for which memory is reserved

 private:
  struct Term {
    Vec3 displacement;  // mm, from the tip to the nearest point
    double distance2;
    double count;
    SnapFeature feature;
  };

  double gather(const SnapField& field, double distance, const Vec3& hand, bool& isCutShort);
  void add(const Term& term);

  void keepNearest();

  std::size_t m_most;
  std::size_t m_size = 0;
  double m_limit2 = 0.0;  // mm²: items further from the tip are ignored
  std::array<Term, 2 * kLargest + 2> m_terms;
};

}  // namespace handwheel

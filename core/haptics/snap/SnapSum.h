// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/snap/SnapField.h"
#include "haptics/snap/SnapProfile.h"
#include "haptics/snap/SnapResult.h"

namespace handwheel {

// Snap force by the force method: the sum over all features in reach. Continuous wherever the profile is: features
// enter and leave the reach with zero force.
//
// At most `most` items act at once. If more are in reach, the snap distance shrinks to the distance of the nearest that
// is left out: still they enter and leave with zero force, the force still depends on the position alone, and thousands
// within reach of one another pull the tip to the nearest of them instead of to their centre. (Within a bend of a
// curve, beside so many others, the force may be discontinuous.) Equal features count as one item, weighted by their
// number. If more than `most` features are nearly but not exactly at one point, there is almost no force around it.
//
// The time of a step grows with the number of items in reach, including the samples of a curve although they cancel
// (some 30 ns each): a curve should have no more than a few dozen of them within the snap distance; with thousands the
// tick is cut short.
//
// Servo thread only; no allocation.
class SnapSum {
 public:
  static constexpr std::size_t kMost = 64;  // default of the fidelity setting snap.features

  explicit SnapSum(std::size_t most = kMost) : m_most(std::clamp<std::size_t>(most, 1, kLargest)) {}

  // Returns the pull on the device tip at `hand` (mm) in this tick. Zero if the position is not finite.
  SnapResult step(const SnapField& field, const SnapProfile& profile, const Vec3& hand);

  static constexpr std::size_t kLargest = 1024;  // largest value of that setting, for which there is memory

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

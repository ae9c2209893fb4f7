// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/SnapField.h"
#include "haptics/SnapProfile.h"
#include "haptics/SnapPull.h"

namespace handwheel {

// The force method: the sum of the forces of all features in reach. Continuous wherever the profile is: whatever comes
// into reach or leaves it does so at no force.
//
// At most `most` items act at once. Where more are in reach, the snap distance shrinks to the distance of the nearest
// that is left out: still they come and go at no force, the place still decides alone, and thousands within reach of
// one another draw the hand to the nearest of them instead of to their middle. (Within a bend of a curve, beside so
// many others, this may leap.) Equal features count as one item, and as often as they are there. More than that many
// that are nearly but not quite at one place have next to no force around it.
//
// The time of a step grows with what is in reach, the samples of a curve included although they cancel (some 30 ns
// each): a curve wants no more than a few dozen of them within the snap distance, and of thousands the tick is cut
// short.
//
// For one thread, the servo's; no allocation.
class SnapSum {
 public:
  static constexpr std::size_t kMost = 64;

  explicit SnapSum(std::size_t most = kMost) : m_most(std::clamp<std::size_t>(most, 1, kLargest)) {}

  // What it does to a hand (mm) at this tick. Nothing for a hand that is not finite.
  SnapPull step(const SnapField& field, const SnapProfile& profile, const Vec3& hand);

  static constexpr std::size_t kLargest = 1024;

 private:
  struct Term {
    Vec3 way;  // mm, from the hand to the nearest point
    double distance2;
    double count;
    SnapFeature feature;
  };

  double gather(const SnapField& field, double distance, const Vec3& hand, bool& isCutShort);
  void add(const Term& term);

  void keepNearest();

  std::size_t m_most;
  std::size_t m_size = 0;
  double m_limit2 = 0.0;  // mm²: of what is further from the hand nothing is wanted
  std::array<Term, 2 * kLargest + 2> m_terms;
};

}  // namespace handwheel

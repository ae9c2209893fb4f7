// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "machining/measure/ProfileMeasure.h"

#include <vector>

namespace handwheel {

// The shape that a turned part is to have: straight lines through points (r, z), mm, which never go back in z. Arcs are
// given by as many points as their tolerance needs. Faces are two points at one height.
class ReferenceProfile {
 public:
  static constexpr std::size_t kMostPoints = 20'000;

  // outer: from the lower end to the upper one, at least two points. inner: of the bore, the same way; empty for none.
  // Errors: FileTooLarge {points, count, limit}, ElementMalformed {"target", what is wrong}.
  static Result<ReferenceProfile> make(std::vector<ProfilePoint> outer, std::vector<ProfilePoint> inner);

  const std::vector<ProfilePoint>& outer() const { return m_outer; }
  const std::vector<ProfilePoint>& inner() const { return m_inner; }
  double from() const { return m_outer.front().y(); }  // mm
  double to() const { return m_outer.back().y(); }

  // The radius at a height; at a face the larger one. 0 beyond the ends. O(log points).
  double radius(TurningSide side, double z) const;
  // The distance (mm) of a point from the nearest line of this side and its faces at the ends; infinite for a bore
  // where there is none. O(log points) near the profile.
  double distance(TurningSide side, const ProfilePoint& p) const;

  bool operator==(const ReferenceProfile&) const = default;

 private:
  ReferenceProfile() = default;

  std::vector<ProfilePoint> m_outer, m_inner;
  std::vector<ProfilePoint> m_outerClosed;  // with the faces at the ends, as far as the bore
};

// How far a part is from what it is to be, normal to that, mm.
struct ReferenceDeviation {
  double left = 0.0, leftAt = 0.0;      // the largest, of material that is too much, and the height of it
  double gouged = 0.0, gougedAt = 0.0;  // of material that is missing; positive
  double largest() const { return left > gouged ? left : gouged; }
};

// Of all samples of the part in the range, inside and outside. Incomplete once cancelled.
ReferenceDeviation deviationFrom(const ReferenceProfile& reference, const TurnedProfile& profile, AxisRange range,
                                 Progress progress = {});

}  // namespace handwheel

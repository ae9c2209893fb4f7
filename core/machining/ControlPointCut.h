// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"

namespace handwheel {

// Cuts a turned profile by moving control points, which have a fixed spacing.
//
// The profile is treated as a curve of degree 2 over clamped knots at this distance. Where the nose is deepest below
// it, by d at the parameter u, the control point k with the largest basis function moves by d V / R_k(u), so that the
// curve is as deep as the nose there (He 2008, eq. 5-9). V points straight towards the axis, or away from it in a bore:
// so control points keep their order along the axis, and the curve changes by the basis function alone. That change is
// applied to the samples. The curve cannot fold or cross the axis, material is only removed, and corners between
// samples stay. Beside u the control point removes more or less than the nose does: the error of this method. A depth
// is taken in parts of a quarter of the distance, so that the error is of the order of the distance. Only beside a
// wall, where the nose is deeper than its radius, a notch as wide as the distance removes up to half of the height of
// the wall: a property of moving the strongest control point alone.
//
// The depth is that of the nose as it is recorded. The servo loop moves the nose by force over resistance in each tick,
// which is d = F_r / κ (eq. 5-10) with κ = resistance times width of the chip over the period.
class ControlPointCut {
 public:
  static constexpr double kLeastResolution = 0.01, kLargestResolution = 100.0;  // mm

  // resolution: mm between control points; clamped to these limits, and adjusted so that the length is a multiple of
  // it. isInParts: a depth is taken in parts; early versions of the program took it whole, and their passes are
  // repeated so.
  ControlPointCut(const TurnedProfile& profile, double resolution, bool isInParts = true);

  // Cuts with a nose of this radius (mm). Its centre moves straight from a to b, (r, z). Returns the samples that
  // changed. Points that are not finite cut nothing. O(work()).
  TurnedProfile::Range cut(TurnedProfile& profile, TurningSide side, const ProfilePoint& a, const ProfilePoint& b,
                           double noseRadius) const;

  // Returns the largest number of samples that cut() visits. isFree: the nose is in no material at a, as after a cut
  // that ended there.
  double work(const TurnedProfile& profile, const ProfilePoint& a, const ProfilePoint& b, double noseRadius,
              bool isFree) const;

 private:
  struct Deepest {
    std::size_t sample = 0;
    double depth = 0.0;  // mm
  };
  double basis(std::size_t pole, double z) const;
  std::size_t strongest(double z) const;
  std::size_t movesUnder(double noseRadius) const;
  double mostPartsAfter(double travel, double noseRadius) const;
  TurnedProfile::Range cutAt(TurnedProfile& profile, TurningSide side, const ProfilePoint& nose, double radius,
                             double mostParts, std::size_t movesBefore) const;
  double positionsOn(const TurnedProfile& profile, const ProfilePoint& a, const ProfilePoint& b,
                     double noseRadius) const;
  Deepest deepestUnder(const TurnedProfile& profile, TurningSide side, const ProfilePoint& nose, double radius) const;
  TurnedProfile::Range move(TurnedProfile& profile, TurningSide side, std::size_t pole, double by) const;

  std::size_t m_spans;
  double m_span;  // mm between two knots
  bool m_isInParts;
};

}  // namespace handwheel

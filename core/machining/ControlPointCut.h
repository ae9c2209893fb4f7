// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"

namespace handwheel {

// Cuts a turned profile by moving control points, which have a fixed spacing.
//
// The profile is treated as a curve of degree 2 over clamped knots at the spacing of the control points. At the
// parameter u where the nose is deepest below the curve, by d, the control point k with the largest basis function
// moves by d V / R_k(u), so that the curve becomes as deep as the nose at u (He 2008, eq. 5-9). V points straight
// towards the axis, or away from it in a bore. Control points therefore keep their order along the axis, and the curve
// changes by the basis function alone. That change is applied to the samples. The curve cannot fold or cross the axis,
// material is only removed, and corners between samples are kept. Beside u the control point removes more or less than
// the nose does, which is the error of this method. A depth is taken in parts of a quarter of the spacing, so that the
// error is of the order of the spacing. The error is larger beside a wall, where the nose is deeper than its radius:
// because only the strongest control point moves, a notch as wide as the spacing removes up to half of the height of
// the wall.
//
// The depth d is the depth of the recorded nose. In each tick the servo loop moves the nose by force over resistance,
// which is d = F_r / κ (He 2008, eq. 5-10) with κ = resistance times width of the chip over the period.
class ControlPointCut {
 public:
  static constexpr double kLeastResolution = 0.01, kLargestResolution = 100.0;  // mm

  // resolution: the spacing of the control points, mm. It is clamped to kLeastResolution and kLargestResolution, and
  // adjusted so that the length is a multiple of it. isInParts: true if a depth is taken in parts. Early versions of
  // the program took a depth whole, and their passes are repeated with false.
  ControlPointCut(const TurnedProfile& profile, double resolution, bool isInParts = true);

  // Cuts with a nose of this radius (mm). The centre of the nose moves straight from a to b, given as (r, z). Returns
  // the samples that changed. Points that are not finite cut nothing. O(work()).
  TurnedProfile::Range cut(TurnedProfile& profile, TurningSide side, const ProfilePoint& a, const ProfilePoint& b,
                           double noseRadius) const;

  // Returns the largest number of samples that cut() visits. isFree: true if the nose is in no material at a, for
  // example after a cut that ended at a.
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

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/PagedArray.h"
#include "nurbs/StockCylinder.h"

#include <cstdint>

namespace handwheel {

// The profile of a part on a lathe: radii at equal steps of z. Material lies between the axis and the profile. A copy
// shares its pages with the original, so a version costs only what was cut since. The lower end is at z = 0.
//
// Between two samples the radius is linear. What a round nose of radius R leaves between its passes is therefore off
// by at most spacing²/(8R) where the nose is tangent to the axis; steep flanks are off by a spacing in z.
class TurnedProfile {
 public:
  static constexpr std::size_t kMostSamples = 200'000;

  // A range of samples; empty where first == last.
  struct Range {
    std::size_t first = 0, last = 0;
    bool isEmpty() const { return first >= last; }
    std::size_t size() const { return isEmpty() ? 0 : last - first; }
    void extend(const Range& other);
  };

  // An uncut bar. spacing: mm, the fidelity setting turn.spacing; widened where the bar would have more samples than
  // kMostSamples. The stock must be sound.
  TurnedProfile(const StockCylinder& stock, double spacing);
  // From saved radii, at least two, all finite and not negative. length: mm, of the part.
  static TurnedProfile fromRadii(const std::vector<double>& radii, double length);

  std::size_t size() const { return m_radii.size(); }
  double spacing() const { return m_spacing; }  // mm
  double length() const { return m_spacing * static_cast<double>(size() - 1); }
  double z(std::size_t i) const { return m_spacing * static_cast<double>(i); }
  double radius(std::size_t i) const { return m_radii[i]; }  // mm

  // Removes the material that a disc of this radius (mm, > 0) sweeps with its centre moving straight from a to b, given
  // as (r, z), and all that lies outside of it: the shank of a tool comes from there. Returns the samples that changed.
  // Points that are not finite cut nothing. O(samplesUnder()).
  Range cut(const ProfilePoint& a, const ProfilePoint& b, double noseRadius);

  // The samples below such a sweep, which cut() visits. O(1).
  Range samplesUnder(const ProfilePoint& a, const ProfilePoint& b, double noseRadius) const;

  double volume() const;  // mm³, of the frustums between the samples; O(samples)
  double area() const;    // mm², of their lateral surfaces and the two flat ends; O(samples)

  // In how many pieces the part is: where the radius is 0 it is parted. O(samples).
  std::size_t pieces() const;

  // The profile from the lower end to the upper, with as few points as stay within `chord` (mm) of it.
  std::vector<ProfilePoint> polyline(double chord) const;

  bool operator==(const TurnedProfile& other) const;  // bit for bit

 private:
  TurnedProfile() = default;

  double m_spacing = 0.0;
  PagedArray<double> m_radii;
};

}  // namespace handwheel

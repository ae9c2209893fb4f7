// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/PagedArray.h"
#include "nurbs/StockCylinder.h"

#include <cstdint>

namespace handwheel {

// The side from which the shank of a tool comes. A cut with the nose removes all material on that side.
enum class TurningSide { Outside, Bore };

// The sampled profile of a turned part. It has outer and inner radii at equal steps of z. Material lies between the
// inner radius of a sample, 0 if it is not bored, and the outer one, which is never smaller; if both are equal there is
// no material. A copy shares its pages with the original, so a version costs only what was cut since. The lower end is
// at z = 0.
//
// Between two samples the radii are linear. The ridges that a round nose of radius R leaves between its passes are
// therefore off by at most spacing²/(8R) where the nose is tangent to the axis; steep flanks are off by a spacing in z.
class TurnedProfile {
 public:
  static constexpr std::size_t kMostSamples = 200'000;

  // A range of samples; empty if first == last.
  struct Range {
    std::size_t first = 0, last = 0;
    bool isEmpty() const { return first >= last; }
    std::size_t size() const { return isEmpty() ? 0 : last - first; }
    void extend(const Range& other);
  };

  // An uncut bar. spacing: mm, the fidelity setting turn.spacing; increased if the bar would have more samples than
  // kMostSamples. The stock must be sound.
  TurnedProfile(const StockCylinder& stock, double spacing);
  // Returns the uncut bar of a part, with as many samples (at least two) as the part has; the spacing of the part alone
  // may give one sample more.
  static TurnedProfile barOf(const StockCylinder& stock, std::size_t samples);
  // Returns a profile with saved radii, at least two, all finite and not negative. length: mm, length of the part.
  static TurnedProfile fromRadii(const std::vector<double>& radii, double length);
  // The same with a bore: as many inner radii, none negative or larger than the outer one.
  static TurnedProfile fromRadii(const std::vector<double>& radii, const std::vector<double>& inner, double length);

  std::size_t size() const { return m_radii.size(); }
  double spacing() const { return m_spacing; }  // mm
  double length() const { return m_spacing * static_cast<double>(size() - 1); }
  double z(std::size_t i) const { return m_spacing * static_cast<double>(i); }
  double radius(std::size_t i) const { return m_radii[i]; }                   // mm, outer
  double inner(std::size_t i) const { return isBored() ? m_inner[i] : 0.0; }  // mm
  bool isBored() const { return !m_inner.empty(); }                           // true if an inner radius was ever raised
  bool hasMaterial(std::size_t i) const { return m_radii[i] > inner(i); }

  // Lowers the outer radius of a sample to this one (mm) if it is larger, but never below the inner one. Returns true
  // if it changed. A radius that is not finite changes nothing.
  bool limitOuter(std::size_t i, double radius);
  // Raises the inner radius of a sample to this one (mm) if it is smaller, but never above the outer one.
  bool limitInner(std::size_t i, double radius);

  // Removes the material that a disc of this radius (mm, > 0) sweeps with its centre moving straight from a to b, given
  // as (r, z), and all material outside of it, since the shank of a tool comes from there. A disc that stays within the
  // bore leaves the wall around it. Returns the samples that changed. Points that are not finite cut nothing.
  // O(samplesUnder()).
  Range cut(const ProfilePoint& a, const ProfilePoint& b, double noseRadius);

  // The same from the inside out: removes the material that the disc sweeps and all between it and the axis, since the
  // shank of a boring bar comes from there. A disc that stays outside of the part leaves it.
  Range cutBore(const ProfilePoint& a, const ProfilePoint& b, double noseRadius);

  // Returns the samples below such a sweep, which cut() and cutBore() visit. O(1).
  Range samplesUnder(const ProfilePoint& a, const ProfilePoint& b, double noseRadius) const;

  double volume() const;  // mm³, volume of the frustums between the samples; O(samples)
  double area() const;    // mm², lateral surfaces, outer and inner, and the two flat ends; O(samples)

  // Returns the number of pieces of the part, which is parted where a sample has no material. O(samples).
  std::size_t pieces() const;

  bool operator==(const TurnedProfile& other) const;  // bit for bit

 private:
  TurnedProfile() = default;

  double m_spacing = 0.0;
  PagedArray<double> m_radii;
  PagedArray<double> m_inner;  // empty until an inner radius is raised
};

}  // namespace handwheel

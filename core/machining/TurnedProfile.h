// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/PagedArray.h"
#include "nurbs/StockCylinder.h"

#include <cstdint>
#include <memory>

namespace handwheel {

class SectionSource;

// The side from which the shank of a tool comes. A cut removes all material between the nose and that side.
enum class TurningSide { Outside, Bore };

// The sampled profile of a turned part. It has outer and inner radii at equal steps of z. Material lies between the
// inner radius of a sample and its outer radius, which is never smaller. The inner radius is 0 if the sample is not
// bored; a sample with two equal radii has no material. A copy shares its pages with the original, so it costs only the
// memory of the samples that are cut afterwards. The lower end is at z = 0.
//
// The samples are what the display and the servo loop read while a pass is under way. The exact shape of the part is
// its section, lines and arcs without samples: lengths, faces, drawings and exports are read from that.
//
// Between two samples the radii are linear. The error of the ridges that a round nose of radius R leaves between its
// passes is therefore at most spacing²/(8R) where the tangent of the nose is parallel to the axis. The error of steep
// flanks is at most one spacing in z.
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

  // Creates an uncut bar. spacing: the fidelity setting turn.spacing, mm. It is increased if the bar would have more
  // samples than kMostSamples. The stock must be sound.
  TurnedProfile(const StockCylinder& stock, double spacing);
  // Returns the uncut bar of a part. samples: the number of samples of the part, at least two. The spacing of the part
  // would not do instead, because rounding may give one sample more.
  static TurnedProfile barOf(const StockCylinder& stock, std::size_t samples);
  // Returns a profile with saved outer radii. There must be at least two; all must be finite and not negative. length:
  // the length of the part, mm.
  static TurnedProfile fromRadii(const std::vector<double>& radii, double length);
  // Returns a profile with saved outer and inner radii. There must be an inner radius for each outer one, not negative
  // and not larger than it.
  static TurnedProfile fromRadii(const std::vector<double>& radii, const std::vector<double>& inner, double length);

  std::size_t size() const { return m_radii.size(); }
  double spacing() const { return m_spacing; }  // mm
  double length() const { return m_spacing * static_cast<double>(size() - 1); }
  double z(std::size_t i) const { return m_spacing * static_cast<double>(i); }
  double radius(std::size_t i) const { return m_radii[i]; }                   // mm, outer radius
  double inner(std::size_t i) const { return isBored() ? m_inner[i] : 0.0; }  // mm
  bool isBored() const { return !m_inner.empty(); }                           // true once an inner radius was raised
  // Returns the source of the exact section; null if the samples were changed since it was set, or if it is not known.
  const std::shared_ptr<const SectionSource>& section() const { return m_section; }
  void setSection(std::shared_ptr<const SectionSource> section) { m_section = std::move(section); }
  bool hasMaterial(std::size_t i) const { return m_radii[i] > inner(i); }

  // Lowers the outer radius of a sample to this radius (mm) if it is larger, but never below the inner radius. Returns
  // true if the profile changed. A radius that is not finite changes nothing.
  bool limitOuter(std::size_t i, double radius);
  // Raises the inner radius of a sample to this radius (mm) if it is smaller, but never above the outer radius. Returns
  // true if the profile changed. A radius that is not finite changes nothing.
  bool limitInner(std::size_t i, double radius);

  // Sets the radii of a sample (mm, finite, 0 ≤ inner ≤ outer). Returns true if the profile changed.
  bool set(std::size_t i, double outer, double inner);

  // Removes the material that a disc of this radius (mm, > 0) sweeps while its centre moves straight from a to b, given
  // as (r, z). All material farther from the axis than the disc is removed, too, because the shank of a tool comes from
  // that side. A disc that stays within the bore removes nothing of the wall around it. Returns the samples that
  // changed. Points that are not finite cut nothing. Cost: O(1) for each sample of samplesUnder().
  Range cut(const ProfilePoint& a, const ProfilePoint& b, double noseRadius);

  // Removes the material that the disc of cut() sweeps, and all material between the disc and the axis, because the
  // shank of a boring bar comes from that side. A disc that stays outside of the part removes nothing. Returns the
  // samples that changed.
  Range cutBore(const ProfilePoint& a, const ProfilePoint& b, double noseRadius);

  // Returns the samples below the sweep of a disc. cut() and cutBore() visit these samples. O(1).
  Range samplesUnder(const ProfilePoint& a, const ProfilePoint& b, double noseRadius) const;

  double volume() const;  // mm³, volume of the frustums between the samples; O(samples)
  double area() const;    // mm², area of the outer and inner surfaces and the two flat ends; O(samples)

  // Returns the samples of each piece of the part, which is parted where a sample has no material, from the one in the
  // chuck to the free end. O(samples).
  std::vector<Range> pieces() const;

  bool operator==(const TurnedProfile& other) const;  // compares the samples bit for bit, not the sections

 private:
  TurnedProfile() = default;

  double m_spacing = 0.0;
  PagedArray<double> m_radii;
  PagedArray<double> m_inner;  // empty until an inner radius is raised
  std::shared_ptr<const SectionSource> m_section;
};

}  // namespace handwheel

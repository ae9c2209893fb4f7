// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "nurbs/ProfileCurve.h"
#include "scene/BodyGeometry.h"

namespace handwheel {

// The shape of a turned part: its profile revolved about z. It has flat ends where the profile begins and ends.
class RevolvedGeometry : public BodyGeometry {
 public:
  static constexpr std::string_view kKind = "revolution";
  static constexpr double kLeastChord = 1e-4, kLargestChord = 1e3;  // mm
  // The maximum number of triangles of the surface. The chord tolerance is increased if the surface would have more.
  static constexpr std::uint64_t kMostTriangles = 500'000;

  // Makes a shape. chord: mm, tolerance of the surface. Errors: ValueOutOfRange {"chord", value, least, largest}.
  static Result<std::shared_ptr<const RevolvedGeometry>> make(ProfileCurve profile, double chord);

  const ProfileCurve& profile() const { return m_profile; }
  double chord() const { return m_chord; }

  std::string_view kind() const override { return kKind; }
  std::size_t bytes() const override;

 protected:
  std::shared_ptr<const TriangleSoup> makeSurface() const override;

 private:
  RevolvedGeometry(ProfileCurve profile, double chord) : m_profile(std::move(profile)), m_chord(chord) {}

  ProfileCurve m_profile;
  double m_chord;
};

}  // namespace handwheel

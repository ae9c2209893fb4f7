// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/TargetProfile.h"

#include <vector>

namespace handwheel {

// A surface of a turned part that a drawing gives a dimension to.
struct ProfileFeature {
  enum class Kind { Cylinder, Taper, FlatFace, Arc };
  Kind kind = Kind::Cylinder;
  bool isInner = false;                // of a bore
  ProfilePoint low{0, 0}, high{0, 0};  // its ends, mm: low is further down, or nearer to the axis for a face
  // By kind: the diameter (mm); the angle between the surface and the axis (rad, > 0); unused; the radius (mm).
  double value = 0.0;
  ProfilePoint centre{0, 0};  // of an arc
  bool isConvex = false;      // of an arc: it bulges out of the material

  double length() const { return high.y() - low.y(); }  // mm, along the axis
};

// Finds the features of a profile, along its outline. Neighbours on one line or circle are one; what deviates from a
// cylinder or flat face by less than the tolerance (mm) is one. O(segments).
std::vector<ProfileFeature> featuresOf(const TargetProfile& profile, double tolerance);

// The word for a kind in reports: "cylinder", "taper", "face", "arc".
const char* nameOf(ProfileFeature::Kind kind);

}  // namespace handwheel

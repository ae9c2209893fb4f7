// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/TargetProfile.h"

#include <vector>

namespace handwheel {

// A surface of a turned part that a drawing gives a dimension to.
struct ProfileFeature {
  enum class Kind { Cylinder, Taper, FlatFace, Arc, Curve };
  Kind kind = Kind::Cylinder;
  bool isInner = false;                // belongs to a bore
  ProfilePoint low{0, 0}, high{0, 0};  // its ends, mm: low is further down, or nearer to the axis for a face
  // The value by kind: the diameter (mm); the angle between the surface and the axis (rad, > 0); unused; the radius
  // (mm); unused.
  double value = 0.0;
  ProfilePoint centre{0, 0};  // centre of an arc
  bool isConvex = false;      // the arc bulges out of the material

  double length() const { return high.y() - low.y(); }  // mm, along the axis
};

// Finds the features of a profile, along its outline. Neighbours on one line or circle are one feature; a surface that
// deviates from a cylinder or flat face by less than the tolerance (mm) is one. O(segments).
std::vector<ProfileFeature> featuresOf(const TargetProfile& profile, double tolerance);

// The same for lists: a curve of many short lines is one Curve from end to end, since nobody turns it taper by taper.
// It is a run of five lines or more, none longer than 10 mm along the axis, with angles of 30° at most between them;
// cylinders at its ends are not part of it. O(features).
std::vector<ProfileFeature> withCurves(const std::vector<ProfileFeature>& features);

// Returns the word for a kind in reports: "cylinder", "taper", "face", "arc", "curve".
const char* nameOf(ProfileFeature::Kind kind);

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/TargetProfile.h"

#include <vector>

namespace handwheel {

// A surface of a turned part that has a dimension on a drawing.
struct ProfileFeature {
  enum class Kind { Cylinder, Taper, FlatFace, Arc, Curve };
  Kind kind = Kind::Cylinder;
  bool isInner = false;                // the surface belongs to a bore
  ProfilePoint low{0, 0}, high{0, 0};  // mm, the ends; `low` is further down, or for a face nearer to the axis
  // The diameter (mm) of a cylinder, the angle between a taper and the axis (rad, > 0), or the radius (mm) of an arc.
  // It is unused for other kinds.
  double value = 0.0;
  ProfilePoint centre{0, 0};  // centre of an arc
  bool isConvex = false;      // the arc bulges out of the material
  bool isDownwards = false;   // the outline runs from `high` to `low`

  const ProfilePoint& start() const { return isDownwards ? high : low; }  // in the direction of the outline
  const ProfilePoint& end() const { return isDownwards ? low : high; }
  double length() const { return high.y() - low.y(); }  // mm, along the axis
};

// Returns the features of a profile in the order of its outline. Neighbours on one line or circle are one feature. A
// surface that deviates from a cylinder or a flat face by less than the tolerance (mm) counts as a cylinder or a flat
// face. O(segments).
std::vector<ProfileFeature> featuresOf(const TargetProfile& profile, double tolerance);

// Returns features for a list of dimensions, in which a curve of many short lines is one Curve from end to end, because
// it is not turned taper by taper. A curve is a sequence of five lines or more, none longer than 10 mm along the axis,
// with angles of at most 30° between them. Cylinders at the ends of the sequence are not part of the curve.
// O(features).
std::vector<ProfileFeature> withCurves(const std::vector<ProfileFeature>& features);

// Returns the word for a kind in reports: "cylinder", "taper", "face", "arc", "curve".
const char* nameOf(ProfileFeature::Kind kind);

}  // namespace handwheel

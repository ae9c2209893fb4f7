// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/ProfileFeatures.h"

#include <optional>
#include <vector>

namespace handwheel {

// The features of a drawn part, and which of their sizes follow from others.
//
// A drawing states each size once (ISO 129-1). The positions of a fillet follow from its radius, those of a chamfer
// from the face beside it, and the end of an arc whose centre has a dimension follows from the surface that it meets.
class DrawnOutline {
 public:
  // features: in the order of the outline, without those that are too small to be drawn. isClosed: true for a part that
  // is bored through.
  DrawnOutline(std::vector<ProfileFeature> features, bool isClosed);

  const std::vector<ProfileFeature>& features() const { return m_features; }

  // Returns true for a taper of 45° that breaks the edge of a flat face.
  bool isEdgeChamfer(std::size_t i) const;
  // Returns the point at which an arc off the axis is furthest from the axis or nearest to it, if that lies between its
  // ends.
  std::optional<ProfilePoint> extremeOf(std::size_t i) const;
  // Returns true if a diameter is needed at an end of the feature: the end of a taper or an arc, which no other size
  // determines.
  bool needsDiameter(std::size_t i, bool atEnd) const;
  // Returns the z of the dimensions of one side: of the faces first, since nearly equal heights count as one.
  std::vector<double> heights(bool isInner) const;

 private:
  enum class Joint { None, Corner, Smooth, SmoothAlongAxis };

  bool is(std::size_t i, ProfileFeature::Kind kind) const { return m_features[i].kind == kind; }
  std::optional<std::size_t> neighbour(std::size_t i, bool atEnd) const;
  Joint jointAt(std::size_t i, bool atEnd) const;
  bool isBall(std::size_t i) const;
  bool endsOnAxis(std::size_t i) const;
  bool isEquator(std::size_t i, bool atEnd) const;  // two arcs meet at their widest or narrowest point
  bool isFillet(std::size_t i) const;               // an arc that touches both its neighbours
  bool hasOwnCentre(std::size_t i) const;           // the height of a ball's centre has a dimension
  // Returns true for an arc whose centre follows from dimensions, or from the surfaces that it touches.
  bool hasFixedCentre(std::size_t i) const;
  bool isHeight(std::size_t before, std::size_t after) const;

  std::vector<ProfileFeature> m_features;
  bool m_isClosed;
};

// Returns true for a short taper of 45°.
bool isChamfer(const ProfileFeature& f);

}  // namespace handwheel

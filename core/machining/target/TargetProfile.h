// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "machining/target/ProfileHierarchy.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace handwheel {

// The exact half section of a turned part: lines and arcs around its material.
//
// The outline has the material on its left, so it runs upwards along the outside. If the part is bored through, the
// outline is closed. Otherwise it begins and ends on the axis, which closes it, and the lower end comes first. It does
// not cross or touch itself, and it does not touch the axis between its ends. A profile is immutable and may be used on
// any thread; copies share all data.
class TargetProfile {
 public:
  static constexpr std::size_t kMostSegments = 100'000;
  static constexpr double kLargestCoordinate = 1e6;  // mm, positive or negative
  static constexpr double kJoin = 1e-6;              // mm; ends nearer than this are joined

  // Makes a profile from segments, which must be in order. They may run in either direction, and may include pieces on
  // the axis. Open ends off the axis are joined to the axis by flat faces, or to each other if they are at the same
  // height. O(n log n + p) for p pairs of segments whose boxes meet; too many pairs are refused. Errors: FileTooLarge
  // {segments}, ValueOutOfRange {coordinate}, TargetError::NotJoined, CrossesAxis, TouchesAxis, CrossesItself,
  // TooIntricate, NoArea, and Cancelled.
  static Result<TargetProfile> make(std::vector<ProfileSegment> segments, Progress progress = {});

  std::span<const ProfileSegment> segments() const { return m_outline->segments; }
  bool isClosed() const { return m_outline->isClosed; }
  double lowerEnd() const { return m_outline->box.min().y(); }  // mm, z
  double upperEnd() const { return m_outline->box.max().y(); }
  double length() const { return upperEnd() - lowerEnd(); }
  double largestRadius() const { return m_outline->box.max().x(); }
  double volume() const { return m_outline->volume; }  // mm³

  // Returns the signed distance (mm) of a point from the surface. It is positive outside of the material, and NaN if
  // the point is not finite. O(log n).
  double distance(const ProfilePoint& p) const;

  // The least and the largest radius of the material at a height. `inner` is 0 if the material contains the axis. At a
  // flat face, the material on both sides of the face counts. Grooves between the two radii are not represented.
  struct Extent {
    double inner = 0.0, outer = 0.0;  // mm
  };
  // Returns the extent of the material at a height, or nothing above and below the part. O(log n).
  std::optional<Extent> extentAt(double z) const;

  // Returns the part moved along the axis by dz (mm).
  TargetProfile moved(double dz) const;
  // Returns the part turned end for end. The heights of its two ends stay the same.
  TargetProfile turnedEndForEnd() const;

  bool operator==(const TargetProfile& other) const;

 private:
  struct Outline {
    std::vector<ProfileSegment> segments;
    bool isClosed;
    ProfileBox box;
    double volume;
    ProfileHierarchy tree;
  };
  explicit TargetProfile(std::vector<ProfileSegment> sound, bool isClosed);
  bool isOutsideOfCorner(std::size_t segment, bool atEnd, const ProfilePoint& p) const;

  std::shared_ptr<const Outline> m_outline;
};

}  // namespace handwheel

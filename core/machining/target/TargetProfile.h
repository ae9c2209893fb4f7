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
// The outline runs with the material on its left, so up along the outside. If the part is bored through, the outline is
// closed; else it begins and ends on the axis, which closes it, and the lower end comes first. It does not cross or
// touch itself, nor the axis between its ends. Immutable; copies share everything; any thread.
class TargetProfile {
 public:
  static constexpr std::size_t kMostSegments = 100'000;
  static constexpr double kLargestCoordinate = 1e6;  // mm, positive or negative
  static constexpr double kJoin = 1e-6;              // mm: ends nearer than this are one

  // Makes a profile from segments in order, in either direction; pieces on the axis may be among them. Open ends off
  // the axis are joined to it by flat faces, or to each other if they are at the same height. O(n log n + p) for p
  // pairs of segments whose boxes meet; too many are refused. Errors: FileTooLarge {segments}, ValueOutOfRange
  // {coordinate}, and TargetError: NotJoined, CrossesAxis, TouchesAxis, CrossesItself, TooIntricate, NoArea; Cancelled.
  static Result<TargetProfile> make(std::vector<ProfileSegment> segments, Progress progress = {});

  std::span<const ProfileSegment> segments() const { return m_outline->segments; }
  bool isClosed() const { return m_outline->isClosed; }
  double lowerEnd() const { return m_outline->box.min().y(); }  // mm, z
  double upperEnd() const { return m_outline->box.max().y(); }
  double length() const { return upperEnd() - lowerEnd(); }
  double largestRadius() const { return m_outline->box.max().x(); }
  double volume() const { return m_outline->volume; }  // mm³

  // Returns the signed distance from the surface (mm): above zero outside of the material. O(log n); NaN if the point
  // is not finite.
  double distance(const ProfilePoint& p) const;

  // The least and the largest radius of the material at a height; inner is 0 if the axis is in it. At a flat face, of
  // both sides together. Grooves between the two are not represented. Returns nothing above and below the part. O(log
  // n).
  struct Extent {
    double inner = 0.0, outer = 0.0;  // mm
  };
  std::optional<Extent> extentAt(double z) const;

  // Returns the same part further up.
  TargetProfile moved(double dz) const;
  // Returns the same part turned end for end, between the same heights.
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

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/PagedArray.h"
#include "volume/drilling/DrillRun.h"

#include <array>
#include <cstdint>

namespace handwheel {

// A stored pose of a drill's head in one cycle. Replaying the poses of a hole reproduces it to the last bit.
struct DrillPose {
  static constexpr double kStep = 1e-6;  // mm; fine enough for smooth steps of a slow hand at 1 kHz

  std::uint64_t micros = 0;          // µs since the start of the hole
  std::array<std::int64_t, 3> at{};  // position of the centre, in units of kStep
  std::array<float, 3> axis{};       // direction towards the shank

  // Rounds a pose to a stored one. Values that cannot be stored, such as negative times or positions too far away, are
  // replaced by the nearest ones that can.
  static DrillPose of(const Vec3& position, const Vec3& axis, double seconds);

  double seconds() const { return 1e-6 * static_cast<double>(micros); }
  Vec3 position() const {
    return kStep * Vec3(static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2]));
  }
  Vec3 direction() const;  // unit vector towards the shank
  // Returns true if the numbers, which may come from a file, form a valid pose.
  bool isSound() const;
  bool operator==(const DrillPose&) const = default;
};

class Fingerprint;
void addTo(Fingerprint& mark, const DrillPose& pose);

// The record of a drilled hole. Replaying it reproduces the hole, with thrust and torque.
struct DrillRecord {
  static constexpr std::size_t kMostPoses = 3'600'000;  // one hour at 1 kHz

  DrillSetup setup;
  PagedArray<DrillPose> poses;  // in chronological order
};

// Moves a drill to a stored pose.
inline DrillTick move(DrillRun& run, const DrillPose& pose) {
  return run.move(pose.position(), pose.direction(), pose.seconds());
}

}  // namespace handwheel

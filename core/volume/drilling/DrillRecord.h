// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/PagedArray.h"
#include "volume/drilling/DrillRun.h"

#include <array>
#include <cstdint>

namespace handwheel {

// A stored pose of a drill's head in a cycle. What is drilled by it is drilled again to the last bit.
struct DrillPose {
  static constexpr double kStep = 1e-6;  // mm; so fine that the steps of a slow hand are even at 1 kHz

  std::uint64_t micros = 0;          // since the hole was begun
  std::array<std::int64_t, 3> at{};  // of the centre, in kStep
  std::array<float, 3> axis{};       // to the shank

  // What cannot be kept, as a time before the hole or a place too far away, becomes the nearest that can.
  static DrillPose of(const Vec3& place, const Vec3& axis, double seconds);

  double seconds() const { return 1e-6 * static_cast<double>(micros); }
  Vec3 place() const {
    return kStep * Vec3(static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2]));
  }
  Vec3 direction() const;  // of length 1
  // Whether numbers that were read can be one.
  bool isSound() const;
  bool operator==(const DrillPose&) const = default;
};

class Fingerprint;
void addTo(Fingerprint& mark, const DrillPose& pose);

// How a hole was drilled: from it the same hole follows, with thrust and torque.
struct DrillRecord {
  static constexpr std::size_t kMostPoses = 3'600'000;  // an hour at 1 kHz

  DrillSetup setup;
  PagedArray<DrillPose> poses;  // in order of time
};

// Goes to a pose that is kept.
inline DrillTick move(DrillRun& run, const DrillPose& pose) {
  return run.move(pose.place(), pose.direction(), pose.seconds());
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <string>

#include "HapticPoses.h"
#include "haptics/recording/Recording.h"

// Random recordings for property tests, and comparisons of two recordings.
namespace handwheel::test {

inline RecordedTick anyTick(std::uint64_t number) {
  RecordedTick tick;
  tick.tick = number;
  tick.tip.position = anyVector(1e7);
  tick.tip.orientation = anyRotation();
  tick.tip.velocity = anyVector();
  tick.tip.gripper = anyNumber();
  tick.tip.time = anyNumber();
  tick.tip.period = anyNumber();
  tick.tip.stiffnessLimit = *rc::gen::element(std::numeric_limits<double>::infinity(), 0.3);
  tick.tip.dampingLimit = anyNumber();
  tick.tip.buttons = static_cast<std::uint32_t>(*rc::gen::inRange(0, 1 << 30));
  tick.tip.isRestart = *rc::gen::arbitrary<bool>();
  tick.felt.force = anyVector();
  tick.felt.torque = anyVector();
  tick.felt.gripper = anyNumber();
  tick.felt.proxy = anyVector();
  tick.felt.isContact = *rc::gen::arbitrary<bool>();
  tick.felt.isFresh = *rc::gen::arbitrary<bool>();
  tick.felt.isSoftened = *rc::gen::arbitrary<bool>();
  tick.felt.stiffness = anyNumber();
  tick.sent = {anyVector(), anyVector(), anyNumber()};
  tick.devicePosition = anyVector();
  tick.actions = static_cast<std::uint32_t>(*rc::gen::inRange(0, 1 << 9));
  tick.microseconds = 1.25f;
  tick.status = *rc::gen::element(DeviceStatus::Absent, DeviceStatus::Ready, DeviceStatus::Failed);
  tick.hasSource = *rc::gen::arbitrary<bool>();
  return tick;
}

inline Recording anyRecording() {
  Recording recording;
  const int ticks = *rc::gen::inRange(0, 6), events = *rc::gen::inRange(0, 3);
  for (int i = 0; i < ticks; ++i) recording.add(anyTick(static_cast<std::uint64_t>(2 * i + 3)));
  for (int i = 0; i < events; ++i) recording.addEvent({static_cast<std::uint64_t>(i), std::string(i * 5, 'x')});
  return recording;
}

inline bool isSame(const RecordedTick& a, const RecordedTick& b) {
  const auto felt = [](const ForceOut& x, const ForceOut& y) {
    return x.force == y.force && x.torque == y.torque && x.gripper == y.gripper && x.proxy == y.proxy &&
           x.isContact == y.isContact && x.isFresh == y.isFresh && x.isSoftened == y.isSoftened &&
           x.stiffness == y.stiffness;
  };
  const auto tip = [](const TipState& x, const TipState& y) {
    return x.position == y.position && x.orientation.coeffs() == y.orientation.coeffs() && x.velocity == y.velocity &&
           x.gripper == y.gripper && x.time == y.time && x.period == y.period && x.stiffnessLimit == y.stiffnessLimit &&
           x.dampingLimit == y.dampingLimit && x.buttons == y.buttons && x.isRestart == y.isRestart;
  };
  return a.tick == b.tick && tip(a.tip, b.tip) && felt(a.felt, b.felt) && a.sent.force == b.sent.force &&
         a.sent.torque == b.sent.torque && a.sent.gripper == b.sent.gripper && a.devicePosition == b.devicePosition &&
         a.actions == b.actions && a.microseconds == b.microseconds && a.status == b.status &&
         a.hasSource == b.hasSource;
}

inline bool isSame(const Recording& a, const Recording& b) {
  const auto isEvent = [](const RecordedEvent& x, const RecordedEvent& y) {
    return x.tick == y.tick && x.text == y.text;
  };
  bool same = a.size() == b.size() && a.missing() == b.missing() &&
              std::equal(a.events().begin(), a.events().end(), b.events().begin(), b.events().end(), isEvent);
  for (std::size_t i = 0; same && i < a.size(); ++i) same = isSame(a[i], b[i]);
  return same;
}

}  // namespace handwheel::test

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/SpscRing.h"
#include "base/TripleBuffer.h"
#include "haptics/servo/HapticScene.h"
#include "haptics/servo/ServoSample.h"
#include "haptics/servo/SnapshotSlot.h"

#include <atomic>

namespace handwheel {

// Lock-free data exchange between the servo thread and other threads. No thread waits.
struct ServoChannel {
  explicit ServoChannel(std::size_t capacity) : samples(capacity) {}

  SnapshotSlot<HapticScene> scenes;          // in
  TripleBuffer<NumberedMapping> mapping;     // in
  std::atomic<bool> isDiscontinuous{false};  // in: the next tick starts the ramp
  std::atomic<bool> isForceOn{true};         // in
  SpscRing<ServoSample> samples;             // out: every tick, to one thread
  TripleBuffer<ServoSample> latest;          // out: the last tick, to one thread
};

}  // namespace handwheel

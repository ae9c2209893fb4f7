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

// Lock-free data exchange between the servo thread and other threads. No thread ever waits.
struct ServoChannel {
  explicit ServoChannel(std::size_t capacity) : samples(capacity) {}

  SnapshotSlot<HapticScene> scenes;          // to the servo thread
  TripleBuffer<NumberedMapping> mapping;     // to the servo thread
  std::atomic<bool> isDiscontinuous{false};  // to the servo thread; true: the next tick starts the ramp
  std::atomic<bool> isForceOn{true};         // to the servo thread
  SpscRing<ServoSample> samples;             // from the servo thread: every tick, to one thread
  TripleBuffer<ServoSample> latest;          // from the servo thread: the last tick, to one thread
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <mutex>
#include <optional>
#include <string>

namespace handwheel {

// A simulated pen device for the stand-in of OpenHaptics. The pen is on an arm, and frames run on a servo thread like
// that of the manufacturer's library. There is one device per process, because there is one library. It may be used on
// any thread that holds its mutex.
struct HdStandIn {
  std::mutex mutex;
  // State of the device.
  bool isPlugged = true;
  bool needsInkwell = false;  // the position is unknown until the pen is put into the inkwell
  bool isInInkwell = false;
  int calibrationStyles = 0;         // calibration styles that it supports, as bits
  Vec3 position{10.0, -20.0, 30.0};  // mm, in its own frame, whose origin is not the middle of its space
  Vec3 least{-160.0, -70.0, -40.0}, most{160.0, 130.0, 100.0};
  int buttons = 0;
  bool saysNonsense = false;
  bool isStalled = false;  // the servo thread does not run
  // Record of events.
  unsigned askedStyle = 0;  // requested calibration style; 0: none yet
  std::string name;
  std::optional<Vec3> force;  // force of the last frame
  bool isForceOn = false;
  bool isRunning = false;
  int frames = 0;

  static HdStandIn& only();
  void reset();  // restores the initial state
};

}  // namespace handwheel

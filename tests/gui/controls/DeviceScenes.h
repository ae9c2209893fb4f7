// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/servo/ServoSample.h"
#include "haptics/servo/ServoStatistics.h"
#include "panels/device/DevicePanel.h"

#include <cmath>
#include <numbers>

// A device and its motion, for the tests of its panel.
namespace handwheel::test {

inline DeviceInfo falcon() {
  return {"falcon", "usb:1-2", "Novint Falcon"};
}

inline DeviceInfo spaceMouse() {
  return {"spacemouse", "/dev/hidraw3", "SpaceMouse Compact"};
}

// Returns a device with three measured and three driven axes. The device of the next function has six measured axes and
// none driven.
inline DeviceInUse falconView() {
  DeviceInUse view;
  view.found = {falcon(), spaceMouse()};
  view.chosen = falcon();
  view.capabilities.buttons = 4;
  view.capabilities.maxForce = 8.0;
  view.capabilities.maxStiffness = 3.0;
  view.capabilities.maxDamping = 0.02;
  view.capabilities.workspaceRadius = 40.0;
  view.capabilities.inherentDamping = 0.002;
  view.capabilities.latency = 0.001;
  view.status = DeviceStatus::Ready;
  view.isForceOn = true;
  return view;
}

inline DeviceInUse spaceMouseView() {
  DeviceInUse view;
  view.found = {falcon(), spaceMouse()};
  view.chosen = spaceMouse();
  view.capabilities.inputs = 6;
  view.capabilities.outputs = 0;
  view.capabilities.buttons = 26;
  view.capabilities.isRateControl = true;
  view.status = DeviceStatus::Ready;
  return view;
}

inline ServoSample sampleAt(double time, const Vec3& asked, const Vec3& sent) {
  ServoSample sample;
  sample.tip.time = time;
  sample.felt.force = asked;
  sample.sent.force = sent;
  sample.device.status = DeviceStatus::Ready;
  return sample;
}

// Shows samples of a hand that touches a wall repeatedly, for ten seconds at the rate of a display.
inline void playTouches(DevicePanel& panel) {
  for (int i = 0; i <= 600; ++i) {
    const double time = i / 60.0;
    const double depth = std::max(0.0, std::sin(std::numbers::pi * time) * 4.0);  // mm
    ServoSample sample = sampleAt(time, {0, 3.0 * depth, 0}, {0, std::min(8.0, 3.0 * depth), 0});
    sample.device.position = {12.5, -depth, -31.0};
    sample.device.orientation = Eigen::AngleAxisd(0.5, Vec3(0, 0, 1));
    sample.device.buttons = 0b101;
    if (3.0 * depth > 8.0) sample.actions.add(SafetyAction::Clamp);
    panel.showSample(sample);
  }
}

// Fills statistics with the timing of a loop of 1 kHz. Most ticks are nearly on time, some are late.
inline void fill(ServoStatistics& measure) {
  for (int i = 0; i < 1000; ++i) {
    const double late = 1e-6 * (20 + i % 37) + (i % 100 == 0 ? 4e-4 : 0.0);
    measure.addLateness(late);
    measure.addPeriod(1e-3 + late);
    measure.addDelay(1e-6 * (8 + i % 9));
  }
}

}  // namespace handwheel::test

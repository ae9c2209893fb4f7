// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety/ForceLimits.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

Vec3 shortened(const Vec3& v, double longest) {
  const double length = v.stableNorm();  // v may be as large as numbers go
  return length > longest ? Vec3(v * (longest / length)) : v;
}

Vec3 stepped(const Vec3& from, const Vec3& to, double step) {
  const Vec3 change = to - from;
  const double length = change.stableNorm();
  return length > step ? Vec3(from + change * (step / length)) : to;
}

}  // namespace

bool isFinite(const DeviceForce& force) {
  return force.force.allFinite() && force.torque.allFinite() && std::isfinite(force.gripper);
}

DeviceForce slewed(const DeviceForce& last, const DeviceForce& asked, double seconds, const SafetySettings& settings) {
  const double grip = settings.gripperSlewRate * seconds;
  return {stepped(last.force, asked.force, settings.slewRate * seconds),
          stepped(last.torque, asked.torque, settings.torqueSlewRate * seconds),
          std::clamp(asked.gripper, last.gripper - grip, last.gripper + grip)};
}

DeviceForce clamped(const DeviceForce& asked, const SafetySettings& settings) {
  return {shortened(asked.force, settings.maxForce), shortened(asked.torque, settings.maxTorque),
          std::clamp(asked.gripper, -settings.maxGripperForce, settings.maxGripperForce)};
}

}  // namespace handwheel

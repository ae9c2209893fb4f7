// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/ApproachSettings.h"

#include "tools/ToolProperty.h"

#include <QtGlobal>
#include <algorithm>

namespace handwheel {

namespace {

constexpr double kTurning = 150.0;      // N·mm/rad at the device
constexpr double kLargestPush = 0.5;    // rad: no torque of what is near draws the hand further aside
constexpr Limits kForces{0.1, 20.0};    // N
constexpr Limits kReaches{0.0, 100.0};  // mm

}  // namespace

DistanceForceSettings ApproachSettings::law(double tolerance) const {
  return {.reach = reach, .tolerance = tolerance, .stiffness = kHandStiffness, .largestForce = largestForce};
}

std::vector<Property> ApproachSettings::properties() const {
  return {switchSetting("felt", QT_TRANSLATE_NOOP("Property", "Force"), isFelt),
          numberSetting("force", QT_TRANSLATE_NOOP("Property", "Largest force (N)"), largestForce, Quantity::Number,
                        kForces),
          numberSetting("reach", QT_TRANSLATE_NOOP("Property", "Felt from"), reach, Quantity::Length, kReaches)};
}

void ApproachSettings::set(std::string_view id, const PropertyValue& value) {
  if (id == "felt") assignSwitch(isFelt, value);
  if (id == "force") assignNumber(largestForce, value, kForces);
  if (id == "reach") assignNumber(reach, value, kReaches);
}

DeviceSpring approachSpring(const Pose& hand, const Vec3& force, const std::optional<Vec3>& torque) {
  DeviceSpring spring{hand.translation() + force / kHandStiffness, kHandStiffness, kHandDamping};
  if (torque) {
    const Vec3 aside = *torque / kTurning;
    const double angle = std::min(aside.norm(), kLargestPush);
    spring.turn = Eigen::AngleAxisd(angle, aside.stableNormalized()) * Eigen::Quaterniond(hand.linear()).normalized();
    spring.turning = kTurning;
  }
  return spring;
}

Property clearanceProperty(double distance) {
  return shownLength("clearance", QT_TRANSLATE_NOOP("Property", "Clearance"), std::max(0.0, distance));
}

}  // namespace handwheel

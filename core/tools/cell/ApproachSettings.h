// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/DistanceForce.h"
#include "tools/Tool.h"

namespace handwheel {

// Settings of the force near an object that a hand holds.
struct ApproachSettings {
  bool isFelt = true;
  double largestForce = 4.0;  // N; the safety chain bounds it further
  double reach = 10.0;        // mm: distance below which there is a force

  // Returns the law of the force. tolerance: mm (setting proximity.tolerance).
  DistanceForceSettings law(double tolerance) const;
  // Returns the properties "felt", "force" and "reach".
  std::vector<Property> properties() const;
  void set(std::string_view id, const PropertyValue& value);
  bool operator==(const ApproachSettings&) const = default;
};

// Stiffness and damping of all springs between a hand and what it holds in a cell.
inline constexpr double kHandStiffness = 0.2;   // N/mm at the device
inline constexpr double kHandDamping = 0.0005;  // N·s/mm at the device

// Returns the spring that draws a device to a pose of its tip, and pushes it off by this force there, N. torque: N·mm;
// nothing: the device may turn freely.
DeviceSpring approachSpring(const Pose& hand, const Vec3& force, const std::optional<Vec3>& torque);

// Returns the read-only property "clearance": the distance to the nearest object, mm; 0 for objects that intersect.
Property clearanceProperty(double distance);

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/drilling/DrillSimulation.h"
#include "tools/ToolProperty.h"
#include "volume/drilling/DrillBits.h"

#include <string_view>
#include <vector>

namespace handwheel {

// The settings of drilling by hand, which are head, material, spindle and feed. The parameter voxel is the size of the
// voxels to be cut, mm, which limits the head; 0: the voxels are chosen for the head.
class DrillSettings {
 public:
  explicit DrillSettings(double voxel) { setHead(0, voxel); }
  // Makes the settings of an exercise. material: the id of a DrillMaterial; spindle: the speed, r/min; feed: the feed,
  // mm/s.
  DrillSettings(const DrillBit& head, std::string_view material, double spindle, double feed);

  const DrillBit& head() const { return m_head; }
  DrillSetup setup() const;
  // Returns the feed that the program controls, for a drill that points away from a surface along `out`, a unit vector.
  DrillFeed feedOutOf(const Vec3& out) const;

  std::vector<Property> properties(double voxel) const;
  // Changes a setting. Returns false if the id or the value is invalid.
  bool set(std::string_view id, const PropertyValue& value, double voxel);

  // Returns the outline of the head on a surface with this normal: the circle that it cuts, and its axis.
  std::vector<std::vector<Vec3>> outlineAt(const Vec3& position, const Vec3& normal) const;

 private:
  void setHead(std::size_t type, double voxel);

  DrillBit m_head = drillBits().front().tool;
  std::size_t m_material = 0;  // index in drillMaterials()
  double m_rpm = 1000.0;       // r/min
  double m_speed = 1.0;        // mm/s, speed of the feed
  double m_peck = 0.0;         // mm, peck as in DrillFeed
};

}  // namespace handwheel

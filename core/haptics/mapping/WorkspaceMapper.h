// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mapping/WorkspaceMapping.h"

#include <optional>

namespace handwheel {

// Maps device readings to the tip in the scene, tick by tick. It accumulates the offsets from the clutch, from changes
// of the mapping and from rate control. It is used on the servo thread, and does not allocate.
class WorkspaceMapper {
 public:
  // The tip in scene coordinates.
  struct Tip {
    Vec3 position = Vec3::Zero();  // mm
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
    Vec3 velocity = Vec3::Zero();   // mm/s
    bool isHeld = false;            // true: the clutch holds the tip
    bool hasDiscontinuity = false;  // true: first reading, or first one in a mapping that does not keep the tip
  };

  // Sets the mapping. proxy: the displayed position of the tip, mm. If the mapping keeps the tip, the proxy stays where
  // it is. The distance of the tip from the proxy also stays the same as measured at the device, so that it changes in
  // the scene if the scale changes.
  void setMapping(const WorkspaceMapping& mapping, const std::optional<Vec3>& proxy = {});
  const WorkspaceMapping& mapping() const { return m_mapping; }

  // Computes the tip from a reading with finite numbers. velocity: the velocity of the device, mm/s. period: the time
  // since the previous reading, s.
  Tip map(const DeviceState& device, const Vec3& velocity, double period);

 private:
  struct Placed {
    Vec3 position;
    Eigen::Quaterniond orientation;
  };
  Placed placed(const DeviceState& device) const;
  void anchor(const Placed& direct);
  void integrate(const DeviceState& device, double period);

  WorkspaceMapping m_mapping;
  Eigen::Matrix3d m_sceneFromDevice = Eigen::Matrix3d::Identity();  // rotation or reflection, without the scale
  double m_handedness = 1.0;                                        // -1 for a reflection
  // The tip's position is offset + mapped position. The tip's orientation is turn · mapped orientation.
  Vec3 m_offset = Vec3::Zero();
  Eigen::Quaterniond m_turn = Eigen::Quaterniond::Identity();
  Tip m_tip;
  bool m_hasTip = false;
  bool m_isAnchoring = false;  // true: the next reading sets the offset so that the tip stays
};

}  // namespace handwheel

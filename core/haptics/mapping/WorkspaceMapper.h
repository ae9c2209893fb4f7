// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mapping/WorkspaceMapping.h"

#include <optional>

namespace handwheel {

// Maps device readings to the tip in the scene, tick by tick. Accumulates the offsets from clutch, changes of the
// mapping and rate control. Servo thread; does not allocate.
class WorkspaceMapper {
 public:
  // The tip in scene coordinates.
  struct Tip {
    Vec3 position = Vec3::Zero();  // mm
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
    Vec3 velocity = Vec3::Zero();   // mm/s
    bool isHeld = false;            // the clutch holds it
    bool hasDiscontinuity = false;  // first reading, or another mapping that does not keep the tip
  };

  // proxy: the displayed position of the tip, mm. A mapping that keeps the tip keeps this position, and the tip's
  // distance from it as measured at the device: at another scale the same depth at the device is a different one in the
  // scene.
  void setMapping(const WorkspaceMapping& mapping, const std::optional<Vec3>& proxy = {});
  const WorkspaceMapping& mapping() const { return m_mapping; }

  // Computes the tip from a reading with finite numbers, `velocity` (mm/s, device) and the time since the previous
  // reading, s.
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
  // The tip's position is offset + mapped position, its orientation turn · mapped orientation.
  Vec3 m_offset = Vec3::Zero();
  Eigen::Quaterniond m_turn = Eigen::Quaterniond::Identity();
  Tip m_tip;
  bool m_hasTip = false;
  bool m_isAnchoring = false;  // the next reading sets the offset so that the tip stays
};

}  // namespace handwheel

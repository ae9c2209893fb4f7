// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/WorkspaceMapping.h"

#include <optional>

namespace handwheel {

// Carries the device into the scene tick by tick: remembers what clutch, changes of the mapping and rate control have
// added up to. Servo thread; allocates nothing.
class WorkspaceMapper {
 public:
  struct Tip {
    Vec3 position = Vec3::Zero();  // mm
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
    Vec3 velocity = Vec3::Zero();  // mm/s
    bool isHeld = false;           // by the clutch
    bool hasLeapt = false;         // first reading, or another mapping that does not keep the tip
  };

  // proxy: mm, what the device feels and shows its tip at. A mapping that keeps the tip keeps this place, and the tip
  // as far from it as the hand has pushed it: at another scale the same depth at the hand is another in the scene.
  void setMapping(const WorkspaceMapping& mapping, const std::optional<Vec3>& proxy = {});
  const WorkspaceMapping& mapping() const { return m_mapping; }

  // The tip for a reading with finite numbers, `velocity` (mm/s, device) and the s since the reading before.
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
  // The tip is offset + what the mapping says, and turn · what it says.
  Vec3 m_offset = Vec3::Zero();
  Eigen::Quaterniond m_turn = Eigen::Quaterniond::Identity();
  Tip m_tip;
  bool m_hasTip = false;
  bool m_isAnchoring = false;  // the next reading sets the offset so that the tip stays
};

}  // namespace handwheel

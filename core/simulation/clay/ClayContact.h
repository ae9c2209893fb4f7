// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

namespace handwheel {

// Settings of the contact between a clay tool and the clay. The mm of stiffness and resistance are mm in the scene, not
// at the device (WorkspaceMapping::scale).
struct ClayFeel {
  double stiffness = 0.5;    // N/mm, spring between hand and tool
  double resistance = 0.05;  // N·s/mm: force divided by the speed of a cutting tool through material
  bool isCutting = false;    // true: the tool goes through material in a gesture; false: it stays outside
  double spindle = 0.0;      // r/min, drill speed; while it cuts, the force oscillates with its turns
  double reach = 0.0;        // mm, distance from the tip to the foremost point, against the tool's axis
  bool isFree = false;       // true: nothing holds the tool in a gesture, for tools that add material

  bool operator==(const ClayFeel&) const = default;
};

// The load on a tool that removes material, as last computed by the simulation.
struct DrillingLoad {
  double resistance = 0.0;  // N·s/mm: thrust divided by the speed of the tool
  // unit vector of the tool's motion; motion against it meets no resistance. 0: nothing was removed
  Vec3 direction = Vec3::Zero();
  Vec3 torque = Vec3::Zero();  // mm: N·mm for each N of thrust
};

// The god-object of a point tool in clay (Zilles and Salisbury 1995). It stays outside of the material, at the
// reachable point nearest to the hand; while the tool cuts, it goes through the material slowly. Material that appears
// around the tool does not push it out; such material is felt only after the hand has been outside. Objects are used on
// the servo thread, take no lock and allocate no memory.
class ClayContact {
 public:
  void reset(const Vec3& hand);

  // Advances by one tick of dt seconds. Returns true if the tool touches the material. load: the load on the tool;
  // null: no simulation computes it. Material that the load does not include resists by ClayFeel::resistance.
  bool follow(const SparseVolume& volume, const ClayFeel& feel, const Vec3& hand, bool isWorking, double dt,
              const DrillingLoad* load = nullptr);

  const Vec3& tool() const { return m_tool; }  // mm

 private:
  static constexpr int kMostSteps = 64;  // steps through the volume in a tick

  bool slide(const SparseVolume& volume, const Vec3& hand);
  bool cut(double stiffness, double resistance, const Vec3& hand, double dt);

  Vec3 m_tool = Vec3::Zero();
  bool m_isBuried = false;  // true: material has appeared around the tool
};

}  // namespace handwheel

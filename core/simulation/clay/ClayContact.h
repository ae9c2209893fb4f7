// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

namespace handwheel {

// Settings of the contact between a clay tool and the clay. Stiffness and resistance are in units of the scene.
struct ClayFeel {
  double stiffness = 0.5;    // N/mm, of the spring between hand and tool
  double resistance = 0.05;  // N·s/mm: force divided by the speed of a cutting tool through material
  bool isCutting = false;    // goes through material in a gesture; false: stays outside
  double spindle = 0.0;      // r/min, of a drill: while it cuts, the force oscillates with its revolutions
  double reach = 0.0;        // mm, from the tip to the foremost point of the tool, against its axis
  bool isFree = false;       // nothing holds it in a gesture, for tools that add material

  bool operator==(const ClayFeel&) const = default;
};

// The load on a tool that removes material, as last computed by the simulation.
struct DrillingLoad {
  double resistance = 0.0;  // N·s/mm: thrust divided by the speed of the tool
  // unit vector of the tool's motion; motion against it meets no resistance. 0: nothing was removed
  Vec3 direction = Vec3::Zero();
  Vec3 torque = Vec3::Zero();  // mm: N·mm for each N of thrust
};

// The god-object of a point tool in clay (Zilles and Salisbury 1995). On a field of depths it stays outside of the
// material, at the reachable point nearest to the hand, or goes through it slowly while it cuts. Material that appears
// around it does not push it out: it is felt when the hand has been outside. Servo thread: no lock, no memory
// allocation.
class ClayContact {
 public:
  void reset(const Vec3& hand);

  // Advances by one tick of dt seconds. Returns true if the tool touches. load: null if no simulation computes it.
  // Material that the load does not include has the resistance of the feel.
  bool follow(const SparseVolume& volume, const ClayFeel& feel, const Vec3& hand, bool isWorking, double dt,
              const DrillingLoad* load = nullptr);

  const Vec3& tool() const { return m_tool; }  // mm

 private:
  static constexpr int kMostSteps = 64;  // steps through the field in a tick

  bool slide(const SparseVolume& volume, const Vec3& hand);
  bool cut(double stiffness, double resistance, const Vec3& hand, double dt);

  Vec3 m_tool = Vec3::Zero();
  bool m_isBuried = false;  // material has appeared around it
};

}  // namespace handwheel

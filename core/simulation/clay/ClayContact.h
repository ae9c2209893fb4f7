// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

namespace handwheel {

// How a clay tool meets the clay. Stiffness and resistance are those in the scene.
struct ClayFeel {
  double stiffness = 0.5;    // N/mm, of the spring between hand and tool
  double resistance = 0.05;  // N·s/mm: force by the speed at which a tool that cuts goes through material
  bool isCutting = false;    // goes through material in a gesture; else it stays outside
  double spindle = 0.0;      // r/min, of a drill: while it cuts, the force swings with its turns
  double reach = 0.0;        // mm, from the tip to the foremost point of the tool, against its axis
  bool isFree = false;       // nothing holds it in a gesture, as material comes where it is

  bool operator==(const ClayFeel&) const = default;
};

// What a tool meets that a simulation removes material with, as the simulation has computed it last.
struct DrillingLoad {
  double resistance = 0.0;     // N·s/mm: thrust by the speed of the tool
  Vec3 way = Vec3::Zero();     // of length 1: where the tool went; it resists no way back. 0: it took nothing
  Vec3 torque = Vec3::Zero();  // mm: N·mm to each N of thrust
};

// The god-object of a point tool in clay (Zilles and Salisbury 1995). On a field of depths it stays outside of the
// material, at the place nearest to the hand that it can get to, or goes through it slowly while it cuts. Material that
// appears around it does not push it out: it is felt when the hand has been outside. Servo thread: no lock, no memory.
class ClayContact {
 public:
  void place(const Vec3& hand);

  // One tick of dt seconds. Returns whether it touches. load: null where no simulation tells it. Material that it does
  // not know of has the resistance of the feel.
  bool follow(const SparseVolume& volume, const ClayFeel& feel, const Vec3& hand, bool isWorking, double dt,
              const DrillingLoad* load = nullptr);

  const Vec3& tool() const { return m_tool; }  // mm

 private:
  static constexpr int kMostSteps = 64;  // through the field, in a tick

  bool slide(const SparseVolume& volume, const Vec3& hand);
  bool cut(double stiffness, double resistance, const Vec3& hand, double dt);

  Vec3 m_tool = Vec3::Zero();
  bool m_isBuried = false;  // material has come around it
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/drilling/DrillCut.h"
#include "volume/drilling/DrillForce.h"

#include <functional>
#include <optional>

namespace handwheel {

class HybridPart;

// How a volume is drilled.
struct DrillSetup {
  DrillBit tool;
  DrillMaterial material = drillMaterials().front();
  double spindle = 2.0 * 3.14159265358979323846 * 1000.0 / 60.0;  // rad/s
  double erosion = std::numeric_limits<double>::infinity();       // as in DrillMove
};

// A cycle of a drill.
struct DrillTick {
  double time = 0.0;           // s
  Vec3 place = Vec3::Zero();   // mm, of the head's centre
  Vec3 force = Vec3::Zero();   // N, on the head
  Vec3 torque = Vec3::Zero();  // N·mm, on it
  double thrust = 0.0;         // N, the length of force
  double removed = 0.0;        // mm³, in this cycle
  // From the centre to the foremost point, of length 1: against the axis; of a saw where it went when it took something
  // first.
  Vec3 ahead = -Vec3::UnitZ();
};

// A simulation of drilling, cycle by cycle. The servo loop or a recording gives one place of the head after the other.
class DrillRun {
 public:
  // The volume must outlive it.
  DrillRun(SparseVolume& volume, const DrillSetup& setup);
  // Voxels of the part are made where the head goes. It must outlive the run, too.
  DrillRun(HybridPart& part, const DrillSetup& setup);

  // Goes to a place, with its axis to the shank, at a time, s. The first call only places it. Long ways are gone in
  // parts.
  DrillTick move(const Vec3& place, const Vec3& axis, double time);

  // Blocks that have changed since they were taken last.
  std::vector<VoxelIndex> takeChangedBlocks();

  double removed() const { return m_removed; }      // mm³
  double energy() const { return m_energy; }        // J: ∫(−F·v − T·ω)dt of what was returned
  double maxThrust() const { return m_maxThrust; }  // N
  double maxTorque() const { return m_maxTorque; }  // N·mm
  // s, when the tip came out on the other side of the material that was there before; none: it did not.
  std::optional<double> breakthrough() const { return m_breakthrough; }

 private:
  DrillCut cut(const DrillMove& move);
  double depthBefore(const Vec3& place) const;
  Vec3 aheadOf(const Vec3& axis, const Vec3& way, bool isCutting);
  void watchTip(const Vec3& ahead, double way, double time);

  SparseVolume& m_volume;
  HybridPart* m_part = nullptr;  // whose volume it is; null: the volume is all there
  const SparseVolume m_before;   // of such a volume
  DrillSetup m_setup;
  std::optional<Vec3> m_place;
  double m_time = 0.0;
  std::optional<Vec3> m_ahead;  // of a saw that has cut
  bool m_isTipInside = false;
  std::vector<VoxelIndex> m_changed;
  double m_removed = 0.0, m_energy = 0.0, m_maxThrust = 0.0, m_maxTorque = 0.0;
  std::optional<double> m_breakthrough;
};

}  // namespace handwheel

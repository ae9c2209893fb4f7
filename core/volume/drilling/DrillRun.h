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

// The parameters of drilling.
struct DrillSetup {
  DrillBit tool;
  DrillMaterial material = drillMaterials().front();
  double spindle = 2.0 * 3.14159265358979323846 * 1000.0 / 60.0;  // rad/s
  double erosion = std::numeric_limits<double>::infinity();       // see DrillMove
};

// A cycle of a drill.
struct DrillTick {
  double time = 0.0;             // s
  Vec3 position = Vec3::Zero();  // mm, position of the head's centre
  Vec3 force = Vec3::Zero();     // N, force on the head
  Vec3 torque = Vec3::Zero();    // N·mm, torque on the head
  double thrust = 0.0;           // N, the length of `force`
  double removed = 0.0;          // mm³, removed in this cycle
  // Unit vector from the centre to the foremost point. It is opposite to the axis, or for a saw the direction of its
  // first cut.
  Vec3 ahead = -Vec3::UnitZ();
};

// A simulation of drilling, cycle by cycle. A servo loop or a recording provides the successive poses of the head.
class DrillRun {
 public:
  // Drills in a volume, which must outlive the run.
  DrillRun(SparseVolume& volume, const DrillSetup& setup);
  // Drills in a part, and makes its voxels along the path of the head. The part must outlive the run.
  DrillRun(HybridPart& part, const DrillSetup& setup);

  // Moves the head's centre to a position. axis: unit vector towards the shank; time: s. The first call only sets the
  // initial position. Long moves are divided.
  DrillTick move(const Vec3& position, const Vec3& axis, double time);

  // Returns the blocks that have changed since the last call.
  std::vector<VoxelIndex> takeChangedBlocks();

  double removed() const { return m_removed; }      // mm³
  double energy() const { return m_energy; }        // J: ∫(−F·v − T·ω)dt over the returned ticks
  double maxThrust() const { return m_maxThrust; }  // N
  double maxTorque() const { return m_maxTorque; }  // N·mm
  // Returns the time when the tip emerged on the other side of the original material, s, or nothing if it did not.
  std::optional<double> breakthrough() const { return m_breakthrough; }

 private:
  DrillCut cut(const DrillMove& move);
  double depthBefore(const Vec3& position) const;
  Vec3 aheadOf(const Vec3& axis, const Vec3& displacement, bool isCutting);
  void watchTip(const Vec3& ahead, double travel, double time);

  SparseVolume& m_volume;
  HybridPart* m_part = nullptr;  // owner of the volume; null: the volume has all of its voxels
  const SparseVolume m_before;   // original of a volume that has all of its voxels
  DrillSetup m_setup;
  std::optional<Vec3> m_position;
  double m_time = 0.0;
  std::optional<Vec3> m_ahead;  // direction of a saw; none: it has not cut yet
  bool m_isTipInside = false;
  std::vector<VoxelIndex> m_changed;
  double m_removed = 0.0, m_energy = 0.0, m_maxThrust = 0.0, m_maxTorque = 0.0;
  std::optional<double> m_breakthrough;
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/clay/ClaySimulation.h"
#include "volume/HybridPart.h"
#include "volume/drilling/DrillMonitor.h"
#include "volume/drilling/DrillRecord.h"

namespace handwheel {

// A volume that is being drilled, at one moment.
struct DrillState : ClayState {
  double thrust = 0.0, torque = 0.0;   // N, N·mm: largest since the state before
  double removed = 0.0;                // mm³
  double energy = 0.0;                 // J
  double time = 0.0;                   // s, since the hole was begun
  std::optional<double> breakthrough;  // s, since then
  std::optional<DrillPlan> plan;       // that it is judged by; none yet
  DrillStatistics figures;             // by the plan
  PagedArray<DrillMoment> moments;     // of the hole
  PagedArray<DrillPose> poses;         // that it can be drilled by again
  // Of a part of triangles: where its surface is that of the voxels, as it may have been cut. The triangles have it
  // elsewhere. Cubes of HybridPart::kTile voxels from the origin of the volume, which are pieces of the surface.
  std::vector<VolumeSurface::Key> tiles;
  bool isExact = true;  // of such a part: HybridPart::isExact()
};

// The cells of one of the tiles of a state, mm.
Box boxOfTile(const DrillState& state, const VolumeSurface::Key& tile);

// Whether the drill takes something beside its planned path at this moment.
bool isBesidePath(const DrillState& state);

// A drill that is fed by the program, as a person without a device does: from where it is pressed along a direction.
struct DrillFeed {
  static constexpr double kLeastPeck = 0.1;  // mm

  Vec3 axis = Vec3::UnitZ();  // to the shank, of length 1
  double speed = 1.0;         // mm/s
  double peck = 0.0;          // mm, after each of which it goes out to its start and back, as in G83; less: never
  Vec3 way = -Vec3::UnitZ();  // where it goes, of length 1; of a saw not against the axis
};

// The simulation of drilling: the volume loses what the head passes in a gesture. What that takes is passed to the
// servo loop, whose hand is held back by it. A part of triangles has voxels only near the head, and near the tip of a
// device, which feels them.
class DrillSimulation : public Simulation {
 public:
  // feed: none for a device, whose tip is the centre of the head and whose stylus is the shank. plan: none: straight on
  // from where the hole is begun.
  DrillSimulation(const std::shared_ptr<const ClayState>& begin, const DrillSetup& setup, std::optional<DrillFeed> feed,
                  std::shared_ptr<ClayChannel> channel, std::optional<DrillPlan> plan = {});
  // The same of a part of triangles of which nothing was cut.
  DrillSimulation(HybridPart part, const DrillSetup& setup, std::optional<DrillFeed> feed,
                  std::shared_ptr<ClayChannel> channel);

  void step(double dt, std::span<const SimulationInput> inputs) override;
  // Holds the feed where it is, the spindle turning, or lets it go on. A device feeds by itself.
  void holdFeed(bool isHeld) { m_isHeld = isHeld; }
  std::shared_ptr<const SimulationState> state() const override { return m_state; }
  // As it was cut; null where it began with a volume.
  const HybridPart* part() const { return m_part ? &*m_part : nullptr; }

 private:
  // A way of the head: what counts for the force of a hand.
  struct Passage {
    Vec3 way = Vec3::Zero();  // mm
    double length = 0.0;      // mm
    double seconds = 0.0;
    double removed = 0.0;  // mm³
  };

  // Of a feed by pecks.
  enum class Phase { Feeding, Retracting, Returning };

  void feedFor(double dt);
  double targetOfPhase() const;
  void goTo(const Vec3& place, const Vec3& axis);
  void watchLoad(const DrillTick& tick, const Vec3& axis);
  void holdNear(const SimulationInput& hand);
  void showTiles(DrillState& state, std::span<const VoxelIndex> changed);
  void publish();

  std::shared_ptr<const DrillState> m_state;
  SparseVolume m_volume;             // none of a part
  std::optional<HybridPart> m_part;  // none of a volume
  DrillSetup m_setup;
  DrillRun m_run;
  std::optional<DrillPlan> m_plan;
  std::optional<DrillMonitor> m_watch;  // since the first place of the hole
  PagedArray<DrillMoment> m_moments;
  PagedArray<DrillPose> m_poses;
  std::optional<DrillFeed> m_feed;
  std::shared_ptr<ClayChannel> m_channel;
  std::optional<Vec3> m_start;  // of the fed drill, which is
  double m_depth = 0.0;         // mm, from there,
  double m_pecked = 0.0;        // mm, and was so deep at the end of the last peck
  Phase m_phase = Phase::Feeding;
  bool m_isHeld = false;               // the feed
  std::optional<double> m_begin;       // s, by the clock of the inputs
  double m_time = 0.0;                 // s, since then
  DrillLoad m_load;                    // largest since the state before
  bool m_hasTicks = false;             // since then
  bool m_isWritten = false;            // the present state is in the channel
  std::optional<DrillTick> m_before;   // the last cycle
  Passage m_passage;                   // since the load was computed
  std::optional<DrillingLoad> m_felt;  // none: not yet
  std::set<std::array<int, 3>> m_changed;
  std::set<VolumeSurface::Key> m_tiles;  // of the state
};

}  // namespace handwheel

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
  double thrust = 0.0, torque = 0.0;   // N, N·mm: largest values since the previous state
  double removed = 0.0;                // mm³
  double energy = 0.0;                 // J
  double time = 0.0;                   // s, since the hole was begun
  std::optional<double> breakthrough;  // s, since the hole was begun
  std::optional<DrillPlan> plan;       // the plan that the hole is judged by; none: there is none yet
  DrillStatistics figures;             // the moments compared with the plan
  PagedArray<DrillMoment> moments;     // moments of the hole
  PagedArray<DrillPose> poses;         // poses from which the hole can be drilled again
  // For a part of triangles: the tiles in which the surface is made from the voxels, since they may have been cut.
  // Elsewhere the surface is that of the triangles. A tile is a cube with HybridPart::kTile voxels along an edge,
  // counted from the origin of the volume; each is one piece of `surface`.
  std::vector<VolumeSurface::Key> tiles;
  bool isExact = true;  // for a part of triangles: HybridPart::isExact()
};

// Returns the bounds of the cells of a tile of a state, mm.
Box boxOfTile(const DrillState& state, const VolumeSurface::Key& tile);

// Returns true if the drill removes material beside its planned path at this moment.
bool isBesidePath(const DrillState& state);

// The feed of a drill that the simulation moves, for a person without a device. The drill moves along a direction from
// the position at which the button was pressed.
struct DrillFeed {
  static constexpr double kLeastPeck = 0.1;  // mm

  Vec3 axis = Vec3::UnitZ();  // unit vector towards the shank
  double speed = 1.0;         // mm/s
  // mm: the feed after which the drill is withdrawn to its start and returns, as in G83; below kLeastPeck: never
  double peck = 0.0;
  Vec3 direction = -Vec3::UnitZ();  // unit vector of the feed; by default against the axis, unlike the feed of a saw
};

// The simulation of drilling: in a gesture the head removes the material that it passes. The resulting load is passed
// to the servo loop, where it holds the hand back. A part of triangles has voxels only near the head and near the tip
// of a device, whose force is computed from them.
class DrillSimulation : public Simulation {
 public:
  // feed: none for a device, whose tip is the centre of the head and whose stylus is the shank. plan: the plan of the
  // hole; without one, the hole should go straight on from its start.
  DrillSimulation(const std::shared_ptr<const ClayState>& begin, const DrillSetup& setup, std::optional<DrillFeed> feed,
                  std::shared_ptr<ClayChannel> channel, std::optional<DrillPlan> plan = {});
  // Makes the simulation of an uncut part of triangles.
  DrillSimulation(HybridPart part, const DrillSetup& setup, std::optional<DrillFeed> feed,
                  std::shared_ptr<ClayChannel> channel);

  void step(double dt, std::span<const SimulationInput> inputs) override;
  // Stops the feed while the spindle goes on turning, or continues the feed. It has no effect on a drill that a device
  // moves.
  void holdFeed(bool isHeld) { m_isHeld = isHeld; }
  std::shared_ptr<const SimulationState> state() const override { return m_state; }
  // Returns the part as cut so far; null if the simulation began with a volume.
  const HybridPart* part() const { return m_part ? &*m_part : nullptr; }

 private:
  // A stretch of the head's path, from which the force on the hand is computed.
  struct Passage {
    Vec3 displacement = Vec3::Zero();  // mm
    double length = 0.0;               // mm
    double seconds = 0.0;
    double removed = 0.0;  // mm³
  };

  // Phases of a feed by pecks.
  enum class Phase { Feeding, Retracting, Returning };

  void feedFor(double dt);
  double targetOfPhase() const;
  void goTo(const Vec3& position, const Vec3& axis);
  void watchLoad(const DrillTick& tick, const Vec3& axis);
  void holdNear(const SimulationInput& hand);
  void showTiles(DrillState& state, std::span<const VoxelIndex> changed);
  void publish();

  std::shared_ptr<const DrillState> m_state;
  SparseVolume m_volume;             // empty for a part
  std::optional<HybridPart> m_part;  // none for a volume
  DrillSetup m_setup;
  DrillRun m_run;
  std::optional<DrillPlan> m_plan;
  std::optional<DrillMonitor> m_watch;  // comparison of the hole with its plan, since its first position
  PagedArray<DrillMoment> m_moments;
  PagedArray<DrillPose> m_poses;
  std::optional<DrillFeed> m_feed;
  std::shared_ptr<ClayChannel> m_channel;
  std::optional<Vec3> m_start;  // start of the fed drill
  double m_depth = 0.0;         // mm, depth of the fed drill below m_start
  double m_pecked = 0.0;        // mm, depth at the end of the last peck
  Phase m_phase = Phase::Feeding;
  bool m_isHeld = false;               // the feed is stopped
  std::optional<double> m_begin;       // s: time when the hole was begun, by the clock of the inputs
  double m_time = 0.0;                 // s, since m_begin
  DrillLoad m_load;                    // largest values since the previous state
  bool m_hasTicks = false;             // the drill has moved since the previous state
  bool m_isWritten = false;            // the present state is in the channel
  std::optional<DrillTick> m_before;   // the previous tick
  Passage m_passage;                   // passage of the head since the load was last computed
  std::optional<DrillingLoad> m_felt;  // load on the hand; none: not computed yet
  std::set<std::array<int, 3>> m_changed;
  std::set<VolumeSurface::Key> m_tiles;  // tiles of the state
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/RobotModel.h"
#include "robot/program/RobotProgram.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

namespace handwheel {

// The target that a place of a path was planned to.
struct PlaceTarget {
  std::string name;
  // Where it was then for the tool at that place: not the identity where the arm cannot turn the tool as the target is.
  Pose inTool = Pose::Identity();

  bool operator==(const PlaceTarget& other) const;
};

// A waypoint: a place of a path, and the motion that ends there.
struct Waypoint {
  JointValues joints;  // of the whole cell; those of other robots tell where these stood; rad, mm
  std::string name = {};
  bool isCritical = true;  // set by a person: planning again passes through it
  ProgramMotion::Kind motion = ProgramMotion::Kind::Joint;
  double speed = 0.25;  // as in ProgramMotion
  double blend = 0.0;   // mm
  // The ends between which the planner made the joint motions to this place: those of the critical place before and its
  // own. As long as they are the same, planning again may keep these motions. Null: it did not. Not compared.
  std::shared_ptr<const std::array<JointValues, 2>> plannedBetween = {};
  std::optional<PlaceTarget> target = {};  // none: it was given as joint values, or set by hand since
  // The name of the configuration that it was given as; empty: it was given otherwise, or set by hand since.
  std::string configuration = {};

  // Whether the planner made the motions that lead from this critical place to it.
  bool isPlannedFrom(const Waypoint& begin) const;
  bool operator==(const Waypoint& other) const;  // also of cells with other robots
};

// How a path along a curve on a part was chosen, so that it can be planned again.
struct PathProcess {
  using Value = std::variant<double, bool, std::string>;

  std::map<std::string, Value> values;  // of the operation "process", by its parameters; those that are not standard
  Pose part = Pose::Identity();         // of the part, in the frame of the base, when they were chosen,
  Pose planned = part;                  // and when the path was planned last
  std::optional<Pose> tool = {};        // the tool's centre point then, as CellPlans::tool; none: it is not known
  std::optional<Pose> base = {};        // of the robot then, in the frame of the root; none: where it is now

  bool operator==(const PathProcess& other) const;
};

// A path of a robot: its first place is where it starts.
struct RobotPath {
  static constexpr std::size_t kMostPlaces = 100'000;
  static constexpr double kLargestClearance = 1e4;  // mm

  std::string name;
  std::vector<Waypoint> places;
  std::string arm = {};                     // whose path it is, as CellPlans::arm
  std::optional<PathProcess> process = {};  // none: it was planned between places, or by hand
  // By the names of other robots whose bases were moved since: where these stood, in the frame of the root.
  std::map<std::string, Pose, std::less<>> bases = {};
  std::optional<double> clearance = {};  // mm that it keeps; none: that of the cell

  bool operator==(const RobotPath& other) const;
};

// Joint values under a name.
struct NamedConfiguration {
  std::string name;
  JointValues joints;    // of the whole cell; rad, mm
  std::string arm = {};  // whose joints it sets, as CellPlans::arm

  bool operator==(const NamedConfiguration& other) const;
};

// A place that targets belong to and programs are written in: a work object, or a user frame, of a controller.
struct NamedFrame {
  std::string name;
  Pose pose = Pose::Identity();  // in the frame of the root, of the body, or of the link; rigid
  std::uint32_t body = 0;        // the number of the body that carries it; 0: none does
  std::string link = {};         // the name of the link that carries it; empty: none does. Only without a body

  bool operator==(const NamedFrame& other) const;
};

// A pose that the tool's centre point can be brought to.
struct NamedTarget {
  std::string name;
  Pose pose = Pose::Identity();  // in the frame of the root, of the body, or in the named frame; rigid
  std::uint32_t body = 0;        // the number of the body that it is on and moves with; 0: on none
  std::string frame = {};        // the name of the frame that it belongs to; empty: to none. Only without a body

  bool operator==(const NamedTarget& other) const;
};

// Gives each thing a name that no other has: the preferred one, or that with the least number from 2 on that
// makes it another one. Counts on from the last number, so that n names take O(n).
class FreeNames {
 public:
  void add(const std::string& taken) { m_taken.insert(taken); }
  std::string take(const std::string& preferred);

 private:
  std::unordered_set<std::string> m_taken;
  std::unordered_map<std::string, std::size_t> m_numbers;  // the last that was given
};

// What is planned in a robot cell. Names are unique among configurations and targets
// together, among paths, and among frames, and not empty.
struct CellPlans {
  static constexpr std::size_t kMost = 10'000;  // configurations; targets; paths
  static constexpr std::size_t kMostFrames = 100;

  std::vector<NamedConfiguration> configurations;
  std::vector<NamedTarget> targets;
  std::vector<RobotPath> paths;
  std::vector<NamedFrame> frames;
  // The name of the frame that programs are written in, and coordinates of targets shown in. Empty: programs in the
  // base of the robot, each target in what it is on.
  std::string workFrame = {};
  // Names of links, or a link and a body ("body.3"), whose collisions do not count.
  std::set<std::pair<std::string, std::string>> allowed;
  std::string arm = {};          // the name of the robot that is planned for; empty: the first
  Pose tool = Pose::Identity();  // the centre point of its tool in the link that carries the tool
  // Those of the other robots, by their names; the link itself for those that are not in it.
  std::map<std::string, Pose, std::less<>> otherTools = {};
  double clearance = 0.0;  // mm that paths keep from everything, if they have none of their own

  const NamedConfiguration* configuration(std::string_view name) const;  // null: there is none
  const NamedTarget* target(std::string_view name) const;                // null: there is none
  const RobotPath* path(std::string_view name) const;                    // null: there is none
  const NamedFrame* frame(std::string_view name) const;                  // null: there is none
  // Names that are free. O(names); who wants several keeps it.
  FreeNames pathNames() const;
  FreeNames placeNames() const;  // neither of a configuration nor of a target
  FreeNames frameNames() const;
  std::string freePathName(const std::string& preferred) const { return pathNames().take(preferred); }
  std::string freePlaceName(const std::string& preferred) const { return placeNames().take(preferred); }
  std::size_t bytes() const;                                                                      // about
  double clearanceOf(const RobotPath& path) const { return path.clearance.value_or(clearance); }  // mm
  // What a path has to have of its own to keep this, mm.
  std::optional<double> ownClearance(double kept) const {
    return kept == clearance ? std::nullopt : std::optional(kept);
  }
  // Plans for another robot from now on. present: the name of the one that is planned for, which keeps its tool.
  void choose(const std::string& other, const std::string& present);

  bool operator==(const CellPlans& other) const;
};

}  // namespace handwheel

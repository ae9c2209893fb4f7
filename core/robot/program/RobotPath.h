// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/RobotModel.h"
#include "robot/program/AssumedRates.h"
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

// The target of a planned waypoint, or the frame in which a program gave it.
struct WaypointTarget {
  std::string name;
  // The pose of the target, or frame, when the waypoint was planned, relative to the tool at the waypoint. It is not
  // the identity if the arm could not reach the orientation of the target.
  Pose inTool = Pose::Identity();

  bool operator==(const WaypointTarget& other) const;
};

// A waypoint of a path, and the motion that ends there.
struct Waypoint {
  JointValues joints;  // values of the whole cell, including those of other robots when it was made; rad, mm
  std::string name = {};
  bool isCritical = true;  // set by a person: replanning passes through it
  ProgramMotion::Kind motion = ProgramMotion::Kind::Joint;
  double speed = 0.25;  // see ProgramMotion
  double blend = 0.0;   // mm
  // The ends of the leg for which the planner made the joint motions to this waypoint: the critical waypoints before
  // and after. While they are unchanged, replanning may keep these motions. Null: not planned. Comparisons ignore it.
  std::shared_ptr<const std::array<JointValues, 2>> plannedBetween = {};
  std::optional<WaypointTarget> target = {};  // none: it was given as joint values, or edited by hand since
  // The name of the configuration that it was created from; empty: none, or edited by hand since.
  std::string configuration = {};
  double corner = 0.0;                  // see ProgramMotion
  double seconds = 0.0;                 // s, see ProgramMotion
  std::vector<ProgramLine> lines = {};  // lines of a program that follow the motion, in RobotPath::language
  // True if a person has said that the robot carries after the lines what it carried before.
  bool keepsCarried = false;
  // The frame of the cell in which the program gave the waypoint; none: in no frame, or edited by hand since.
  std::optional<WaypointTarget> frame = {};

  // Returns the first line by which the robot may grip or release something that nobody knows; null: there is none.
  const ProgramLine* gripping() const;
  // Returns true if the planner made the motions that lead from the critical waypoint `begin` to this one.
  bool isPlannedFrom(const Waypoint& begin) const;
  // Waypoints of cells with different robots may be compared, too.
  bool operator==(const Waypoint& other) const;
};

// The inputs of a path along a curve on a part, for replanning.
struct PathProcess {
  using Value = std::variant<double, bool, std::string>;

  // Parameters of the operation "process" that do not have their default values, by name.
  std::map<std::string, Value> values;
  Pose part = Pose::Identity();  // pose of the part when the values were chosen, in the frame of the base
  Pose planned = part;           // pose of the part when the path was last planned
  // The tool's centre point when the path was last planned, as in CellPlans::tool; none: unknown.
  std::optional<Pose> tool = {};
  // Base of the robot when the path was last planned, in the frame of the root; none: it has not moved since.
  std::optional<Pose> base = {};

  bool operator==(const PathProcess& other) const;
};

// A path of a robot, which starts at its first waypoint.
struct RobotPath {
  static constexpr std::size_t kMostWaypoints = 100'000;
  static constexpr double kLargestClearance = 1e4;  // mm

  std::string name;
  std::vector<Waypoint> waypoints;
  std::string arm = {};                     // name of its robot, as in CellPlans::arm
  std::optional<PathProcess> process = {};  // none: it was planned between waypoints, or by hand
  // For robots that were moved since the path was planned: the former poses of their bases in the frame of the root, by
  // the names of the robots.
  std::map<std::string, Pose, std::less<>> bases = {};
  std::optional<double> clearance = {};  // mm; none: that of the cell
  // Lines of the program that the path was read from, before its first motion, and the language of these and of the
  // lines of waypoints (PostProcessor::id()); empty: there are none.
  std::vector<ProgramLine> head = {};
  std::string language = {};

  bool operator==(const RobotPath& other) const;
};

// Removes a waypoint. Its lines of a program then follow the waypoint before it, or stand before the first motion.
void removeWaypoint(RobotPath& path, std::size_t index);

// Named joint values.
struct NamedConfiguration {
  std::string name;
  JointValues joints;    // values of the whole cell; rad, mm
  std::string arm = {};  // name of the robot whose joints it sets, as in CellPlans::arm

  bool operator==(const NamedConfiguration& other) const;
};

// A frame of targets and programs: a work object, or a user frame, of a controller.
struct NamedFrame {
  std::string name;
  Pose pose = Pose::Identity();  // in the frame of the root, of the body, or of the link; rigid
  std::uint32_t body = 0;        // id of the body that carries it; 0: none does
  // The name of the link that carries it; empty: none does. It is empty if a body carries it.
  std::string link = {};

  bool operator==(const NamedFrame& other) const;
};

// A pose that the tool's centre point can be brought to.
struct NamedTarget {
  std::string name;
  Pose pose = Pose::Identity();  // in the frame of the root, of the body, or in the named frame; rigid
  std::uint32_t body = 0;        // id of the body that it is on and moves with; 0: none
  // The name of the frame that it belongs to; empty: none. It is empty if it is on a body.
  std::string frame = {};

  bool operator==(const NamedTarget& other) const;
};

// Generates unique names. A name is the preferred one, or the preferred one with the least number from 2 on that makes
// it unique. The search continues from the last number, so that n names take O(n).
class FreeNames {
 public:
  void add(const std::string& taken) { m_taken.insert(taken); }
  std::string take(const std::string& preferred);

 private:
  std::unordered_set<std::string> m_taken;
  std::unordered_map<std::string, std::size_t> m_numbers;  // the last number for each name
};

// The plans of a robot cell. Names are unique among configurations and targets together, among paths, and among frames,
// and not empty.
struct CellPlans {
  static constexpr std::size_t kMost = 10'000;  // limit for each of configurations, targets and paths
  static constexpr std::size_t kMostFrames = 100;

  std::vector<NamedConfiguration> configurations;
  std::vector<NamedTarget> targets;
  std::vector<RobotPath> paths;
  std::vector<NamedFrame> frames;
  // The name of the frame in which programs are written and coordinates of targets are displayed. If it is empty,
  // programs are in the base of the robot, and each target is displayed in its own frame.
  std::string workFrame = {};
  // Pairs of links, or of a link and a body ("body.3"), between which collisions are ignored.
  std::set<std::pair<std::string, std::string>> allowed;
  // Links and bodies ("body.3") whose shapes could not be read, and the body that replaces them: a body that the link
  // carries, or "", if the user left the shapes out of the proofs.
  std::map<std::string, std::string> missingAs = {};
  std::string arm = {};          // the name of the robot that is planned for; empty: the first
  Pose tool = Pose::Identity();  // the centre point of its tool in the link that carries the tool
  // Centre points of the tools of the other robots, by the names of the robots; the origin of the link for missing
  // ones.
  std::map<std::string, Pose, std::less<>> otherTools = {};
  double clearance = 0.0;  // mm: clearance of paths that have none of their own
  AssumedRates rates = {};

  const NamedConfiguration* configuration(std::string_view name) const;  // null: there is none
  const NamedTarget* target(std::string_view name) const;                // null: there is none
  const RobotPath* path(std::string_view name) const;                    // null: there is none
  const NamedFrame* frame(std::string_view name) const;                  // null: there is none
  // Returns a generator of free names. O(names); reuse it for several names.
  FreeNames pathNames() const;
  // Returns a generator of names that neither a configuration nor a target has.
  FreeNames poseNames() const;
  FreeNames frameNames() const;
  std::string freePathName(const std::string& preferred) const { return pathNames().take(preferred); }
  std::string freePoseName(const std::string& preferred) const { return poseNames().take(preferred); }
  std::size_t bytes() const;  // approximate size in memory
  double clearanceOf(const RobotPath& path) const { return path.clearance.value_or(clearance); }  // mm
  // Returns the value of RobotPath::clearance with which clearanceOf() gives this clearance, mm: none if the cell has
  // it.
  std::optional<double> ownClearance(double kept) const {
    return kept == clearance ? std::nullopt : std::optional(kept);
  }
  // Makes another robot the planned one. present: the name of the present one, which keeps its tool.
  void choose(const std::string& other, const std::string& present);

  bool operator==(const CellPlans& other) const;
};

}  // namespace handwheel

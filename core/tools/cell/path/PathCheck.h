// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellScene.h"
#include "planning/PathMetrics.h"
#include "planning/PathTiming.h"
#include "planning/PathVerification.h"
#include "robot/program/RobotProgram.h"
#include "tools/cell/path/PairNames.h"
#include "tools/cell/path/WaitingTime.h"

#include <set>

namespace handwheel {

// A path of a cell as straight motions in joint space. Straight lines of the tool are replaced by short motions.
struct ResolvedPath {
  JointPath joints;
  std::vector<std::size_t> waypointOf;      // Index of the waypoint at the end of each motion, at least 1
  std::vector<std::size_t> valueOf = {};    // Index in joints of each waypoint up to stopsAt
  std::optional<std::size_t> stopsAt = {};  // Waypoint to which a line cannot be followed; the path ends before it
  double reached = 1.0;                     // Fraction of the line to stopsAt that can be followed
  std::vector<double> offs = {};  // mm, for each motion: the maximum deviation of a point of the robot from the line
};
ResolvedPath resolved(const CellScene& scene, const CellPlans& plans, const RobotPath& path, Progress progress = {});

// Returns the tool centre point along a path, in the frame of the base; mm. The curve has about a few thousand points
// at most. Lines of the tool need inverse kinematics, which takes seconds for long paths.
std::vector<Vec3> toolCurve(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                            Progress progress = {});

// Results of the check of a path in a cell.
struct CheckedPath {
  ResolvedPath resolved;
  VerifiedPath verification;
  PathMetrics metrics;
  // mm, for each waypoint: radius within which all motions are free; 0: an exact stop.
  std::vector<double> blends;
  // Estimated duration, with a stop at each waypoint without a blend, and the waits of known length.
  double seconds = 0.0;
  WaitingTime waiting = {};  // The waits of its lines
  // Other robots whose joint values or bases differ from those when the path was made. The results are valid for their
  // present poses.
  std::set<std::string> robotsMoved = {};
  // The reasons why the path is out of date.
  OutdatedReasons outdated = {};
  double clearance = 0.0;                  // mm, required clearance
  double resolution = 0.0;                 // mm, resolution of the proof
  std::vector<PairNames> notChecked = {};  // The result of uncheckedPairs()
  std::vector<MissingShape> missing = {};  // Shapes that could not be read
  std::vector<ProofGap> gaps = {};         // The result of gapsOf()

  // Returns true if all motions are proven, and nothing is missing that was not left out or replaced.
  bool isCertified() const { return isProvenAsWritten() && gaps.empty(); }
  // Returns true if the path is proven as programs are written, with zones that are as small as their proof needs.
  bool isProvenAsWritten() const;
  bool hasMissing() const;
  // Returns true if the robot touches something on the path: its clearance is 0, as it is displayed.
  bool isTouching() const;
  // Returns the index of the waypoint at the end of a motion of the verification. The index is at least 1.
  std::size_t waypointOf(std::size_t motion) const { return resolved.waypointOf[motion]; }
};

// A part of the motion to a waypoint in which the robot collides with one object, or is too close to it.
struct PathStretch {
  std::size_t waypoint = 0;       // Index of the waypoint at the end of the motion
  double from = 0.0, to = 0.0;    // Fractions of the motion to the waypoint
  RobotScene::Nearest deepest{};  // The nearest pair, at its least distance
  std::size_t motion = 0;  // Motion of the verification with the least distance; 0 also if the path has no motion
  double deepestAt = 0.0;  // Fraction of this motion at the least distance
  double needed = 0.0;     // mm: with less the proof does not tell what keeps the clearance

  bool meets() const { return deepest.distance <= 0.0; }
};
// Returns the collisions of the verification, sorted by their beginnings. Those of one pair on the way to one waypoint
// are joined if the pair does not get out of PathStretch::needed between them, as at motions of a line that are proven
// between others that are not. O(motions + collisions · pairs at a time).
std::vector<PathStretch> stretchesOf(const CheckedPath& checked, const CellScene& scene);

// Returns a summary of a verification. clearance: mm, the required clearance.
PathFindings findingsOf(const CheckedPath& checked, const CellScene& scene, double clearance);

// Options of the verification of a path.
struct PathCheckSettings {
  double clearance = 0.0;                                // mm, required clearance
  double resolution = MotionCheckSettings().resolution;  // mm, resolution of the proof
  double step = kVerificationStep;                       // rad, step at which unproven motions are sampled
};

// Verifies and measures a path of the scene's robot, with the other robots at their present joint values. The check
// does not end at the first collision. Errors: PathTooShort, OthersMoved, OfOtherArm,
// WaypointBeyondLimits, Cancelled.
Result<CheckedPath> checkPath(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                              const PathCheckSettings& settings, Progress progress = {});

// Returns the estimated times of a path when the robot executes it. blends: certified radius of each waypoint, at which
// the robot goes on without a stop.
TimedPath timed(const CellScene& scene, const CellPlans& plans, const RobotPath& path, const ResolvedPath& resolvedPath,
                std::span<const double> blends);

// Returns the number of waypoints between the ends whose blends become exact stops, because not every motion within
// their zones is proven free.
std::size_t stoppedBlends(const RobotPath& path, const CheckedPath& checked);

// A blend whose radius is reduced, but not to an exact stop; mm.
struct SmallerBlend {
  std::size_t waypoint;
  double wanted, kept;
};
std::vector<SmallerBlend> smallerBlends(const RobotPath& path, const CheckedPath& checked);
// Returns one English sentence about all of them, for programs and the command line; empty if there are none.
std::string smallerBlendsText(std::span<const SmallerBlend> smaller);

// Returns the program of a path for a controller. Blends that are not certified become exact stops; it has no remarks
// about blends.
RobotProgram programOf(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                       const CheckedPath& checked);

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellScene.h"
#include "planning/PathMetrics.h"
#include "planning/PathTiming.h"
#include "planning/PathVerification.h"
#include "robot/program/RobotProgram.h"
#include "tools/cell/path/PairNames.h"

#include <set>

namespace handwheel {

// A path of a cell as motions straight in joint space. Lines of the tool are followed by short ones.
struct ResolvedPath {
  JointPath joints;
  std::vector<std::size_t> placeOf;         // of each motion: the place that it leads to, from 1
  std::optional<std::size_t> stopsAt = {};  // a place that a line cannot be followed to; what is after it is missing
  double reached = 1.0;                     // of that line
  std::vector<double> offs = {};            // mm, of each motion: how far a point of the robot may be off it
};
ResolvedPath resolved(const CellScene& scene, const CellPlans& plans, const RobotPath& path, Progress progress = {});

// The tool's centre point along a path, in the frame of the base; mm. Not finer than a few
// thousand points. Lines of the tool take inverse kinematics: long paths seconds.
std::vector<Vec3> toolCurve(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                            Progress progress = {});

// What is known of a path in a cell.
struct CheckedPath {
  ResolvedPath way;
  VerifiedPath verification;
  PathMetrics metrics;
  // mm, of each place: how far the robot may leave it by and stay free on every way within that zone. 0: an exact stop.
  std::vector<double> blends;
  double seconds = 0.0;  // with a stop at each place, but between lines that blend
  // Other robots that stand elsewhere than when the path was made. What is said of it is true of where they stand now.
  std::set<std::string> robotsMoved = {};
  // What the path was planned for, and the tool does not meet any more.
  OutdatedReasons outdated = {};
  double clearance = 0.0;                  // mm, that was asked for
  std::vector<PairNames> notChecked = {};  // uncheckedPairs()

  bool isCertified() const { return !way.stopsAt && !verification.certified.empty() && verification.isCertified(); }
  // The place that a motion of the verification leads to, from 1.
  std::size_t placeOf(std::size_t motion) const { return way.placeOf[motion]; }
};

// A stretch of the way to a place in which the robot meets one and the same thing, or is too near to it.
struct PathStretch {
  std::size_t place = 0;          // that it leads to
  double from = 0.0, to = 0.0;    // shares of the way to the place
  RobotScene::Nearest deepest{};  // where it is nearest, and to what
  std::size_t motion = 0;         // of the verification, in which that is; 0 also where there is none
  double deepestAt = 0.0;         // share of the motion

  bool meets() const { return deepest.distance <= 0.0; }
};
// The collisions of the verification, those of motions that a line was resolved into taken together. In order of their
// begins. O(motions + collisions · pairs at a time).
std::vector<PathStretch> stretchesOf(const CheckedPath& checked, const CellScene& scene);

// In brief. clearance: that was asked for, mm.
PathFindings findingsOf(const CheckedPath& checked, const CellScene& scene, double clearance);

// How a path is verified.
struct PathCheckSettings {
  double clearance = 0.0;                                // mm that it must keep
  double resolution = MotionCheckSettings().resolution;  // mm, of the proof
  double step = kVerificationStep;                       // rad, at which what is not proven free is looked at
};

// Verifies and measures a path of the robot that the scene is for, with the others where they stand: all of it,
// whatever it finds. Errors: PathTooShort, OthersMoved, OfOtherArm, Cancelled.
Result<CheckedPath> checkPath(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                              const PathCheckSettings& settings, Progress progress = {});

// The path in time, as the robot plays it. blends: of each place, certified; lines that blend go on without a stop.
TimedPath timed(const CellScene& scene, const CellPlans& plans, const RobotPath& path, const ResolvedPath& way,
                std::span<const double> blends);

// The places between the ends whose blends become exact stops, since not every way within their zones is proven free.
std::size_t stoppedBlends(const RobotPath& path, const CheckedPath& checked);

// A blend that is made smaller, but no exact stop; mm.
struct SmallerBlend {
  std::size_t place;
  double wanted, kept;
};
std::vector<SmallerBlend> smallerBlends(const RobotPath& path, const CheckedPath& checked);

// The program of a path for a controller. Blends that are not certified become exact stops.
RobotProgram programOf(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                       const CheckedPath& checked);

}  // namespace handwheel

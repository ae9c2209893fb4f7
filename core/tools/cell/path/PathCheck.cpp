// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PathCheck.h"

#include "base/NumberText.h"
#include "base/ShownDistance.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellErrors.h"
#include "planning/CartesianLine.h"
#include "planning/PathShortcuts.h"
#include "robot/dh/DhTable.h"
#include "robot/posts/PostText.h"
#include "tools/cell/path/PathBlends.h"
#include "tools/cell/path/PathGaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace handwheel {

ResolvedPath resolved(const CellScene& scene, const CellPlans& plans, const RobotPath& path, Progress progress) {
  ResolvedPath resolvedPath;
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    ArmValues values = scene.planned(path.waypoints[i].joints);
    if (i > 0) values = byShortestTurn(scene.scene, resolvedPath.joints.back(), values);
    if (i > 0 && path.waypoints[i].motion == ProgramMotion::Kind::Linear) {
      const FollowedLine line = followLine(scene.arm, plans.tool, resolvedPath.joints.back(), values, {}, progress);
      for (std::size_t k = 1; k < line.path.size(); ++k)
        resolvedPath.offs.push_back(scene.scene.travelBound(line.path[k - 1], line.path[k], line.offs[k - 1]));
      resolvedPath.joints.insert(resolvedPath.joints.end(), line.path.begin() + 1, line.path.end());
      resolvedPath.waypointOf.resize(resolvedPath.joints.size() - 1, i);
      resolvedPath.valueOf.push_back(resolvedPath.joints.size() - 1);
      if (line.reached >= 1.0) continue;
      resolvedPath.stopsAt = i;
      resolvedPath.reached = line.reached;
      return resolvedPath;
    }
    resolvedPath.joints.push_back(values);
    resolvedPath.valueOf.push_back(resolvedPath.joints.size() - 1);
    if (i == 0) continue;
    resolvedPath.waypointOf.push_back(i);
    resolvedPath.offs.push_back(0.0);
  }
  return resolvedPath;
}

std::vector<Vec3> toolCurve(const CellScene& scene, const CellPlans& plans, const RobotPath& path, Progress progress) {
  constexpr double kStep = 0.02;  // rad, mm: of the joint that moves most
  constexpr double kMostSteps = 4000.0;
  const JointPath joints = resolved(scene, plans, path, progress).joints;
  const double step = std::max(kStep, lengthOf(scene.scene, joints) / kMostSteps);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const ArmValues& from = joints[i == 0 ? 0 : i - 1];
    const int count = std::max(1, static_cast<int>(std::ceil((joints[i] - from).cwiseAbs().maxCoeff() / step)));
    for (int k = 1; k <= count; ++k) {
      const ArmValues at = from + (static_cast<double>(k) / count) * (joints[i] - from);
      points.push_back((scene.arm.tipPose(at) * plans.tool).translation());
    }
  }
  return points;
}

bool CheckedPath::hasMissing() const {
  return std::ranges::find(missing, MissingShape::State::Open, &MissingShape::state) != missing.end();
}

bool CheckedPath::isProvenAsWritten() const {
  const auto isWritten = [](const ProofGap& gap) { return gap.kind == ProofGap::Kind::Zone; };
  return !resolved.stopsAt && !verification.certified.empty() && verification.isCertified() && !hasMissing() &&
         std::ranges::all_of(gaps, isWritten);
}

bool CheckedPath::isTouching() const {
  return !metrics.samples.empty() && !(shownDistance(metrics.leastClearance) > 0.0);
}

Result<CheckedPath> checkPath(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                              const PathCheckSettings& settings, Progress progress) {
  if (path.waypoints.size() < 2) return Error{CellError::PathTooShort, {path.name}, {}, {}};
  if (armNumber(*scene.robot, path.arm) != scene.armNumber)
    return Error{CellError::OfOtherArm, {path.name, path.arm}, {}, {}};
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    const Waypoint& waypoint = path.waypoints[i];
    const std::string name = waypoint.name.empty() ? std::to_string(i + 1) : waypoint.name;
    if (!scene.areOwnUnplannedJointsAt(waypoint.joints)) return Error{CellError::OthersMoved, {name}, {}, {}};
    constexpr double kRounding = 1e-6;  // rad: of files
    if (scene.arm.coupling() && !scene.arm.coupling()->isWithin(scene.planned(waypoint.joints), kRounding))
      return Error{CellError::WaypointBeyondLimits, {name, scene.nameOfCoupled()}, {}, {}};
  }
  CheckedPath checked;
  checked.robotsMoved = scene.robotsElsewhere(path);
  checked.outdated = outdatedReasonsOf(*scene.robot, {plans, scene.bodies, scene.robot->model, scene.others}, path);
  checked.clearance = settings.clearance;
  checked.resolution = settings.resolution;
  checked.waiting = waitingTimeOf(path);
  checked.notChecked = uncheckedPairs(scene, plans.allowed);
  checked.missing = scene.missing;
  checked.resolved = resolved(scene, plans, path, progress.part(0.0, 0.1));
  MotionCheckSettings check;
  check.clearance = settings.clearance;
  check.resolution = settings.resolution;
  checked.verification = verified(scene.scene, checked.resolved.joints, check, settings.step, progress.part(0.1, 0.6),
                                  checked.resolved.offs);
  checked.metrics = metricsOf(scene.scene, scene.arm, checked.resolved.joints, {}, progress.part(0.6, 0.95));
  checked.gaps = gapsOf(scene, plans, path, checked.resolved, settings.clearance, progress);
  std::vector<std::size_t> reduced;
  checked.blends = certifiedBlends(scene, plans, path, checked.resolved, settings.clearance, progress, &reduced);
  // A program that was read runs with its own zones.
  for (const std::size_t i : path.language.empty() ? std::vector<std::size_t>() : reduced)
    checked.gaps.push_back({.kind = ProofGap::Kind::Zone, .waypoint = i, .kept = checked.blends[i]});
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  checked.seconds = timed(scene, plans, path, checked.resolved, checked.blends).duration() + checked.waiting.seconds;
  return checked;
}

namespace {

// Returns the beginnings of motions, and the end of the last one, as shares of the path to their waypoint.
std::vector<std::array<double, 2>> sharesOf(const ResolvedPath& resolvedPath, const CellScene& scene) {
  std::vector<std::array<double, 2>> shares(resolvedPath.waypointOf.size());
  for (std::size_t begin = 0, end = 0; begin < shares.size(); begin = end) {
    double length = 0.0;
    for (end = begin; end < shares.size() && resolvedPath.waypointOf[end] == resolvedPath.waypointOf[begin]; ++end) {
      shares[end][0] = length;
      length += lengthOf(scene.scene, resolvedPath.joints[end], resolvedPath.joints[end + 1]);
      shares[end][1] = length;
    }
    for (std::size_t i = begin; i < end; ++i) {  // one that does not move is where it ends
      for (double& share : shares[i]) share = length > 0.0 ? share / length : 0.0;
    }
    if (!(length > 0.0)) shares[end - 1][1] = 1.0;
  }
  return shares;
}

bool isSamePair(const RobotScene::Nearest& a, const RobotScene::Nearest& b) {
  return a.link == b.link && a.otherLink == b.otherLink && a.owner == b.owner;
}

// Returns the distance from which on the proof finds a motion free, mm, with hundredths rounded up.
double neededOn(const CheckedPath& checked, std::size_t motion) {
  const double off = motion < checked.resolved.offs.size() ? checked.resolved.offs[motion] : 0.0;
  return checked.clearance + std::ceil(100.0 * off - 1e-9) / 100.0 + checked.resolution;
}

// Returns true if a pair does not get apart between two of its collisions: it stays nearer than what the least exact
// motion of a path needs.
bool goesOn(const CheckedPath& checked, const CellScene& scene, const PathCollision& last, const PathCollision& next) {
  constexpr double kBeside = 1e-9;  // Share of a motion
  const bool isNext = last.motion + 1 == next.motion && last.to >= 1.0 - kBeside && next.from <= kBeside;
  if (isNext) return true;
  const auto& offs = checked.resolved.offs;
  const double off = offs.empty() ? 0.0 : *std::max_element(offs.begin(), offs.end());
  const double needed = checked.clearance + off + checked.resolution;
  const JointPath& path = checked.resolved.joints;
  const auto isNear = [&](std::size_t motion, double share) {
    const ArmValues at = path[motion] + share * (path[motion + 1] - path[motion]);
    const auto met = at.allFinite() ? scene.scene.allTooNear(at, needed, needed) : std::vector<RobotScene::Nearest>();
    return std::ranges::any_of(met, [&](const auto& each) { return isSamePair(each, next.deepest); });
  };
  constexpr std::size_t kMostBetween = 64;  // motions; farther apart they count as several
  if (next.motion > last.motion + kMostBetween || next.motion < last.motion) return false;
  for (std::size_t motion = last.motion; motion <= next.motion; ++motion) {
    const double from = motion == last.motion ? last.to : 0.0, to = motion == next.motion ? next.from : 1.0;
    constexpr int kParts = 4;
    for (int k = 0; k <= kParts && to - from > kBeside; ++k) {
      if (!isNear(motion, from + (to - from) * k / kParts)) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<PathStretch> stretchesOf(const CheckedPath& checked, const CellScene& scene) {
  const std::vector<std::array<double, 2>> shares = sharesOf(checked.resolved, scene);
  std::vector<PathStretch> all;
  std::vector<PathCollision> ends;  // the last collision of each stretch
  for (const PathCollision& each : checked.verification.collisions) {
    if (each.motion >= shares.size()) {  // No motion begins at the first waypoint
      all.push_back({.waypoint = 0, .deepest = each.deepest, .motion = 0, .deepestAt = 0.0});
      ends.push_back(each);
      continue;
    }
    const double begin = shares[each.motion][0], end = shares[each.motion][1];
    const double to = begin + each.to * (end - begin);
    const std::size_t waypoint = checked.waypointOf(each.motion);
    std::size_t known = all.size();
    for (std::size_t i = all.size(); i-- > 0 && known == all.size() && all[i].waypoint == waypoint;) {
      if (isSamePair(all[i].deepest, each.deepest) && goesOn(checked, scene, ends[i], each)) known = i;
    }
    if (known == all.size()) {
      all.push_back({waypoint, begin + each.from * (end - begin), to, each.deepest, each.motion, each.deepestAt,
                     neededOn(checked, each.motion)});
      ends.push_back(each);
      continue;
    }
    PathStretch& stretch = all[known];
    stretch.to = std::max(stretch.to, to);
    ends[known] = each;
    if (each.deepest.distance < stretch.deepest.distance) {
      stretch.deepest = each.deepest;
      stretch.motion = each.motion;
      stretch.deepestAt = each.deepestAt;
      stretch.needed = neededOn(checked, each.motion);
    }
  }
  return all;
}

PathFindings findingsOf(const CheckedPath& checked, const CellScene& scene, double clearance) {
  const std::vector<PathStretch> all = stretchesOf(checked, scene);
  PathFindings found{.isCertified = checked.isCertified(),
                     .stopsAt = checked.resolved.stopsAt,
                     .collisions = all.size(),
                     .tooNear = static_cast<std::size_t>(
                         std::count_if(all.begin(), all.end(), [](const PathStretch& each) { return !each.meets(); })),
                     .clearance = clearance,
                     .leastClearance = checked.metrics.leastClearance,
                     .seconds = checked.seconds,
                     .measures = PathMeasures{checked.metrics.turned, checked.metrics.security,
                                              checked.metrics.manipulability, checked.metrics.slid},
                     .isTouching = checked.isTouching(),
                     .missing = checked.missing,
                     .robotsMoved = checked.robotsMoved,
                     .outdated = checked.outdated,
                     .notChecked = checked.notChecked,
                     .gaps = checked.gaps};
  for (std::size_t i = 0; i < std::min(all.size(), PathFindings::kMostListed); ++i) {
    auto [link, other] = scene.namesOf(all[i].deepest);
    found.listed.push_back({all[i].waypoint, std::move(link), std::move(other),
                            all[i].meets() ? 0.0 : all[i].deepest.distance, all[i].meets() ? 0.0 : all[i].needed});
  }
  return found;
}

namespace {

// Returns the times of a path whose motions to some waypoints last as long as their programs demand, if the robot can
// move as fast.
TimedPath withDurations(const CellScene& scene, const RobotPath& path, const ResolvedPath& resolvedPath,
                        const PathTimingSettings& settings, std::vector<MotionPace>& paces) {
  constexpr int kMostRounds = 12;
  constexpr double kSame = 1e-3, kLeastFactor = 0.05, kMostFactor = 20.0;  // shares
  const auto& waypointOf = resolvedPath.waypointOf;
  TimedPath result(scene.scene, resolvedPath.joints, settings, paces);
  for (int round = 0; round < kMostRounds; ++round) {
    bool isDone = true;
    for (std::size_t begin = 0, end = 0; begin < waypointOf.size(); begin = end) {
      for (end = begin; end < waypointOf.size() && waypointOf[end] == waypointOf[begin];) ++end;
      const double wanted = path.waypoints[waypointOf[begin]].seconds;
      const double lasts = result.beginOf(end) - result.beginOf(begin);
      if (wanted <= 0.0 || !(lasts > 0.0) || std::abs(lasts - wanted) <= kSame * wanted) continue;
      const double factor = std::clamp(lasts / wanted, kLeastFactor, kMostFactor);
      for (std::size_t i = begin; i < end; ++i) {
        const bool isOfTool = paces[i].length > 0.0 && paces[i].toolSpeed > 0.0;
        double& speed = isOfTool ? paces[i].toolSpeed : paces[i].speed;
        const double before = speed;
        speed *= factor;
        if (!isOfTool) speed = std::clamp(speed, 1e-6, 1.0);
        isDone = isDone && before == speed;
      }
    }
    if (isDone) break;
    result = TimedPath(scene.scene, resolvedPath.joints, settings, paces);
  }
  return result;
}

}  // namespace

TimedPath timed(const CellScene& scene, const CellPlans& plans, const RobotPath& path, const ResolvedPath& resolvedPath,
                std::span<const double> blends) {
  const auto positionAt = [&](const ArmValues& values) {
    return Vec3((scene.arm.tipPose(values) * plans.tool).translation());
  };
  std::vector<MotionPace> paces;
  for (std::size_t i = 0; i < resolvedPath.waypointOf.size(); ++i) {
    const std::size_t leadsTo = resolvedPath.waypointOf[i];
    const Waypoint& to = path.waypoints[leadsTo];
    const ArmValues &begin = resolvedPath.joints[i], &end = resolvedPath.joints[i + 1];
    const bool isLast = i + 1 == resolvedPath.waypointOf.size() || resolvedPath.waypointOf[i + 1] != leadsTo;
    const bool isJoint = to.motion == ProgramMotion::Kind::Joint;
    const int parts = isJoint ? 8 : 1;  // a joint motion bends the way of the tool
    double length = 0.0;
    for (int k = 0; k < parts; ++k)
      length += (positionAt(begin + (k + 1.0) / parts * (end - begin)) -
                 positionAt(begin + static_cast<double>(k) / parts * (end - begin)))
                    .norm();
    constexpr double kStill = 1e-6;  // mm: where the tool only turns the joints count
    const double zone = isLast && leadsTo < blends.size() ? blends[leadsTo] : 0.0;
    paces.push_back({.speed = isJoint ? to.speed : 1.0,
                     .length = length > kStill ? length : 0.0,
                     .toolSpeed = isJoint ? 0.0 : to.speed,
                     .isContinued = !isLast || zone > 0.0,
                     .zone = zone});
  }
  return withDurations(scene, path, resolvedPath, {plans.rates}, paces);
}

std::size_t stoppedBlends(const RobotPath& path, const CheckedPath& checked) {
  std::size_t count = 0;
  for (std::size_t i = 1; i + 1 < path.waypoints.size(); ++i)
    count += path.waypoints[i].blend > 0.0 && checked.blends[i] == 0.0 ? 1 : 0;
  return count;
}

std::vector<SmallerBlend> smallerBlends(const RobotPath& path, const CheckedPath& checked) {
  std::vector<SmallerBlend> all;
  for (std::size_t i = 1; i + 1 < path.waypoints.size(); ++i) {
    const double wanted = path.waypoints[i].blend, kept = checked.blends[i];
    if (kept > 0.0 && kept < wanted) all.push_back({i, wanted, kept});
  }
  return all;
}

std::string smallerBlendsText(std::span<const SmallerBlend> smaller) {
  if (smaller.empty()) return {};
  const auto [least, most] =
      std::ranges::minmax_element(smaller, {}, [](const SmallerBlend& each) { return each.kept; });
  const auto kept = [](const SmallerBlend& each) {
    return roundedText(each.kept, 3) + " mm in place of " + roundedText(each.wanted, 6) + " mm at place " +
           std::to_string(each.waypoint + 1);
  };
  const bool areAlike = kept(*least) == kept(*most) || roundedText(least->kept, 3) == roundedText(most->kept, 3);
  const std::string range = areAlike ? kept(*least) : "from " + kept(*least) + " to " + kept(*most);
  return "Smaller blends than asked: " + std::to_string(smaller.size()) +
         (areAlike && smaller.size() > 1 ? ", as " : ", ") + range +
         ". A blend has half of the shorter motion beside it at most, and only where it is proven free.";
}

namespace {

std::vector<std::string> remarksOn(const CheckedPath& checked) {
  constexpr std::size_t kLongestName = 60, kMostPairs = 50;
  std::vector<std::string> remarks;
  const auto& pairs = checked.notChecked;
  for (const auto& [one, other] : std::span(pairs).first(std::min(pairs.size(), kMostPairs)))
    remarks.push_back("Not checked: " + identifierOf(one, kLongestName) + " with " + identifierOf(other, kLongestName) +
                      ".");
  if (pairs.size() > kMostPairs)
    remarks.push_back("Not checked: " + std::to_string(pairs.size() - kMostPairs) + " more pairs.");
  if (checked.isTouching()) remarks.emplace_back("Touching: the least clearance is 0 mm.");
  const OutdatedReasons& outdated = checked.outdated;
  if (!outdated.part.empty())
    remarks.push_back("Outdated: the part " + identifierOf(outdated.part, kLongestName) +
                      " has moved since the path was planned along it.");
  if (outdated.isBaseOther)
    remarks.emplace_back("Outdated: the base of the robot has moved since the path was planned along its curve.");
  if (outdated.isToolOther)
    remarks.push_back("Outdated: the tool centre point was changed since the path was planned along its curve.");
  for (const std::string& target : outdated.targets)
    remarks.push_back("Outdated: the tool does not come to the target " + identifierOf(target, kLongestName) +
                      " any more: that, or the tool, has moved since the path was planned.");
  for (const std::string& frame : outdated.frames)
    remarks.push_back("Outdated: the frame " + identifierOf(frame, kLongestName) +
                      ", or the tool, has moved since the path was read from a program.");
  for (const std::string& configuration : outdated.configurations)
    remarks.push_back("Outdated: " + identifierOf(configuration, kLongestName) +
                      " was changed since the path was planned through it.");
  for (const std::string& robot : checked.robotsMoved)
    remarks.push_back("Proven with the robot " + identifierOf(robot, kLongestName) +
                      " where it stood at export: it has moved since the path was made.");
  for (const MissingShape& each : checked.missing) {
    const std::string decided = each.state == MissingShape::State::Replaced
                                    ? "replaced by " + identifierOf(each.by, kLongestName)
                                    : "left out of the proof";
    remarks.push_back("Shape not read: " + identifierOf(each.name, kLongestName) + " (" +
                      identifierOf(each.what, kLongestName) + "), " + decided + ".");
  }
  return remarks;
}

}  // namespace

RobotProgram programOf(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                       const CheckedPath& checked) {
  RobotProgram program;
  program.name = path.name;
  program.robot = scene.plannedArm().title;
  program.arm = scene.armFromBase();
  program.tool = plans.tool;
  program.isBaseOfController = libraryRobot(scene.plannedArm().title) != nullptr;
  program.hasPlainShapes = hasPlainShapes(scene.robot->model, scene.robot->arms, scene.armNumber);
  program.clearance = checked.clearance;
  program.remarks = remarksOn(checked);
  if (!path.waypoints.empty() && path.waypoints.front().corner > 0.0)
    program.remarks.emplace_back(
        "Exact stop at the first place in place of its rounding: the motion to it is not checked.");
  program.head = path.head;
  program.language = path.language;
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    const Waypoint& waypoint = path.waypoints[i];
    ArmValues joints = scene.planned(waypoint.joints);
    if (i > 0) joints = byShortestTurn(scene.scene, program.motions.back().joints, joints);
    ProgramMotion motion{waypoint.motion, joints,          waypoint.speed,   checked.blends[i],
                         waypoint.name,   waypoint.corner, waypoint.seconds, waypoint.lines};
    if (i == 0) {
      motion.kind = ProgramMotion::Kind::Joint;
      motion.corner = 0.0;  // the motion to the first place is not known
    }
    program.motions.push_back(std::move(motion));
  }
  return program;
}

}  // namespace handwheel

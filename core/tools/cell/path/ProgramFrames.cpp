// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/ProgramFrames.h"

#include "document/cell/CellArms.h"
#include "document/cell/path/OutdatedReasons.h"
#include "document/scene/BodyChanges.h"
#include "robot/posts/PostText.h"
#include "scene/RigidPose.h"

#include <algorithm>
#include <map>
#include <set>

namespace handwheel {

namespace {

// Returns the names, in lower case, that programs in the languages give a frame of the cell.
std::set<std::string> namesInPrograms(const CellPlans& plans, const NamedFrame& frame) {
  RobotProgram program;
  program.frameName = frame.name;
  for (const NamedFrame& other : plans.frames) {
    if (other.name != frame.name) program.otherFrames.push_back(other.name);
  }
  std::set<std::string> names;
  constexpr std::size_t kLongest[] = {24, 25, 50, 60};  // Fanuc, RAPID, URScript; KRL and tables
  for (const std::size_t longest : kLongest) {
    names.insert(lowerCase(frameIdentifier(program, {}, longest)));
    names.insert(lowerCase(identifierOf(frame.name, longest)));
  }
  return names;
}

// The frames of a plan as programs call them. There are few frames in a cell, but each has many names.
class KnownFrames {
 public:
  explicit KnownFrames(const CellPlans& plans) {
    for (const NamedFrame& frame : plans.frames) add(plans, frame);
  }
  void add(const CellPlans& plans, const NamedFrame& frame) { m_names[frame.name] = namesInPrograms(plans, frame); }
  bool isCalled(const NamedFrame& frame, const std::string& name) const {
    constexpr std::string_view kRapidPrefix = "wobj_";
    const std::set<std::string>& names = m_names.at(frame.name);
    const std::string lower = lowerCase(name);
    return frame.name == name || names.contains(lower) ||
           (lower.starts_with(kRapidPrefix) && names.contains(lower.substr(kRapidPrefix.size())));
  }

 private:
  std::map<std::string, std::set<std::string>> m_names;
};

// "fixture 2" of "fixture".
bool isNumbered(const std::string& name, const std::string& preferred) {
  return name.starts_with(preferred + " ") && name.size() > preferred.size() + 1 &&
         name.find_first_not_of("0123456789", preferred.size() + 1) == name.npos;
}

// The frame of a motion under a name that a frame of a cell can have.
std::optional<NamedFrame> frameOf(const ParsedMotion& motion, const Pose& base) {
  if (!motion.frame || motion.frameName.empty() || isSamePose(*motion.frame, Pose::Identity())) return std::nullopt;
  constexpr std::size_t kShortened = 60;
  const bool isUsable = isBodyName(motion.frameName);
  NamedFrame frame{isUsable ? motion.frameName : identifierOf(motion.frameName, kShortened), base * *motion.frame};
  return isRigid(frame.pose) ? std::optional(std::move(frame)) : std::nullopt;
}

}  // namespace

std::size_t frameNumber(const std::vector<NamedFrame>& frames, const ParsedMotion& motion, const Pose& base) {
  const std::optional<NamedFrame> frame = frameOf(motion, base);
  const auto found = std::ranges::find_if(frames, [&](const NamedFrame& other) {
    return frame && other.name == frame->name && isSamePose(other.pose, frame->pose);
  });
  return static_cast<std::size_t>(found - frames.begin());
}

std::vector<NamedFrame> framesOf(const std::vector<ParsedMotion>& motions, const Pose& base) {
  std::vector<NamedFrame> frames;
  for (const ParsedMotion& motion : motions) {
    std::optional<NamedFrame> frame = frameOf(motion, base);
    const bool isNew = frame && frameNumber(frames, motion, base) == frames.size();
    if (isNew && frames.size() < CellPlans::kMostFrames) frames.push_back(*std::move(frame));
  }
  return frames;
}

TakenFrames takeFrames(const std::vector<NamedFrame>& read, const CellPlacement& cell, CellPlans& plans) {
  TakenFrames taken;
  KnownFrames known(plans);
  for (const NamedFrame& frame : read) {
    const auto called =
        std::ranges::find_if(plans.frames, [&](const NamedFrame& each) { return known.isCalled(each, frame.name); });
    const bool isOwnName = plans.frame(frame.name) || called == plans.frames.end();
    const std::string preferred = isOwnName ? frame.name : called->name;
    const auto same = std::ranges::find_if(plans.frames, [&](const NamedFrame& each) {
      const Result<Pose> pose = poseOfFrame(each, cell);
      return (known.isCalled(each, frame.name) || isNumbered(each.name, preferred)) && pose &&
             isSamePose(*pose, frame.pose);
    });
    if (same != plans.frames.end()) {
      taken.used.push_back(same->name);
      taken.names.push_back(same->name);
    } else if (plans.frames.size() >= CellPlans::kMostFrames) {
      taken.leftOut.push_back(frame.name);
      taken.names.emplace_back();
    } else {
      const std::string name = plans.frameNames().take(preferred);
      plans.frames.push_back({name, frame.pose});
      known.add(plans, plans.frames.back());
      taken.made.push_back(name);
      taken.names.push_back(name);
    }
  }
  return taken;
}

TakenFrames takeProgram(ProgramPath read, const CellRobot& robot, const CellPlacement& cell, CellPlans& plans) {
  TakenFrames taken = takeFrames(read.frames, cell, plans);
  const CellPlacement there{plans, cell.bodies, cell.robot, cell.joints};
  for (std::size_t i = 0; i < read.path.waypoints.size(); ++i) {
    Waypoint& waypoint = read.path.waypoints[i];
    const std::size_t number = i < read.frameOf.size() ? read.frameOf[i] : taken.names.size();
    if (number >= taken.names.size() || taken.names[number].empty()) continue;
    const std::string& name = taken.names[number];
    // A frame that this robot carries is elsewhere at each waypoint, unlike that of the program.
    const Result<Pose> now = poseOfFrame(
        name, {plans, cell.bodies, cell.robot, jointsSetBy(robot, read.path.arm, waypoint.joints, cell.joints)});
    if (!now || !isSamePose(*now, read.frames[number].pose)) continue;
    if (const auto inTool = frameInTool(robot, there, read.path.arm, waypoint.joints, name))
      waypoint.frame = WaypointTarget{name, *inTool};
  }
  plans.paths.push_back(std::move(read.path));
  return taken;
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/ProgramFrames.h"

#include "base/Units.h"
#include "robot/posts/PostText.h"
#include "scene/RigidPose.h"

#include <algorithm>

namespace handwheel {

namespace {

bool isSamePlace(const Pose& a, const Pose& b) {
  constexpr double kDistance = 1e-3, kAngle = 1e-3 * kRadiansPerDegree;  // mm, rad: as programs are read back
  const double angle = Eigen::Quaterniond(a.linear()).angularDistance(Eigen::Quaterniond(b.linear()));
  return (a.translation() - b.translation()).norm() <= kDistance && angle <= kAngle;
}

// Whether programs in some language call a frame of the cell like this.
bool isCalled(const CellPlans& plans, const NamedFrame& frame, const std::string& name) {
  if (frame.name == name) return true;
  RobotProgram program;
  program.frameName = frame.name;
  for (const NamedFrame& other : plans.frames) {
    if (other.name != frame.name) program.otherFrames.push_back(other.name);
  }
  const std::string wanted = lowerCase(name);
  const auto isIt = [&](const std::string& identifier) {
    const std::string lower = lowerCase(identifier);
    return wanted == lower || wanted == "wobj_" + lower;
  };
  constexpr std::size_t kLongest[] = {24, 25, 50, 60};  // Fanuc, RAPID, URScript; KRL and tables
  return std::ranges::any_of(kLongest, [&](std::size_t longest) {
    return isIt(frameIdentifier(program, {}, longest)) || isIt(identifierOf(frame.name, longest));
  });
}

// "fixture 2" of "fixture".
bool isNumbered(const std::string& name, const std::string& wish) {
  return name.starts_with(wish + " ") && name.size() > wish.size() + 1 &&
         name.find_first_not_of("0123456789", wish.size() + 1) == name.npos;
}

}  // namespace

std::vector<NamedFrame> framesOf(const std::vector<ReadMotion>& motions, const Pose& base) {
  std::vector<NamedFrame> frames;
  for (const ReadMotion& motion : motions) {
    if (!motion.frame || motion.frameName.empty() || isSamePlace(*motion.frame, Pose::Identity())) continue;
    const NamedFrame frame{motion.frameName, base * *motion.frame};
    if (!isRigid(frame.pose) || frames.size() >= CellPlans::kMostFrames) continue;
    const bool isThere = std::ranges::any_of(frames, [&](const NamedFrame& other) {
      return other.name == frame.name && isSamePlace(other.pose, frame.pose);
    });
    if (!isThere) frames.push_back(frame);
  }
  return frames;
}

TakenFrames takeFrames(const std::vector<NamedFrame>& read, const CellPlacement& cell, CellPlans& plans) {
  TakenFrames taken;
  for (const NamedFrame& frame : read) {
    const auto called =
        std::ranges::find_if(plans.frames, [&](const NamedFrame& known) { return isCalled(plans, known, frame.name); });
    const std::string wish = called == plans.frames.end() ? frame.name : called->name;
    const auto same = std::ranges::find_if(plans.frames, [&](const NamedFrame& known) {
      const Result<Pose> pose = poseOfFrame(known, cell);
      return (isCalled(plans, known, frame.name) || isNumbered(known.name, wish)) && pose &&
             isSamePlace(*pose, frame.pose);
    });
    if (same != plans.frames.end()) {
      taken.used.push_back(same->name);
    } else if (plans.frames.size() >= CellPlans::kMostFrames) {
      taken.leftOut.push_back(frame.name);
    } else {
      const std::string name = plans.frameNames().take(wish);
      plans.frames.push_back({name, frame.pose});
      taken.made.push_back(name);
    }
  }
  return taken;
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/PathExport.h"

#include "base/NumberText.h"
#include "document/AtomicFile.h"
#include "document/DocumentErrors.h"
#include "document/cell/CellErrors.h"
#include "robot/arm/NumericalIk.h"
#include "robot/program/PathFile.h"

namespace handwheel {

namespace {

constexpr double kMostOff = 1e-3;  // mm, degrees

std::optional<Error> problemOf(const CellScene& scene, const RobotPath& path, const CheckedPath& checked) {
  if (checked.isCertified()) return std::nullopt;
  if (checked.way.stopsAt) {
    const std::string place = std::to_string(*checked.way.stopsAt + 1);
    return Error{CellError::LineUnreachable, {place, roundedText(100.0 * checked.way.reached, 3)}, {}, {}};
  }
  const auto& collisions = checked.verification.collisions;
  const auto [link, other] =
      collisions.empty() ? std::pair<std::string, std::string>() : scene.namesOf(collisions.front().deepest);
  return Error{CellError::PathCollides, {path.name, std::to_string(collisions.size()), link, other}, {}, {}};
}

}  // namespace

Result<WrittenProgram> writeProgram(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    const CheckedPath& checked, const Post& post, const std::filesystem::path& output) {
  if (const auto problem = problemOf(scene, path, checked)) return *problem;
  const RobotProgram program = programOf(scene, plans, path, checked);
  if (const std::vector<Error> refusals = post.refusals(program); !refusals.empty()) return refusals.front();
  const std::string text = post.write(program);
  const Result<PostCheck> check = checkWritten(post, program, text);
  if (!check) return check.error();
  if (check->distance > kMostOff || check->angle > kMostOff)
    return Error{DocumentError::CheckFailed, {std::string("the ") + post.title() + " program"}, {}, output.string()};
  const Status written = writeFileAtomically(output, text, {});
  if (!written) return written.error();
  WrittenProgram result{*check, 0};
  for (std::size_t i = 0; i < path.places.size(); ++i)
    result.exactStops += path.places[i].blend > 0.0 && checked.blends[i] == 0.0 ? 1 : 0;
  return result;
}

Result<RobotPath> pathFromProgram(const CellScene& scene, const RobotCellSnapshot& cell, const Post& post,
                                  std::string_view text) {
  RobotProgram frame;
  frame.arm = scene.arm;
  frame.tool = cell.plans->tool;
  const Result<std::vector<ReadMotion>> motions = post.read(text, frame);
  if (!motions) return motions.error();
  RobotPath path{"program", {}};
  ArmValues before = scene.planned(cell.joints);
  for (const ReadMotion& motion : *motions) {
    const auto located = [&](Error error) {
      error.position = InputPosition::line(motion.line);
      return error;
    };
    if (motion.joints) {
      before = *motion.joints;
    } else {
      const Pose tip = *motion.pose * frame.tool.inverse(Eigen::Isometry);
      const NumericalIkResult found = solvedNumerically(scene.arm, tip, before, {.tolerance = 1e-8, .seconds = 0.05});
      if (!found.isSolved)
        return located({CellError::PoseUnreachable, {std::to_string(path.places.size() + 1)}, {}, {}});
      before = found.values;
    }
    PathPlace place{.joints = scene.whole(before)};
    if (const Status within = checkLimits(cell.robot->model, place.joints); !within) return located(within.error());
    place.motion = path.places.empty() ? ProgramMotion::Kind::Joint : motion.kind;
    if (place.motion == ProgramMotion::Kind::Linear) place.speed = 250.0;
    place.blend = std::max(0.0, motion.blend);
    path.places.push_back(std::move(place));
  }
  return path;
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/PathReport.h"

#include "base/NumberText.h"
#include "base/ShownDistance.h"
#include "cli/Messages.h"
#include "document/cell/CellErrors.h"
#include "document/cell/proof/MissingShapes.h"
#include "planning/PlanningFidelity.h"
#include "robot/program/PathFile.h"
#include "tools/cell/path/ProgramRemarks.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

namespace handwheel {

namespace {

// Looked at for one collision, and listed of these.
constexpr std::size_t kMostTouches = 256, kMostListed = 16;

nlohmann::ordered_json touchesJson(const std::vector<ClosestPoints>& touches) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ClosestPoints& each : std::span(touches).first(std::min(touches.size(), kMostListed))) {
    const Vec3 middle = 0.5 * (each.first + each.second);
    list.push_back({{"at_mm", std::vector<double>(middle.begin(), middle.end())},
                    {"normal", std::vector<double>(each.normal.begin(), each.normal.end())},
                    {"distance_mm", each.distance}});
  }
  return list;
}

nlohmann::ordered_json toJson(const CellScene& scene, const CheckedPath& checked, const PathStretch& stretch) {
  const auto [link, other] = scene.namesOf(stretch.deepest);
  const JointPath& path = checked.resolved.joints;
  const ArmValues& from = path[stretch.motion];
  const ArmValues& to = path[std::min(stretch.motion + 1, path.size() - 1)];
  const ArmValues at = from + stretch.deepestAt * (to - from);
  const auto touches = stretch.deepest.link == kNone || !at.allFinite()
                           ? std::vector<ClosestPoints>()
                           : scene.scene.touches(at, stretch.deepest, kMostTouches);
  return {{"place", stretch.waypoint},
          {"from", stretch.from},
          {"to", stretch.to},
          {"link", link},
          {"with", other},
          {"distance_mm", stretch.deepest.distance},
          {"needed_mm", stretch.needed},
          {"q", std::vector<double>(at.begin(), at.end())},
          {"contacts", touchesJson(touches)},
          {"contacts_found", touches.size()},
          {"contacts_complete", touches.size() < kMostTouches}};
}

std::string share(double value) {
  return roundedText(100.0 * value, 3) + " %";
}

bool hasSlides(const CellScene& scene) {
  return std::ranges::any_of(scene.arm.joints(), &ArmJoint::isPrismatic);
}

// "4.99 mm, where 5.1 mm are needed (clearance 5 mm, line 0.05 mm, resolution 0.05 mm)": less than needed also as
// shown.
std::string nearText(const PathStretch& stretch, const CheckedPath& checked) {
  const auto shown = [](double length) { return roundedText(std::round(1e3 * length) / 1e3, 9) + " mm"; };
  const double line = stretch.needed - checked.clearance - checked.resolution;
  constexpr double kLeast = 5e-3;  // mm
  return shown(std::floor(1e3 * stretch.deepest.distance + 1e-6) / 1e3) + ", where " + shown(stretch.needed) +
         " are needed (clearance " + shown(checked.clearance) + (line > kLeast ? ", line " + shown(line) : "") +
         ", resolution " + shown(checked.resolution) + ")";
}

// The time, and its waiting.
std::string secondsText(const CheckedPath& checked) {
  const WaitingTime& waiting = checked.waiting;
  std::string text = roundedText(checked.seconds, 3) + " s";
  if (waiting.seconds > 0.0) text += " (" + roundedText(waiting.seconds, 3) + " s of it waiting)";
  if (waiting.unknown > 0)
    text += " and the time of " + std::to_string(waiting.unknown) + (waiting.unknown == 1 ? " line" : " lines") +
            " that wait for something";
  return text;
}

}  // namespace

std::vector<std::string> reasonsOf(const OutdatedReasons& outdated) {
  std::vector<std::string> reasons;
  if (!outdated.part.empty())
    reasons.push_back("the part " + outdated.part + " has moved since the path was planned along it");
  if (outdated.isBaseOther)
    reasons.emplace_back("the base of its robot has moved since the path was planned along its curve");
  if (outdated.isToolOther)
    reasons.emplace_back("the tool centre point was changed since the path was planned along its curve");
  for (const std::string& target : outdated.targets)
    reasons.push_back("the tool does not come to the target " + target + " any more: that, or the tool, has moved");
  for (const std::string& frame : outdated.frames)
    reasons.push_back("the frame " + frame + ", or the tool, has moved since the program of the path was opened");
  for (const std::string& configuration : outdated.configurations)
    reasons.push_back("the configuration " + configuration + " was changed since the path was planned through it");
  return reasons;
}

nlohmann::ordered_json toJson(const CellScene& scene, const RobotPath& path, const CheckedPath& checked) {
  const PathMetrics& metrics = checked.metrics;
  nlohmann::ordered_json collisions = nlohmann::ordered_json::array();
  for (const PathStretch& each : stretchesOf(checked, scene)) collisions.push_back(toJson(scene, checked, each));
  nlohmann::ordered_json json = {
      {"certified", checked.isCertified()},       {"length_rad", metrics.turned},
      {"waypoints", path.waypoints.size()},       {"min_clearance_mm", metrics.leastClearance},
      {"manipulability", metrics.manipulability}, {"security_mm", metrics.security},
      {"limit_margin", metrics.leastMargin},      {"cycle_s", checked.seconds},
      {"waiting_s", checked.waiting.seconds},     {"unknown_waits", checked.waiting.unknown},
      {"robots_moved", checked.robotsMoved},      {"collisions", collisions}};
  if (hasSlides(scene)) json["length_mm"] = metrics.slid;
  const OutdatedReasons& outdated = checked.outdated;
  json["outdated"] = outdated.isAny();
  if (!outdated.part.empty()) json["part_moved"] = outdated.part;
  if (outdated.isBaseOther) json["base_moved"] = true;
  if (outdated.isToolOther) json["tool_changed"] = true;
  if (!outdated.targets.empty()) json["targets_moved"] = outdated.targets;
  if (!outdated.frames.empty()) json["frames_moved"] = outdated.frames;
  if (!outdated.configurations.empty()) json["configurations_changed"] = outdated.configurations;
  json["touching"] = checked.isTouching();
  json["not_checked"] = checked.notChecked;
  json["missing_shapes"] = describeMissing(checked.missing);
  json["not_proven"] = nlohmann::ordered_json::array();
  for (const ProofGap& gap : checked.gaps) {
    nlohmann::ordered_json each = {{"place", gap.waypoint}};
    if (gap.kind == ProofGap::Kind::Corner) each["reason"] = "cnt";
    if (gap.kind == ProofGap::Kind::Zone) each.update({{"reason", "zone"}, {"kept_mm", gap.kept}});
    if (gap.kind == ProofGap::Kind::Carried)
      each.update({{"reason", "carried"}, {"text", gap.text}, {"line", gap.line}});
    json["not_proven"].push_back(std::move(each));
  }
  if (checked.resolved.stopsAt)
    json["stops_at"] = {{"place", *checked.resolved.stopsAt}, {"share", checked.resolved.reached}};
  return json;
}

std::string textOf(const CellScene& scene, const RobotPath& path, const CheckedPath& checked) {
  const PathMetrics& metrics = checked.metrics;
  std::string text =
      path.name + ": " + std::to_string(path.waypoints.size()) + " places, " + roundedText(metrics.turned, 4) +
      " rad, " + (hasSlides(scene) ? roundedText(metrics.slid, 4) + " mm of slides, " : "") + secondsText(checked) +
      ", " + (checked.isCertified() ? "proven free of collisions" : "not proven free of collisions") +
      (checked.isCertified() && checked.isTouching() ? ", but touching\n" : "\n") + "least clearance " +
      shownText(shownDistance(metrics.leastClearance)) + " mm, security index " + roundedText(metrics.security, 4) +
      " mm, manipulability " + roundedText(metrics.manipulability, 3) + ", margin to the limits " +
      share(metrics.leastMargin) + "\n";
  const auto& pairs = checked.notChecked;
  for (const auto& [one, other] : std::span(pairs).first(std::min(pairs.size(), kMostListedPairs)))
    text += "not checked, as they may touch: " + one + " with " + other + "\n";
  if (pairs.size() > kMostListedPairs)
    text += "not checked, as they may touch: " + std::to_string(pairs.size() - kMostListedPairs) + " more pairs\n";
  for (const MissingShape& each : checked.missing) text += sentenceOn(each) + "\n";
  if (checked.resolved.stopsAt) {
    text += "the arm cannot follow the line to place " + std::to_string(*checked.resolved.stopsAt + 1) +
            ": it stops after " + share(checked.resolved.reached) + "\n";
  }
  for (const ProofGap& gap : checked.gaps) {
    const std::string waypoint = "place " + std::to_string(gap.waypoint + 1);
    if (gap.kind == ProofGap::Kind::Corner)
      text += "not proven: CNT rounds the corner at " + waypoint + ", and not everything within it is free\n";
    if (gap.kind == ProofGap::Kind::Zone)
      text += "not proven: not everything within the zone at " + waypoint + " is free; an export writes " +
              (gap.kept > 0.0 ? "a zone of " + roundedText(gap.kept, 3) + " mm\n" : "an exact stop\n");
    if (gap.kind == ProofGap::Kind::Carried)
      text += "not proven after " + waypoint + ": line " + std::to_string(gap.line) + ", '" + gap.text +
              "', may grip or release; say what is carried (--carried same: as before)\n";
  }
  for (const std::string& robot : checked.robotsMoved)
    text += "the robot " + robot + " has moved since the path was made; the figures hold for its present position\n";
  const bool isProgram = !checked.outdated.frames.empty();
  for (const std::string& reason : reasonsOf(checked.outdated))
    text += reason + (isProgram ? ": open the program again, or plan the path again\n" : ": plan it again\n");
  for (const PathStretch& each : stretchesOf(checked, scene)) {
    const auto [link, other] = scene.namesOf(each.deepest);
    text += "motion to place " + std::to_string(each.waypoint + 1) + ", " + share(each.from) + " to " + share(each.to) +
            ": " + link + " with " + other + (each.meets() ? "" : ", too near: " + nearText(each, checked)) + "\n";
  }
  return text;
}

void warnOfShapes(const CellScene& scene) {
  for (const MissingShape& each : scene.missing) complain("warning: " + sentenceOn(each));
  if (hasPlainShapes(scene.robot->model, scene.robot->arms, scene.armNumber)) {
    complain(
        "The robot has simplified shapes, smaller than its own in places: keep a clearance, or use its meshes by a "
        "URDF.");
  }
}

std::string readProof(const Arguments& arguments, PathCheckSettings& settings) {
  const std::pair<FidelitySetting, double*> all[] = {{planResolutionSetting(), &settings.resolution},
                                                     {verifyStepSetting(), &settings.step}};
  for (const auto& [setting, value] : all) {
    const std::string option = setting.id.substr(setting.id.find('.') + 1);
    if (!arguments.has(option)) continue;
    if (!readNumber(arguments.valueOf(option), *value) || !checkValue(setting, *value))
      return "The option --" + option + " takes a number from " + textOf(setting, setting.least) + " to " +
             textOf(setting, setting.largest) + " " + setting.unit + ".";
  }
  return {};
}

OptionSpec resolutionOption() {
  return {"resolution", 0, "MM",
          "Resolution of the check: what exceeds the clearance by less counts as a collision (default 0.05)"};
}

nlohmann::json pathFile(const CellScene& scene, const RobotPath& path, const CheckedPath& checked) {
  const RobotModel& robot = scene.robot->model;
  nlohmann::json file = toJson(robot, path);
  file["robot"] = robot.name;
  file["certified"] = checked.isCertified();
  file["joints"] = nlohmann::json::array();
  for (const std::uint32_t dof : scene.dofs) file["joints"].push_back(robot.jointOfDof(dof).name);
  file["waypoints"] = nlohmann::json::array();
  for (const Waypoint& waypoint : path.waypoints) {
    const ArmValues values = scene.planned(waypoint.joints);
    file["waypoints"].push_back(std::vector<double>(values.begin(), values.end()));
  }
  return file;
}

Result<RobotPath> pathCalled(const CellScene& scene, const RobotCellSnapshot& cell, const std::string& name,
                             CellPlans& plans, std::vector<std::string>& remarks) {
  if (const RobotPath* path = cell.plans->path(name)) return *path;
  std::error_code ignored;
  if (!std::filesystem::exists(name, ignored)) return Error{CellError::PathMissing, {name}, {}, {}};
  Result<ProgramPath> read = pathFromFile(scene, cell, name);
  if (!read) return read.error();
  if (read->otherTool && read->isOnlyTool) {
    plans.tool = *read->otherTool;
    const Vec3 at = plans.tool.translation();
    remarks.push_back("The tool centre point is that of the program, " + roundedText(at.x(), 6) + ", " +
                      roundedText(at.y(), 6) + ", " + roundedText(at.z(), 6) + " mm, and not that of the cell.");
    read->otherTool.reset();
  }
  for (const QString& remark : programRemarks(*read, cell.plans->tool)) remarks.push_back(remark.toStdString());
  return std::move(read->path);
}

std::string readChoices(const Arguments& arguments, ProgramChoices& choices) {
  choices.cornersAsStops = arguments.has("cnt-as-fine");
  choices.withoutLines = arguments.has("without-io");
  choices.keepsCarried = arguments.has("carried");
  const bool isSound = !choices.keepsCarried || arguments.valueOf("carried") == "same";
  return isSound ? std::string() : "The option --carried takes 'same'.";
}

std::vector<OptionSpec> programChoiceOptions(bool isExport) {
  std::vector<OptionSpec> options;
  options.push_back({"carried", 0, "same",
                     "After lines that may grip or release, the robot carries what it carried before (default: the "
                     "proof ends there)"});
  options.push_back({"cnt-as-fine", 0, "", "The robot stops exactly where a Fanuc program rounds corners (CNT)"});
  if (isExport)
    options.push_back({"without-io", 0, "",
                       "Leave out the lines of the opened program that are not interpreted, as outputs and waiting"});
  return options;
}

void warnOfProgram(const std::vector<std::string>& remarks) {
  for (const std::string& remark : remarks) complain("warning: " + remark);
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/IkCommand.h"

#include "base/NumberText.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/ReportJson.h"
#include "cli/cell/CellFile.h"
#include "document/Container.h"
#include "document/FileBytes.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellErrors.h"
#include "robot/UrdfReader.h"
#include "robot/arm/ClosedFormIk.h"
#include "robot/arm/IkFidelity.h"
#include "robot/arm/NumericalIk.h"
#include "robot/dh/DhTable.h"

#include <QtGlobal>
#include <algorithm>
#include <filesystem>

namespace handwheel {

namespace {

constexpr double kFurthest = 1e9;  // mm

const Operation& ikOperation() {
  static const Operation kOperation = {
      .id = "ik",
      .title = QT_TRANSLATE_NOOP("Tool", "Inverse kinematics"),
      .meaning = "Finds joint values for a pose of a robot's flange",
      .parameters = {
          {.property = {.id = "pose", .group = {}, .label = {}, .value = "", .least = -kFurthest, .largest = kFurthest},
           .meaning = "Pose in the base frame: position in mm, and quaternion with its real part first",
           .word = "X,Y,Z,QW,QX,QY,QZ",
           .parts = {{"x"}, {"y"}, {"z"}, {"qw"}, {"qx"}, {"qy"}, {"qz"}},
           .hasDefault = false},
          {.property = {.id = "arm", .group = {}, .label = {}, .value = ""},
           .meaning = "Robot of a cell with several; the pose is in the frame of the cell",
           .word = "NAME",
           .hasDefault = false},
          {.property = {.id = "tip", .group = {}, .label = {}, .value = ""},
           .meaning = "Link of a URDF or cell that takes the pose; default: the last one",
           .word = "LINK",
           .hasDefault = false},
          {.property = {.id = "all", .group = {}, .label = {}, .value = false},
           .meaning = "List all solutions, where they are known in closed form"},
          {.property = {.id = "place", .group = {}, .label = {}, .value = false},
           .meaning = "Where the pose cannot be reached, reach its place, turned as near to it as possible: for arms "
                      "with fewer than six joints"},
          measuredParameter("tolerance", ikToleranceSetting(), "T",
                            "Tolerance of the iterative solution, in metres and rad"),
          {.property = {.id = "seed", .group = {}, .label = {}, .value = 1.0, .least = 0.0, .largest = 1e9},
           .meaning = "Seed of the random starts of the iterative solution",
           .word = "N",
           .isWhole = true}}};
  return kOperation;
}

Error withSubject(Error error, const std::string& subject) {
  error.subject = subject;
  return error;
}

// From the root of a robot to a link, or to its last one.
Result<SerialArm> armTo(const RobotModel& robot, const std::string& tip, std::uint32_t last,
                        const std::string& subject) {
  const std::uint32_t link = tip.empty() ? last : linkNamed(robot, tip);
  if (link == kNone) return Error{ErrorCode::ReferenceMissing, {"link", tip, {}}, {}, subject};
  const auto arm = SerialArm::of(robot, robot.root, link);
  return arm ? Result<SerialArm>(arm->arm) : withSubject(arm.error(), subject);
}

// The arm of a cell ends at its tool centre point, unless another link is named.
Result<SerialArm> armOfCell(const Arguments& arguments, const std::string& tip, const DocumentKinds& kinds) {
  const std::string& name = arguments.operands[0];
  const Result<CellFile> file = openCellForArm(arguments, kinds);
  if (!file) return file.error();
  const CellRobot& robot = *file->cell->robot;
  const RobotArm& active = activeArm(robot, *file->cell->plans);
  const Result<SerialArm> arm = armTo(robot.model, tip, active.flange, name);
  if (!arm || !tip.empty()) return arm;
  return arm->withTool(file->cell->plans->tool).withCoupling(couplingOf(active, *arm));
}

// A robot by its built-in name, a table in JSON, a URDF or a cell.
Result<SerialArm> armCalled(const Arguments& arguments, const std::string& tip, const DocumentKinds& kinds) {
  const std::string& name = arguments.operands[0];
  const auto ofTable = [](const DhTable& table) {
    return armOf(std::vector<DhRow>(table.joints.begin(), table.joints.end()));
  };
  if (const DhTable* const table = libraryTable(name))
    return ofTable(*table).withCoupling(libraryRobot(table->name)->coupling);
  std::error_code ignored;
  if (!std::filesystem::exists(name, ignored)) return Error{CellError::RobotUnknown, {name}, {}, {}};
  const Result<std::string> bytes = readFileBytes(name);
  if (!bytes) return withSubject(bytes.error(), name);
  if (looksLikeContainer(*bytes)) return armOfCell(arguments, tip, kinds);
  if (looksLikeUrdf(*bytes)) {
    const Result<ImportedRobot> read = readUrdf(*bytes);
    return read ? armTo(read->robot, tip, toolLink(read->robot), name) : withSubject(read.error(), name);
  }
  const std::size_t begin = bytes->find_first_not_of(" \t\r\n");
  const bool isJson = begin != bytes->npos && (*bytes)[begin] == '{';
  if (!isJson) return Error{CellError::RobotUnknown, {name}, {}, {}};
  const Result<DhTable> table = readDhTable(*bytes);
  return table ? Result<SerialArm>(ofTable(*table)) : withSubject(table.error(), name);
}

// False also where there is no such file, which is an error of its own.
bool isRobotOutsideOfCells(const std::string& name) {
  if (libraryTable(name)) return true;
  const Result<std::string> bytes = readFileBytes(name);
  return bytes && !looksLikeContainer(*bytes);
}

struct FoundValues {
  ArmValues values;
  double distance = 0.0, angle = 0.0;  // mm, rad: that the flange is off
};

FoundValues measured(const SerialArm& arm, const Pose& pose, const ArmValues& values) {
  const auto error = poseError(arm.tipPose(values), pose);
  return {values, error.head<3>().norm(), error.tail<3>().norm()};
}

// The nearest to the middle of the joints first.
std::vector<FoundValues> solutionsFor(const SerialArm& arm, const Pose& pose, const OperationValues& values) {
  const ArmValues middle = arm.middle();
  std::vector<FoundValues> found;
  if (const auto closed = ClosedFormIk::of(arm)) {
    IkSolutions solutions;
    closed->solve(pose, middle, solutions);
    // If an axis of the wrist, or the elbow, is in line, two solutions coincide.
    const auto isKnown = [&](const ArmValues& same) {
      return std::any_of(found.begin(), found.end(),
                         [&](const FoundValues& each) { return (each.values - same).norm() < 1e-6; });
    };
    for (const auto& solution : solutions) {
      const auto within = withinLimits(arm, solution.values, middle);
      if (within && !isKnown(*within)) found.push_back(measured(arm, pose, *within));
    }
    std::sort(found.begin(), found.end(), [&](const FoundValues& a, const FoundValues& b) {
      return (a.values - middle).squaredNorm() < (b.values - middle).squaredNorm();
    });
    if (!values.flag("all") && found.size() > 1) found.resize(1);
    return found;
  }
  NumericalIkSettings settings;
  settings.tolerance = values.number("tolerance");
  settings.seconds = 1.0;
  settings.seed = values.whole("seed");
  NumericalIkResult result = solvedNumerically(arm, pose, middle, settings);
  if (!result.isSolved && values.flag("place")) result = solvedForPosition(arm, pose, middle, settings);
  if (result.isSolved) found.push_back(measured(arm, pose, result.values));
  return found;
}

std::string ikReport(const std::vector<FoundValues>& found, bool asJson) {
  if (asJson) {
    nlohmann::json solutions = nlohmann::json::array();
    for (const FoundValues& each : found) {
      solutions.push_back({{"q", std::vector<double>(each.values.begin(), each.values.end())},
                           {"error_mm", each.distance},
                           {"error_rad", each.angle}});
    }
    return textOf({{"solved", !found.empty()}, {"solutions", solutions}});
  }
  if (found.empty()) return "The pose cannot be reached within the limits of the joints.\n";
  std::string text;
  for (const FoundValues& each : found) {
    for (const double q : each.values) text += roundedText(q, 9) + " ";
    text += "rad, off by " + roundedText(each.distance, 3) + " mm and " + roundedText(each.angle, 3) + " rad\n";
  }
  return text;
}

int runIk(const Arguments& arguments, const DocumentKinds& kinds) {
  OperationValues values(ikOperation());
  if (const std::string problem = readOptions(arguments, values); !problem.empty()) return failUsage(problem, "ik");
  if (!values.isSet("pose")) return failUsage("The option --pose=X,Y,Z,QW,QX,QY,QZ is missing.", "ik");
  const std::vector<double> numbers = values.numbers("pose");
  const Eigen::Quaterniond turn(numbers[3], numbers[4], numbers[5], numbers[6]);
  if (!(turn.norm() > 1e-6)) return failUsage("The quaternion of --pose is zero.", "ik");
  Pose pose(turn.normalized());
  pose.translation() = Vec3(numbers[0], numbers[1], numbers[2]);
  const std::string& robot = arguments.operands[0];
  if (arguments.has("arm") && isRobotOutsideOfCells(robot))
    return failUsage("The option --arm is for robot cells, and " + robot + " is none.", "ik");
  const std::string tip = values.isSet("tip") ? values.text("tip") : std::string();
  const Result<SerialArm> arm = armCalled(arguments, tip, kinds);
  if (!arm) return fail(arm.error());
  const std::vector<FoundValues> found = solutionsFor(*arm, pose, values);
  const int printed = print(ikReport(found, arguments.has("json")));
  return printed != kExitDone ? printed : found.empty() ? kExitSomethingLeft : kExitDone;
}

}  // namespace

Command ikCommand() {
  CommandSpec spec = {
      ikOperation().id,
      "ROBOT",
      "Finds joint values for a pose of a robot's flange, in the frame of its base.\n"
      "ROBOT is a URDF, a table after Denavit and Hartenberg (docs/robots.md), a robot cell, or a built-in\n"
      "name: irb120, irb140, irb1600, irb2400, irb6640, kr6r900, kr6r700, lrmate200id, ur5, ur10, rx160, tx90,\n"
      "tx40, puma560. Of a cell it is the pose of the tool's centre point. Exit code 2: the pose cannot be\n"
      "reached within the limits.",
      {}};
  spec.options = optionsOf(ikOperation());
  spec.options.push_back({"json", 0, "", "Report as JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return {std::move(spec), runIk};
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/RobotCommand.h"

#include "base/NumberText.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/ReportJson.h"
#include "cli/cell/CellFile.h"
#include "document/cell/RobotCellKind.h"
#include "tools/cell/RobotOperation.h"

namespace handwheel {

namespace {

std::string robotsReport(const nlohmann::json& robots, bool asJson) {
  if (asJson) return textOf({{"robots", robots}});
  std::string text;
  for (const nlohmann::json& robot : robots) {
    text += robot["name"].get<std::string>() + ": " + robot["title"].get<std::string>() + ", at";
    for (const nlohmann::json& number : robot["position"]) text += " " + roundedText(number.get<double>(), 6);
    text += robot["planned"].get<bool>() ? " mm, planned for\n" : " mm\n";
  }
  return text;
}

int runRobot(const Arguments& arguments, const DocumentKinds& kinds) {
  OperationValues values(robotOperation());
  const std::string& id = robotOperation().id;
  if (const std::string problem = readOptions(arguments, values); !problem.empty()) return failUsage(problem, id);
  if (const std::string problem = problemOfRobotValues(values); !problem.empty())
    return failUsage(sentenceOf(problem), id);
  if (!arguments.has("output")) return failUsage("The option -o OUT is missing.", id);
  const Result<CellFile> file = openCell(arguments.operands[0], kinds);
  if (!file) return fail(file.error());
  std::shared_ptr<const RobotCellSnapshot> added;
  if (values.isSet("add")) {
    const Result<CellFile> other = openCell(values.text("add"), kinds);
    if (!other) return fail(other.error());
    if (other->opened.file.isContainer)
      return fail({ErrorCode::Unsupported, {"a saved document as a robot"}, {}, values.text("add")});
    added = other->cell;
  }
  const Result<RobotCellSnapshot> changed = withRobotsChanged(values, *file->cell, added);
  if (!changed) return fail(changed.error());
  if (const int code = saveCell(*file, *changed, arguments.valueOf("output")); code != kExitDone) return code;
  return print(robotsReport(describeRobots(*changed), arguments.has("json")));
}

}  // namespace

Command robotCommand() {
  CommandSpec spec = {
      robotOperation().id,
      "CELL",
      "Adds a robot to a cell, removes one, or chooses the one to plan for.\n"
      "The position of a further robot is set by properties: handwheel set CELL robot.NAME.x=800 -o OUT.",
      {}};
  spec.options = optionsOf(robotOperation());
  spec.options.push_back({"output", 'o', "OUT", "The document to write, .handwheel; may be CELL"});
  spec.options.push_back({"json", 0, "", "Report as JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return {std::move(spec), runRobot};
}

}  // namespace handwheel

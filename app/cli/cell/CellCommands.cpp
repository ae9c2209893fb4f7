// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/CellCommands.h"

#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/OperationJson.h"
#include "cli/OperationOptions.h"
#include "cli/ReportJson.h"
#include "cli/cell/ConfigurationCommand.h"
#include "cli/cell/IkCommand.h"
#include "cli/cell/OptimiseCommand.h"
#include "cli/cell/PlanCommand.h"
#include "cli/cell/PlanningBenchmark.h"
#include "cli/cell/PostCommand.h"
#include "cli/cell/ProcessCommand.h"
#include "cli/cell/ProximityCommand.h"
#include "cli/cell/RobotCommand.h"
#include "cli/cell/TeleopCommand.h"
#include "cli/cell/VerifyCommand.h"
#include "document/Document.h"
#include "document/scene/BodyDescription.h"
#include "document/scene/BodyOwner.h"
#include "text/NoteText.h"
#include "tools/scene/BodyOperation.h"

#include <optional>

namespace handwheel {

namespace {

std::string bodyReport(const OperationValues& values, const BodySet& bodies, bool asJson) {
  const nlohmann::json described = describeBodies(bodies);
  if (asJson) return textOf({{"options", toJson(values)}, {"bodies", described}});
  std::string text;
  for (const nlohmann::json& body : described) {
    text += std::to_string(body["id"].get<BodyId>()) + ": " + body["name"].get<std::string>() + ", " +
            body["shape"].get<std::string>();
    if (!body["link"].is_null()) text += ", linked: " + body["link"]["state"].get<std::string>();
    text += "\n";
  }
  return text;
}

// Changes, writes and reports. The document is made anew on this thread.
int changeAndSave(OpenedFile opened, const OperationValues& values, const Arguments& arguments,
                  const DocumentKinds& kinds) {
  const std::filesystem::path output = arguments.valueOf("output");
  if (const std::string refusal = refusalToReplace(output, opened.file); !refusal.empty()) return refuse(refusal);
  const DocumentKind& kind = *opened.kind;
  const std::unique_ptr<Document> document = kind.make(std::move(opened));
  const auto* owner = dynamic_cast<const BodyOwner*>(document.get());
  if (!owner) return refuse(arguments.operands[0] + " contains no bodies: only robot cells do.");
  std::error_code ignored;
  const std::filesystem::path& holder = values.isSet("add") ? output : std::filesystem::path(arguments.operands[0]);
  const std::filesystem::path folder = std::filesystem::absolute(holder, ignored).parent_path();
  std::optional<Result<BodyChange>> change;
  runInterruptible("Reading", [&, bodies = owner->bodies()](CommandJob& job) {
    change = bodyChange(values, bodies, kinds, folder, job.progress());
  });
  if (!*change) return fail(change->error());
  reportLosses(change->value().file);
  if (change->value().edit) document->commit({}, std::move(change->value().edit));
  std::optional<Result<WrittenFile>> written;
  runInterruptible("Writing", [&, content = document->snapshot()](CommandJob& job) {
    written = saveDocument(kind, document->file(), *content, output, job.progress());
  });
  if (!*written) return fail(written->error());
  for (const Note& note : written->value().notes) complain(noteText(note).toStdString());
  return print(bodyReport(values, owner->bodies(), arguments.has("json")));
}

int runBody(const Arguments& arguments, const DocumentKinds& kinds) {
  OperationValues values(bodyOperation());
  if (const std::string problem = readOptions(arguments, values); !problem.empty()) return failUsage(problem, "body");
  if (const std::string problem = problemOfBodyValues(values); !problem.empty())
    return failUsage(sentenceOf(problem), "body");
  if (!arguments.has("output")) return failUsage("The option -o OUT is missing.", "body");
  std::optional<Result<OpenedFile>> opened;
  runInterruptible("Reading", [&](CommandJob& job) { opened = kinds.open(arguments.operands[0], {}, job.progress()); });
  if (!*opened) return fail(opened->error());
  reportLosses(opened->value().file);
  return changeAndSave(std::move(opened->value()), values, arguments, kinds);
}

}  // namespace

std::vector<Command> cellCommands() {
  CommandSpec spec = {bodyOperation().id,
                      "IN",
                      "Changes the bodies beside the robot of a cell: adds one, removes it, or reads its file again.\n"
                      "Name, position and appearance of a body are properties: handwheel set IN body.1.x=100 -o OUT.",
                      {}};
  spec.options = optionsOf(bodyOperation());
  spec.options.push_back({"output", 'o', "OUT", "The document to write, .handwheel or an export; may be IN"});
  spec.options.push_back({"json", 0, "", "Report as JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return {{std::move(spec), runBody}, configurationCommand(), ikCommand(),    planCommand(),
          processCommand(),           verifyCommand(),        postCommand(),  teleopCommand(),
          planningBenchmarkCommand(), optimiseCommand(),      robotCommand(), proximityCommand()};
}

}  // namespace handwheel

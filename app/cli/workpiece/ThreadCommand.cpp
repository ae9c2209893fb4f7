// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/ThreadCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "document/workpiece/ThreadReport.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/exercise/AssignedTask.h"
#include "machining/TurningFidelity.h"
#include "text/NoteText.h"
#include "tools/workpiece/ThreadOperation.h"

#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

struct ThreadedWork {
  WorkpieceSnapshot workpiece;
  WrittenFile written;
};

Result<ThreadedWork> cutThread(const OpenedFile& file, const WorkpieceSnapshot& given, const OperationValues& values,
                               const std::filesystem::path& output, Progress progress) {
  Result<TurningPass> pass = threadPass(given, values);
  if (!pass) return pass.error();
  ThreadedWork done{given, {}};
  done.workpiece.part =
      withPass(given, std::move(pass.value()), turnSpacingSetting().standard, progress.part(0.0, 0.5));
  if (!done.workpiece.part) return Error{ErrorCode::Cancelled, {}, {}, {}};
  Result<WrittenFile> written = saveDocument(*file.kind, file.file, done.workpiece, output, progress.part(0.5, 1.0));
  if (!written) return written.error();
  done.written = std::move(*written);
  return done;
}

std::string threadReport(const TurnedPart& part, double position, bool asJson) {
  if (asJson)
    return nlohmann::ordered_json{{"threads", threadsJson(part, position)}, {"volume_mm3", part.volume()}}.dump(2) +
           "\n";
  return "Threads: " + threadsText(part, position) + ". Volume: " + roundedText(part.volume()) + " mm³.\n";
}

int runThread(const Arguments& arguments, const DocumentKinds& kinds) {
  OperationValues values(threadOperation());
  if (const std::string problem = readOptions(arguments, values); !problem.empty()) return failUsage(problem, "thread");
  const std::filesystem::path output = arguments.valueOf("output");
  if (output.empty()) return failUsage("The option --output is missing.", "thread");
  std::optional<Result<OpenedFile>> opened;
  runInterruptible("Reading", [&](CommandJob& job) { opened = kinds.open(arguments.operands[0], {}, job.progress()); });
  if (!*opened) return fail(opened->error());
  const OpenedFile& file = opened->value();
  const auto* const given = dynamic_cast<const WorkpieceSnapshot*>(file.content.get());
  if (!given) return refuse(arguments.operands[0] + " is not a workpiece.");
  reportLosses(file.file);
  if (const auto task = assignedTask(file.file.assigned); task && !task->areCommandsAllowed)
    return refuse(arguments.operands[0] +
                  ": the exercise does not allow a command to cut the thread. Cut it on the lathe, or let the teacher "
                  "allow commands.");
  if (const std::string refusal = refusalToReplace(output, file.file); !refusal.empty()) return refuse(refusal);
  std::optional<Result<ThreadedWork>> done;
  runInterruptible("Threading",
                   [&](CommandJob& job) { done = cutThread(file, *given, values, output, job.progress()); });
  if (!*done) return fail(done->error());
  const ThreadedWork& work = done->value();
  for (const Note& note : work.written.notes) complain(noteText(note).toStdString());
  return print(threadReport(*work.workpiece.part, work.workpiece.stock.position, arguments.has("json")));
}

}  // namespace

Command threadCommand() {
  CommandSpec spec = {threadOperation().id,
                      "WORK",
                      "Cuts a thread into a workpiece, by the ISO metric profile unless a depth is given. Its surface\n"
                      "must have been turned to the major diameter, or bored to the minor one, before. STL and OBJ\n"
                      "files have the groove as triangles, STEP files the envelope without it.",
                      {}};
  spec.options = optionsOf(threadOperation());
  spec.options.push_back({"output", 'o', "OUT", "The document to write, .handwheel or an export such as .stl"});
  spec.options.push_back({"json", 0, "", "Report as JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return {std::move(spec), runThread};
}

}  // namespace handwheel

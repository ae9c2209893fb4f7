// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/RecordingCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "document/RecordingExport.h"

#include <algorithm>
#include <optional>

namespace handwheel {

namespace {

// Returns "Recording 1: 12.5 s, 12501 samples, 3 missing, Novint Falcon".
std::string lineFor(const StoredRecording& recording) {
  std::string line = recording.name + ": " + roundedText(recording.ticks.duration()) + " s, " +
                     std::to_string(recording.ticks.size()) + (recording.ticks.size() == 1 ? " sample" : " samples");
  if (recording.ticks.missing() > 0) line += ", " + std::to_string(recording.ticks.missing()) + " missing";
  if (!recording.device.empty()) line += ", " + recording.device;
  return line + "\n";
}

int list(const std::vector<StoredRecording>& recordings) {
  std::string text;
  for (const StoredRecording& each : recordings) text += lineFor(each);
  return print(text.empty() ? "There are no recordings.\n" : text);
}

// Returns the recording of that name, or the only one; otherwise null, and the reason as a sentence.
const StoredRecording* chosen(const std::vector<StoredRecording>& all, const Arguments& arguments,
                              std::string& problem) {
  if (!arguments.has("name")) {
    if (all.size() == 1) return &all.front();
    problem = all.empty() ? "There are no recordings in " + arguments.operands[0] + "."
                          : "There are several recordings; choose one with --name.";
    return nullptr;
  }
  const std::string name = arguments.valueOf("name");
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
  if (found != all.end()) return &*found;
  problem = "There is no recording '" + name + "' in " + arguments.operands[0] + ".";
  return nullptr;
}

int write(const StoredRecording& recording, const std::string& output) {
  std::optional<Status> written;
  runInterruptible("Writing",
                   [&](CommandJob& job) { written = exportRecording(recording.ticks, output, job.progress()); });
  return *written ? kExitDone : fail(written->error());
}

}  // namespace

CommandSpec recordingSpec() {
  return {
      "recording",
      "FILE",
      "Writes a recording of a haptic device as a table (CSV). Without --out it lists the recordings of the document.",
      {
          {"out", 'o', "CSV", "The table: time, tip, proxy and force in each tick (s, mm, N)"},
          {"name", 0, "NAME", "Which recording, where there are several"},
          {"help", 'h', "", "Show this help"},
      }};
}

int runRecording(const Arguments& arguments, const DocumentKinds& kinds) {
  std::optional<Result<OpenedFile>> opened;
  runInterruptible("Reading", [&](CommandJob& job) { opened = kinds.open(arguments.operands[0], {}, job.progress()); });
  if (!*opened) return fail(opened->error());
  reportLosses(opened->value().file);
  const std::vector<StoredRecording>& all = opened->value().file.recordings;
  if (!arguments.has("out")) return list(all);
  if (isSameFile(arguments.valueOf("out"), arguments.operands[0])) return refuse("OUT is the document itself.");
  std::string problem;
  const StoredRecording* const recording = chosen(all, arguments, problem);
  return recording ? write(*recording, arguments.valueOf("out")) : refuse(problem);
}

}  // namespace handwheel

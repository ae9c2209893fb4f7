// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/InspectCommand.h"

#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/ReportJson.h"
#include "cli/ReportText.h"
#include "cli/Wording.h"
#include "document/formats/MeshFormat.h"

namespace handwheel {

CommandSpec inspectSpec() {
  return {"inspect",
          "IN",
          "Says what a mesh file holds and what is wrong with it.",
          {
              {"json", 0, "", "Print the figures as JSON"},
              {"partial", 0, "", "Read what is readable of a damaged file"},
              {"help", 'h', "", "Show this page"},
          }};
}

int runInspect(const Arguments& arguments) {
  std::vector<std::string> notes;
  std::optional<Error> failure;
  MeshReport report;
  runInterruptible("Inspecting", [&](Job& job) {
    const Progress progress = job.progress();
    const ReadOptions options{.partial = arguments.has("partial")};
    const Result<MeshFile> file = readMeshFile(arguments.operands[0], options, progress.part(0.0, 0.3));
    if (!file) {
      failure = file.error();
      return;
    }
    notes = damageSentences(file->damage, file->unlistedDamage);
    report = reportOn(file->soup, SelfIntersections::Count, progress.part(0.3, 1.0));
  });
  if (wasInterrupted()) return fail({ErrorCode::Cancelled, {}, {}, {}});
  if (failure) return fail(*failure);
  for (const std::string& note : notes) complain(note);
  return print(arguments.has("json") ? textOf(toJson(report)) : readableText(report));
}

}  // namespace handwheel

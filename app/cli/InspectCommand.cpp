// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/InspectCommand.h"

#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/PropertyText.h"
#include "cli/ReportJson.h"
#include "cli/ReportText.h"
#include "document/Document.h"

namespace handwheel {

CommandSpec inspectSpec() {
  return {"inspect",
          "IN",
          "Says what a file holds and what is wrong with it.",
          {
              {"json", 0, "", "Print the figures as JSON"},
              {"partial", 0, "", "Read what is readable of a damaged file"},
              {"help", 'h', "", "Show this page"},
          }};
}

namespace {

// "diameter: 50 mm", a line for each property.
std::string readableText(const OpenedFile& opened) {
  std::string text = opened.kind->id() + "\n";
  const std::unique_ptr<Document> document = opened.kind->make(opened);
  for (const Property& property : document->properties()) {
    text += "  " + property.id + ": " + propertyText(property);
    if (!property.problem.empty()) text += " (" + property.problem + ")";
    text += "\n";
  }
  return text;
}

nlohmann::ordered_json toJson(const OpenedFile& opened) {
  return {{"kind", opened.kind->id()}, {"id", opened.file.id}, {"document", opened.kind->describe(*opened.content)}};
}

struct Inspected {
  Input input;
  MeshReport report;
};

Result<Inspected> inspect(const Arguments& arguments, const DocumentKinds& kinds, Progress progress) {
  Result<Input> input =
      readInput(arguments.operands[0], {.partial = arguments.has("partial")}, kinds, progress.part(0.0, 0.3));
  if (!input) return input.error();
  Inspected result{std::move(input.value()), {}};
  if (result.input.mesh) {
    result.report = reportOn(result.input.mesh->soup, SelfIntersections::Count, progress.part(0.3, 1.0));
  }
  return result;
}

}  // namespace

int runInspect(const Arguments& arguments, const DocumentKinds& kinds) {
  std::optional<Result<Inspected>> result;
  runInterruptible("Inspecting", [&](Job& job) { result = inspect(arguments, kinds, job.progress()); });
  if (wasInterrupted()) return fail({ErrorCode::Cancelled, {}, {}, {}});
  if (!*result) return fail(result->error());
  const Inspected& found = result->value();
  const bool json = arguments.has("json");
  if (found.input.mesh) {
    tellLosses(found.input.mesh->damage, found.input.mesh->unlistedDamage, {});
    return print(json ? textOf(handwheel::toJson(found.report)) : handwheel::readableText(found.report));
  }
  const OpenedFile& document = found.input.document;
  tellLosses(document.file.damage, document.file.unlistedDamage, document.file.lost);
  return print(json ? textOf(toJson(document)) : readableText(document));
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/SetCommand.h"

#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/PropertyText.h"
#include "document/Document.h"
#include "text/NoteText.h"

#include <optional>
#include <span>

namespace handwheel {

namespace {

// Applies one "name=value", and complains about a problem of the new value. Returns the error, or nothing.
std::string assign(Document& document, const std::string& word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos) return "NAME=VALUE was expected, not '" + word + "'.";
  const std::string name = word.substr(0, equals);
  const std::optional<Property> property = document.property(name);
  if (!property) return "There is no property '" + name + "'; 'handwheel inspect' lists them.";
  const auto value = propertyValue(*property, word.substr(equals + 1));
  if (const auto* problem = std::get_if<std::string>(&value)) return *problem;
  if (!property->editable) {
    const auto edit = document.propertyEdit(property->id, std::get<PropertyValue>(value));
    const bool saysWhy = !edit && edit.error().code != ErrorCode::ReferenceMissing;
    return saysWhy ? sentenceFor(edit.error()) : "The property " + name + " depends on others and cannot be set.";
  }
  const Status done = document.setProperty(property->id, std::get<PropertyValue>(value));
  if (!done) return sentenceFor(done.error());
  const std::optional<Property> now = document.property(name);
  if (now && !now->problem.empty()) complain(name + ": " + now->problem + ".");
  return {};
}

// Changes and writes the document, which is created again on this thread; saving may be interrupted.
int assignAndSave(OpenedFile opened, std::span<const std::string> words, const std::string& output) {
  if (const std::string refusal = refusalToReplace(output, opened.file); !refusal.empty()) return refuse(refusal);
  const DocumentKind& kind = *opened.kind;
  const std::unique_ptr<Document> document = kind.make(std::move(opened));
  for (const std::string& word : words) {
    if (const std::string problem = assign(*document, word); !problem.empty()) return refuse(problem);
  }
  std::optional<Result<WrittenFile>> written;
  runInterruptible("Writing", [&, content = document->snapshot()](CommandJob& job) {
    written = saveDocument(kind, document->file(), *content, output, job.progress());
  });
  if (!*written) return fail(written->error());
  for (const Note& note : written->value().notes) complain(noteText(note).toStdString());
  return kExitDone;
}

// Returns the kinds of which new documents can be made: "workpiece".
std::string kindsToMake(const DocumentKinds& kinds) {
  std::string all;
  for (const auto& kind : kinds.all()) {
    if (kind->blank()) all += (all.empty() ? "" : " or ") + kind->id();
  }
  return all;
}

const std::vector<OptionSpec> kOptions = {
    {"output", 'o', "OUT", "The document to write, .handwheel or an export"},
    {"help", 'h', "", "Show this help"},
};

}  // namespace

CommandSpec newSpec() {
  return {"new", "KIND [NAME=VALUE...]", "Creates a document of default size. Properties are given as for 'set'.",
          kOptions};
}

std::string newDetails(const DocumentKinds& kinds) {
  return "KIND is " + kindsToMake(kinds) + ".\n";
}

CommandSpec setSpec() {
  return {"set", "IN [NAME=VALUE...]",
          "Changes properties of a document. Examples: diameter=25.4/2, joint.joint_1=30deg,\n"
          "body.Table.x=100; 'handwheel inspect IN' lists them.\n"
          "OUT can be IN, unless IN is damaged or of a newer version.",
          kOptions};
}

int runNew(const Arguments& arguments, const DocumentKinds& kinds) {
  if (!arguments.has("output")) return failUsage("The option -o OUT is missing.", "new");
  const DocumentKind* kind = kinds.withId(arguments.operands[0]);
  if (!kind || !kind->blank())
    return failUsage("KIND is " + kindsToMake(kinds) + ", not '" + arguments.operands[0] + "'.", "new");
  return assignAndSave(DocumentKinds::blank(*kind), std::span(arguments.operands).subspan(1),
                       arguments.valueOf("output"));
}

int runSet(const Arguments& arguments, const DocumentKinds& kinds) {
  if (!arguments.has("output")) return failUsage("The option -o OUT is missing.", "set");
  std::optional<Result<OpenedFile>> opened;
  runInterruptible("Reading", [&](CommandJob& job) { opened = kinds.open(arguments.operands[0], {}, job.progress()); });
  if (!*opened) return fail(opened->error());
  reportLosses(opened->value().file);
  return assignAndSave(std::move(opened->value()), std::span(arguments.operands).subspan(1),
                       arguments.valueOf("output"));
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/EditCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/mesh/MeshOutput.h"
#include "document/FileBytes.h"
#include "document/formats/MeshExport.h"
#include "document/mesh/MeshDocument.h"
#include "document/mesh/MeshKind.h"
#include "mesh/search/LocalIntersections.h"
#include "mesh/structure/MeshErrors.h"
#include "text/NoteText.h"
#include "text/RepairText.h"
#include "tools/mesh/MeshScript.h"
#include "tools/mesh/ScriptErrors.h"
#include "tools/mesh/operations/MeshOperations.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr std::size_t kLongestQuote = 60;  // characters of a step that a message repeats

// With where it stands, for messages.
struct Step {
  std::string text;
  std::string subject;
  InputPosition position;
};

struct Edited {
  DocumentFile file;  // losses of reading
  std::size_t facesBefore = 0;
  std::size_t facesAfter = 0;
  std::vector<std::string> idle;     // sentences on steps that changed nothing, or not all that they were to
  std::vector<std::string> reached;  // lines on what steps have reached
  std::vector<Note> notes;
  std::string refusal;  // the reason why nothing was written
};

std::string quoted(const std::string& step) {
  return "'" + (step.size() > kLongestQuote ? step.substr(0, kLongestQuote) + "..." : step) + "'";
}

// One step a line; blank ones and those that begin with # say nothing.
void addSteps(std::string_view text, const std::string& path, std::vector<Step>& steps) {
  for (std::uint64_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view step = text.substr(0, end);
    const std::size_t first = step.find_first_not_of(" \t\r");
    if (first != std::string_view::npos && step[first] != '#')
      steps.push_back({std::string(step), path, InputPosition::line(line)});
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

Result<std::vector<Step>> readSteps(const Arguments& arguments) {
  std::vector<Step> steps;
  for (const std::string& path : arguments.valuesOf("steps")) {
    const Result<std::string> text = readFileBytes(path);
    if (!text) return text.error();
    addSteps(*text, path, steps);
  }
  for (std::size_t i = 1; i < arguments.operands.size(); ++i) {
    const std::string& text = arguments.operands[i];
    steps.push_back({text, "Step " + std::to_string(i) + ", " + quoted(text), {}});
  }
  return steps;
}

std::string idleSentence(const Step& step, const ScriptLineOutcome& outcome) {
  std::string sentence = step.subject;
  if (step.position.kind == InputPosition::Kind::Line) sentence += ", line " + std::to_string(step.position.value);
  if (outcome.changed) return sentence + ": " + sheetsText(outcome.sheets, LengthUnit::Millimetre).toStdString() + ".";
  sentence += " changed nothing";
  if (outcome.failure != FillFailure::None) {
    sentence += ": " + fillFailureReason(outcome.failure).toStdString();
  } else if (outcome.error) {
    sentence += ": " + fullSentenceFor(*outcome.error);
  } else if (outcome.reason) {
    sentence += std::string(": ") + outcome.reason;
  }
  return sentence.ends_with('.') ? sentence : sentence + ".";
}

// A thickness that is not reached everywhere, or a distance; empty for other steps.
std::string reachedLine(const Step& step, const ScriptLineOutcome& outcome) {
  if (outcome.distance)
    return step.subject + ": largest distance found between the surface before and after " +
           roundedText(*outcome.distance) + " mm.\n";
  if (outcome.sheets.leftCount() > 0 || outcome.sheets.thickness.thinVertices == 0) return {};
  return step.subject + ": " + sheetsText(outcome.sheets, LengthUnit::Millimetre).toStdString() + ".\n";
}

// Says which self-intersections a step has made; empty if none. A pose makes none.
std::string crossingsLine(const Step& step, const HalfEdgeMesh& before, const HalfEdgeMesh& after, Progress progress) {
  if (step.text.starts_with("place")) return {};
  const auto change = intersectionsChange(before, after, progress);
  if (!change || change->fresh == 0) return {};
  return step.subject + ": " + std::to_string(change->fresh) + " more pair(s) of triangles intersect.\n";
}

// Error: of the step concerned.
Status applySteps(MeshDocument& document, const std::vector<Step>& steps, const DocumentKinds& kinds, Edited& done,
                  Progress progress) {
  const MeshFileReader readMesh = meshFileReader(kinds);
  const auto count = static_cast<double>(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto at = static_cast<double>(i);
    const HalfEdgeMesh before = document.mesh();
    const Result<ScriptLineOutcome> outcome =
        applyScriptLine(document, steps[i].text, progress.part(at / count, (at + 0.8) / count), readMesh);
    if (!outcome) {
      Error error = outcome.error();
      if (error.code != ScriptError::Malformed) return error;
      error.subject = steps[i].subject;
      error.position = steps[i].position;
      return error;
    }
    if (const std::string line = reachedLine(steps[i], *outcome); !line.empty()) done.reached.push_back(line);
    const std::string crossings =
        crossingsLine(steps[i], before, document.mesh(), progress.part((at + 0.8) / count, (at + 1.0) / count));
    if (!crossings.empty()) done.reached.push_back(crossings);
    if (!outcome->changed || outcome->sheets.leftCount() > 0) done.idle.push_back(idleSentence(steps[i], *outcome));
  }
  return Done{};
}

// All on the calling thread, the document included.
Result<Edited> editFile(const Arguments& arguments, const DocumentKinds& kinds, Progress progress) {
  const std::filesystem::path input = arguments.operands[0], output = arguments.valueOf("output");
  if (!isContainerName(output)) {
    if (const Result<MeshFormat> format = formatForOutput(output); !format) return format.error();
  }
  const Result<std::vector<Step>> steps = readSteps(arguments);
  if (!steps) return steps.error();
  const ReadOptions read{.partial = arguments.has("partial")};
  Result<OpenedFile> opened = kinds.open(input, read, progress.part(0.0, 0.2));
  if (!opened) return opened.error();
  Edited done;
  done.file = opened->file;
  if (opened->kind->id() != kMeshKind)
    done.refusal = input.string() + " is not a mesh: only meshes can be edited by steps.";
  if (done.refusal.empty()) done.refusal = refusalToReplace(output, opened->file);
  if (!done.refusal.empty()) return done;

  const DocumentKind& kind = *opened->kind;
  MeshDocument document(std::move(*opened));
  // Nobody takes a step back here, but for the turn of faces on opening, which "orient" may undo.
  if (document.openingSteps() == 0) document.history()->setUndoLimit(1);
  done.facesBefore = document.mesh().liveFaceCount();
  const Status applied = applySteps(document, *steps, kinds, done, progress.part(0.2, 0.8));
  if (!applied) return applied.error();
  done.facesAfter = document.mesh().liveFaceCount();
  const auto written = saveDocument(kind, document.file(), *document.snapshot(), output, progress.part(0.8, 1.0));
  if (!written) return written.error();
  done.notes = written->notes;
  return done;
}

const std::string& summary() {
  static const std::string text = [] {
    std::string all =
        "Edits a mesh by the same steps as in the window. The window's Log and \"Save steps\" write such steps; they\n"
        "produce the same file, byte for byte. Exit code 0: done; 2: a step changed nothing, as reported on stderr;\n"
        "1: error, and nothing is written.\n\n"
        "Steps, each quoted as one argument:\n";
    return all + stepsHelp(meshOperations()) +
           "LOOP is its number as in 'handwheel inspect', renumbered after each step, or v and its smallest vertex: "
           "v12.";
  }();
  return text;
}

}  // namespace

MeshFileReader meshFileReader(const DocumentKinds& kinds) {
  return [&kinds](const std::string& path, Progress reading) -> Result<HalfEdgeMesh> {
    const Result<OpenedFile> opened = kinds.open(path, {}, reading);
    if (!opened) return opened.error();
    if (const auto* mesh = dynamic_cast<const MeshSnapshot*>(opened->content.get())) return mesh->mesh.mesh;
    return Error{MeshError::NoTriangles, {}, {}, path};
  };
}

CommandSpec editSpec() {
  return {"edit",
          "IN [STEP...]",
          summary(),
          {
              meshOutputOption(),
              {"steps", 0, "FILE", "Steps, one per line, applied before those of the command line; # begins a comment"},
              {"partial", 0, "", "Read the undamaged part of a damaged file"},
              {"help", 'h', "", "Show this help"},
          }};
}

int runEdit(const Arguments& arguments, const DocumentKinds& kinds) {
  if (!arguments.has("output")) return failUsage("The option -o OUT is missing.", "edit");
  if (arguments.operands.size() < 2 && !arguments.has("steps"))
    return failUsage("No step is given. Give steps, or a file of steps with --steps.", "edit");
  std::optional<Result<Edited>> result;
  runInterruptible("Editing", [&](CommandJob& job) { result = editFile(arguments, kinds, job.progress()); });
  if (!*result) return fail(result->error());
  const Edited& done = result->value();
  reportLosses(done.file);
  if (!done.refusal.empty()) return refuse(done.refusal);
  for (const Note& note : done.notes) complain(noteText(note).toStdString());
  for (const std::string& sentence : done.idle) complain(sentence);
  std::string text =
      "Triangles: " + std::to_string(done.facesBefore) + " before, " + std::to_string(done.facesAfter) + " now.\n";
  for (const std::string& line : done.reached) text += line;
  const int code = print(text);
  if (code != kExitDone) return code;
  return done.idle.empty() ? kExitDone : kExitSomethingLeft;
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "mesh/repair/SheetThickening.h"
#include "tools/mesh/MeshServices.h"

#include <compare>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Mesh edits as lines of a script, called steps. They can be applied without a window. The work of a tool or a job is
// written as a step; applying the step repeats the work by the same code. ScriptLine.h describes the syntax of a line.
namespace handwheel {

// The result of applying one line of an edit script, a step.
struct ScriptLineOutcome {
  bool changed = true;
  // The reason why nothing changed: at most one of `reason`, `failure` and `error` has it.
  const char* reason = nullptr;  // English; to be translated in the contexts "Tool" and "Property"
  FillFailure failure = FillFailure::None;
  SheetOutcomes sheets = {};            // outcomes of a step that thickens sheets
  std::optional<double> distance = {};  // largest distance between the surfaces before and after, mm, if measured
  std::optional<Error> error = {};      // the reason why nothing changed, if it is an error with arguments
};

// A function that reads the mesh of another file, for the step "add".
using MeshFileReader = std::function<Result<HalfEdgeMesh>(const std::string& path, Progress)>;

// Applies one step, which becomes one undo step of the document. Errors: StepMalformed {what is wrong}, Cancelled,
// those of the reader; the document is then unchanged.
Result<ScriptLineOutcome> applyScriptLine(MeshDocument& document, std::string_view step, Progress progress = {},
                                          const MeshFileReader& readMesh = {});

// Returns the change that adds the mesh of a file to another mesh, without moving it.
MeshChange addChange(const std::string& path, const HalfEdgeMesh& mesh);

// A state in the undo history of a document. It is the state after `commands` undo commands. stroke:
// UndoCommand::stroke() of the last of them. The default is the state in which the file was opened.
struct HistoryPoint {
  int commands = 0;
  int stroke = 0;
  auto operator<=>(const HistoryPoint&) const = default;
};
// Returns the present state in the history of a document.
HistoryPoint presentPoint(const MeshDocument& document);

// Returns the steps from a state to the present one, without undone steps. Returns nothing if the state does not
// precede the present one, or if an edit of the mesh has no step. Edits of properties and recordings are skipped.
std::optional<std::vector<std::string>> scriptLinesSince(const MeshDocument& document, const HistoryPoint& state = {});

}  // namespace handwheel

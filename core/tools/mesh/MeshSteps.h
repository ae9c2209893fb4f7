// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "mesh/HoleFilling.h"
#include "mesh/Repair.h"
#include "tools/mesh/MeshServices.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Edits of a mesh as lines of text, so that they can be made without a window: what a tool or a job did is written as a
// step, and the step does it once more, by the same code. StepText.h says how a line is made up.
namespace handwheel {

// For help pages.
struct StepForm {
  std::string_view form;  // "delete TRIANGLES"
  std::string_view help;
};
std::span<const StepForm> stepForms();

struct StepOutcome {
  bool changed = true;
  // Why nothing changed, where it did not; one of them or none.
  const char* hindrance = nullptr;  // English, contexts "Tool" and "Property"
  FillFailure failure = FillFailure::None;
};

// Reads the mesh of another file, for "add".
using MeshFileReader = std::function<Result<HalfEdgeMesh>(const std::string& path, Progress)>;

// Does one step, which becomes one in the document's history. Errors: StepMalformed {what is wrong}, Cancelled, those
// of the reader; then nothing has changed.
Result<StepOutcome> applyStep(MeshDocument& document, std::string_view step, Progress progress = {},
                              const MeshFileReader& readMesh = {});

// The steps of what a job in the window does. loop: by its key.
std::string fillStep(Vertex loop, const FillOptions& options);
std::string repairStep(const RepairOptions& options);
// Puts the mesh of a file into another, where it stands.
MeshChange addChange(const std::string& path, const HalfEdgeMesh& mesh);

// A state in the history of a document: that after so many commands, the last of which belongs to this stroke. The
// first without any.
struct HistoryPoint {
  int commands = 0;
  int stroke = 0;
  bool operator==(const HistoryPoint&) const = default;
};
HistoryPoint presentPoint(const MeshDocument& document);

// What leads from a state to the present one, undone steps left out: none where the state is not on the way to the
// present, or an edit of the mesh has no step. Properties and recordings are passed over.
std::optional<std::vector<std::string>> stepsSince(const MeshDocument& document, const HistoryPoint& state = {});

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/repair/Repair.h"

#include <QString>
#include <optional>
#include <string>
#include <vector>

namespace handwheel {

struct OperationsOrigin;
struct MeshTab;

// Functions that return the command lines equivalent to the edits of a mesh.

// Returns the command line for a step that is about to be applied. It is a complete command if the mesh equals its
// file, otherwise only the part to add to the previous command.
QString stepCommand(const MeshTab& document, const std::string& step);

// Returns the command line that repairs a file as the window has repaired it.
QString repairCommand(const QString& path, const RepairOptions& options);

// The steps from a file to the present state.
struct OperationSequence {
  const OperationsOrigin* base;
  std::vector<std::string> steps;
};
// Finds the steps from the newest usable file to the present state. The result is empty if an edit has no step or there
// is no usable file. toContainer: adds a step for the display unit if it has changed, since a container stores it.
std::optional<OperationSequence> editPath(const MeshTab& document, bool toContainer = true);

// Returns the command line that writes the present state to a file. If the line would be too long, it reads the steps
// from a separate file that "Save steps" writes. The result is empty if editPath() finds no steps.
QString editCommand(const MeshTab& document, const QString& to);
QString stepsName(const QString& path);  // "part.stl" becomes "part.steps"
// Returns the text of a steps file, which begins with a comment line on its purpose.
QByteArray stepsText(const OperationSequence& path);

// Records that the document equals its file. To be called when the document was opened or saved, or has returned to
// that state.
void noteFile(MeshTab& document);

}  // namespace handwheel

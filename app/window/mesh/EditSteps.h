// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

namespace handwheel {

struct EditBase;
struct OpenMesh;

// How what was done to a mesh is done without a window.

// Of one step that is about to be done: a whole command where the mesh is that of its file, else what there is to add
// to the command before.
QString stepCommand(const OpenMesh& document, const std::string& step);

// What leads from a file to the present state. None where an edit has no step, or there is no such file.
struct EditPath {
  const EditBase* base;
  std::vector<std::string> steps;
};
std::optional<EditPath> editPath(const OpenMesh& document, bool toContainer = true);

// The command that writes the present state to a file. Where it would be too long, one that reads the steps from a file
// beside that, which "Save steps" writes. Empty where there is none.
QString editCommand(const OpenMesh& document, const QString& to);
QString stepsName(const QString& path);  // "part.stl" becomes "part.steps"
// The text of such a file, with a line that says what it is for.
QByteArray stepsText(const EditPath& path);

// The document was opened, or saved as it is now; or it is again as it was then.
void noteFile(OpenMesh& document);

}  // namespace handwheel

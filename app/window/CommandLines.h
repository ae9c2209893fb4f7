// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Property.h"
#include "document/formats/MeshFormat.h"

#include <QString>

namespace handwheel {

// Command lines equivalent to the user's actions in the window. Paths in them are absolute and quoted for a shell, so
// they work in any folder. inspectCommand() inspects a file, compareCommand() compares a mesh with a scan, and
// convertCommand() converts a file.
QString inspectCommand(const QString& path, const ReadOptions& options);
QString compareCommand(const QString& mesh, const QString& scan);
QString convertCommand(const QString& from, const QString& to);
// Returns the command line that sets the changed properties to their present values. The result is empty if no property
// differs and both paths are the same.
QString setCommand(const QString& from, const std::vector<Property>& before, const std::vector<Property>& now,
                   const QString& to);
// Returns the command line that creates a document. kind: the id of the kind of document.
QString newCommand(const std::string& kind, const std::vector<Property>& before, const std::vector<Property>& now,
                   const QString& to);

// Return the command line that applies editing steps (tools/mesh/MeshScript.h), given as a list or as a file.
QString editCommandLine(const QString& from, const std::vector<std::string>& steps, const QString& to);
QString editCommandLine(const QString& from, const QString& stepsFile, const QString& to);
// Returns the command line for a step that is also a command with the same arguments.
QString ownCommand(const QString& from, const std::string& step, const QString& to);
QString stepWord(const std::string& step);  // returns the step quoted as one word for a shell
// Returns the command line that splits a file into shells in a folder.
QString splitCommand(const QString& from, const QString& folder);
inline constexpr int kLongestCommand = 2000;  // characters; longer ones are impractical to read or paste

// Returns the proposed path of an edited file: "scan.stl" becomes "scan-edited.stl" in the same folder.
QString editedName(const QString& path);
// Returns the proposed path of a repaired file: "scan.stl" becomes "scan-repaired.stl" in the same folder.
QString repairedName(const QString& path);

}  // namespace handwheel

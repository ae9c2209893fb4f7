// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Property.h"
#include "document/formats/MeshFormat.h"
#include "mesh/Repair.h"

#include <QString>

namespace handwheel {

// The command lines that do without a window what the user just did in it. They work in any folder: paths stand whole,
// and are quoted for a shell.
QString inspectCommand(const QString& path, const ReadOptions& options);
QString repairCommand(const QString& path, const RepairOptions& options);
QString compareCommand(const QString& mesh, const QString& scan);
QString convertCommand(const QString& from, const QString& to);
// Gives the properties that differ their present values. Empty when none differs and both paths are the same.
QString setCommand(const QString& from, const std::vector<Property>& before, const std::vector<Property>& now,
                   const QString& to);
// The same for a document that was new. kind: id
QString newCommand(const std::string& kind, const std::vector<Property>& before, const std::vector<Property>& now,
                   const QString& to);

// Steps of "handwheel edit" (tools/mesh/MeshSteps.h), or a file of them.
QString editCommandLine(const QString& from, const std::vector<std::string>& steps, const QString& to);
QString editCommandLine(const QString& from, const QString& stepsFile, const QString& to);
// One whose verb is a command with the same words.
QString ownCommand(const QString& from, const std::string& step, const QString& to);
QString stepWord(const std::string& step);  // as one word for a shell
// "split" takes a folder.
QString splitCommand(const QString& from, const QString& folder);
inline constexpr int kLongestCommand = 2000;  // characters, beyond which nobody reads or pastes one

// "scan.stl" becomes "scan-edited.stl" beside it.
QString editedName(const QString& path);
// "scan.stl" becomes "scan-repaired.stl" beside it.
QString repairedName(const QString& path);

}  // namespace handwheel

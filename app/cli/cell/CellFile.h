// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"
#include "document/DocumentKind.h"
#include "document/cell/RobotCellSnapshot.h"

#include <optional>

namespace handwheel {

// A robot cell named on a command line.
struct CellFile {
  OpenedFile opened;
  std::shared_ptr<const RobotCellSnapshot> cell;  // Content of the opened document
  // The robot that its plans were for, if another was chosen for this command; the file keeps it.
  std::optional<std::string> ownArm = {};
};

// Returns a cell with a built-in robot (ShippedDocument).
std::optional<OpenedFile> shippedRobot(const std::string& name, const DocumentKinds& kinds);

// Opens a cell: a document, a robot description, or a built-in robot by its name. Reports losses. Errors: those of
// DocumentKinds::open(); Unsupported for other kinds of documents.
Result<CellFile> openCell(const std::string& name, const DocumentKinds& kinds);

// Returns the option --arm of commands that work with one of the robots of a cell.
OptionSpec armOption();
// Opens the cell of the first operand with the robot of --arm as the one that is planned for; without the option, the
// robot of the path with this name, if the cell has one. Errors: those of openCell(); ArmMissing.
Result<CellFile> openCellForArm(const Arguments& arguments, const DocumentKinds& kinds, const std::string& path = {});

// Writes the cell with other content. Reports errors and notes. Returns the exit code.
int saveCell(const CellFile& file, const RobotCellSnapshot& content, const std::filesystem::path& output);

}  // namespace handwheel

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
  // Name of the robot that the plans of the file are for, if another robot was chosen for the command. Saving keeps it.
  std::optional<std::string> ownArm = {};
};

// Returns a document with a built-in robot (ShippedDocument); nothing if the program has none with this name.
std::optional<OpenedFile> shippedRobot(const std::string& name, const DocumentKinds& kinds);

// Opens a cell: a document, a robot description, or a built-in robot by its name. Reports losses. Errors: the errors of
// DocumentKinds::open(), and Unsupported for other kinds of documents.
Result<CellFile> openCell(const std::string& name, const DocumentKinds& kinds);

// Returns the option --arm of commands that work with one of the robots of a cell.
OptionSpec armOption();
// Opens the cell of the first operand with the robot that --arm names as the one that is planned for. Without the
// option, it is the robot of the path with the name `path`, if the cell has such a path. Errors: the errors of
// openCell(), and ArmMissing.
Result<CellFile> openCellForArm(const Arguments& arguments, const DocumentKinds& kinds, const std::string& path = {});

// Writes the cell with other content, and reports errors and notes. Returns the exit code.
int saveCell(const CellFile& file, const RobotCellSnapshot& content, const std::filesystem::path& output);

}  // namespace handwheel

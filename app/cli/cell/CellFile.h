// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// A robot cell named on a command line.
struct CellFile {
  OpenedFile opened;
  std::shared_ptr<const RobotCellSnapshot> cell;  // its content
};

// Opens a cell: a document, a robot description, or a robot that comes with the program, by its name. Reports what is
// lost. Errors: those of DocumentKinds::open(); Unsupported for other kinds of documents.
Result<CellFile> openCell(const std::string& name, const DocumentKinds& kinds);

// Writes the cell with other content. Reports what is wrong, or notes. Returns the exit code.
int saveCell(const CellFile& file, const RobotCellSnapshot& content, const std::filesystem::path& output);

}  // namespace handwheel

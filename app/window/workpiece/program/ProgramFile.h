// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"

#include <QString>
#include <filesystem>

namespace handwheel {

// The text of a program in an editor, and the encoding of its file.
struct ProgramFile {
  QString text;             // lines end in '\n'
  bool isLatin = false;     // true: ISO 8859-1 instead of UTF-8
  bool hasReturns = false;  // true: lines in the file end in "\r\n"
};

// The largest program that an editor can show without a delay; a run from the command line accepts more.
inline constexpr std::size_t kMostProgramBytes = std::size_t{4} << 20;

// Reads a program. Errors: the errors of readFileBytes(), FileTooLarge. Blocks the calling thread.
Result<ProgramFile> readProgramFile(const std::filesystem::path& path, Progress progress);
// Writes a program in its original encoding, or as UTF-8 if the text has other characters. Errors: the errors of
// writeFileAtomically(). Blocks the calling thread.
Status writeProgramFile(const std::filesystem::path& path, const ProgramFile& file, Progress progress);

// Returns true if a file name has an extension of programs, such as .ngc, .nc, .tap or .txt.
bool isProgramName(const QString& path);
QString programNameFilter();  // "*.ngc *.nc …"

}  // namespace handwheel

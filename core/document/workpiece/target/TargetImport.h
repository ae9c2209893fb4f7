// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Note.h"
#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/target/ProfileFromStep.h"

#include <filesystem>
#include <optional>

namespace handwheel {

// A target that was read from a file, at its position there.
struct ImportedTarget {
  TargetProfile profile;
  std::string source;       // name of the file, UTF-8
  std::vector<Note> notes;  // what the user should know of how it was read
  bool isPlaced = false;    // it was in a bar, as a workpiece of our own
};

// Reads a target by the content of the file: a turned part in STEP or as a mesh, the half section in DXF or SVG, or a
// workpiece of our own, whose target counts if it has one, else the part. Blocks. Errors: those of the readers,
// FormatUnknown; the subject is the path.
Result<ImportedTarget> importTarget(const std::filesystem::path& path, UnturnedFaces others, Progress progress = {});

// The extensions of these files: ".step", …
std::vector<std::string> targetEndings();

// The target of a workpiece, with this allowance for facing (mm) at the free end of the bar. None: one from another
// workpiece stays where it was there if the bar has it all; where the zero of a drawing is says nothing of the bar, so
// that any other is given the usual allowance.
std::shared_ptr<const WorkpieceTarget> placedTarget(const ImportedTarget& imported, const StockCylinder& stock,
                                                    std::optional<double> allowance = {});

// The section of a workpiece where it stands: of what was cut, of the piece at its free end where that is parted off,
// or of the bar. Errors: those of TargetProfile::make().
Result<TargetProfile> sectionOf(const WorkpieceSnapshot& workpiece);
// What is to be said of that section: that it is of one piece of several.
std::vector<Note> sectionNotes(const WorkpieceSnapshot& workpiece);

}  // namespace handwheel

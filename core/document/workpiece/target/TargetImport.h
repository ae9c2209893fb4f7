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

// A target that was read from a file, at its position in the file.
struct ImportedTarget {
  TargetProfile profile;
  std::string source;       // name of the file, UTF-8
  std::vector<Note> notes;  // remarks on the reading for the user
  bool isPlaced = false;    // true: the file is a workpiece of our own, with a bar around the target
};

// Reads a target by the content of the file: a turned part in STEP or as a mesh, the half section in DXF or SVG, or the
// target, else the part, of a workpiece of our own. Blocks. Errors: those of the readers, FormatUnknown; the subject is
// the path.
Result<ImportedTarget> importTarget(const std::filesystem::path& path, UnturnedFaces others, Progress progress = {});

// Returns the extensions of these files: ".step", …
std::vector<std::string> targetEndings();

// Returns the target of a workpiece with this allowance for facing (mm) at the free end of the bar. Without an
// allowance, a target from another workpiece keeps its position if it lies within the bar; any other gets the usual
// allowance, since the zero of a drawing does not relate to the bar.
std::shared_ptr<const WorkpieceTarget> placedTarget(const ImportedTarget& imported, const StockCylinder& stock,
                                                    std::optional<double> allowance = {});

// Returns the section of a workpiece at its position: of the cut part, of the piece at its free end if that is parted
// off, or of the bar. Errors: those of TargetProfile::make().
Result<TargetProfile> sectionOf(const WorkpieceSnapshot& workpiece);
// Returns a note if that section is of one piece of several.
std::vector<Note> sectionNotes(const WorkpieceSnapshot& workpiece);

}  // namespace handwheel

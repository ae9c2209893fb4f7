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
  bool isPlaced = false;    // true: the file is a Handwheel workpiece, with a bar around the target
};

// Reads a target according to the content of a file. It is a turned part in STEP or as a mesh, the half section in DXF
// or SVG, or the target of a Handwheel workpiece (its part if it has no target). Blocks the calling thread. Errors: the
// errors of the readers, FormatUnknown; the subject of an error is the path.
Result<ImportedTarget> importTarget(const std::filesystem::path& path, UnturnedFaces others, Progress progress = {});

// Returns the extensions of files that importTarget() reads: ".step", …
std::vector<std::string> targetEndings();

// Returns the target of a workpiece with this allowance for facing (mm) at the free end of the bar. Without an
// allowance, a target from another workpiece keeps its position if it lies within the bar; any other gets the usual
// allowance, since the zero of a drawing does not relate to the bar.
std::shared_ptr<const WorkpieceTarget> placedTarget(const ImportedTarget& imported, const StockCylinder& stock,
                                                    std::optional<double> allowance = {});

// Returns the section of a workpiece at its position. It is that of the bar or of the cut part, or of the piece at the
// free end if the part is in several pieces. Errors: the errors of TargetProfile::make().
Result<TargetProfile> sectionOf(const WorkpieceSnapshot& workpiece);
// Returns a note if sectionOf() gives the section of one piece of several.
std::vector<Note> sectionNotes(const WorkpieceSnapshot& workpiece);

}  // namespace handwheel

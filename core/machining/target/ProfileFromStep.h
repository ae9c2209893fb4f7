// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/target/TargetProfile.h"

#include <string_view>

namespace handwheel {

// A target from a solid, with the number of ignored faces.
struct ProfileFromStep {
  TargetProfile target;
  std::size_t ignoredFaces = 0;  // faces that are not of revolution
};

// The treatment of a STEP file with other faces than those of revolution.
enum class UnturnedFaces { Refuse, Ignore };

// Reads a turned part from a STEP file: finds its axis, checks that every face is of revolution about it, and extracts
// the half section. Curves other than lines and arcs become arcs within 1e-4 mm. z = 0 is the point of the axis nearest
// to the origin of the file. The file is read in a process of its own (docs/adr/0025-isolated-readers.md); blocks.
// Errors: those of readIsolated() and TargetProfile::make(); TargetError::NotOneSolid, NoAxis, NotTurned,
// SeveralProfiles.
Result<ProfileFromStep> readProfileFromStep(std::string_view bytes, UnturnedFaces others, Progress progress = {});

// Reads the target from the answer of that process, which may be anything. Errors: the same; LibraryFailed if it is no
// answer.
Result<ProfileFromStep> profileFromStepAnswer(std::string_view answer, Progress progress = {});

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/target/TargetProfile.h"

#include <string_view>

namespace handwheel {

// A target from a solid, with what was left out of it.
struct ProfileFromStep {
  TargetProfile target;
  std::size_t ignoredFaces = 0;  // that are not of revolution
};

// What a STEP file with other faces than those of revolution is taken for.
enum class UnturnedFaces { Refuse, Ignore };

// Reads a turned part from a STEP file: finds its axis, checks that every face is of revolution about it, and takes the
// half section. Curves other than lines and arcs become arcs within 1e-4 mm. z = 0 is where the axis is nearest to the
// origin of the file. The file is read in a process of its own (docs/adr/0025-isolated-readers.md); blocks. Errors:
// those of readIsolated() and TargetProfile::make(); TargetError::NotOneSolid, NoAxis, NotTurned, SeveralProfiles.
Result<ProfileFromStep> readProfileFromStep(std::string_view bytes, UnturnedFaces others, Progress progress = {});

// The target in the answer of that process, which may be anything. Errors: the same; LibraryFailed for what is no
// answer.
Result<ProfileFromStep> profileFromStepAnswer(std::string_view answer, Progress progress = {});

}  // namespace handwheel

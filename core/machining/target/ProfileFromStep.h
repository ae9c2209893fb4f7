// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/target/TargetProfile.h"

#include <string_view>

namespace handwheel {

// A target that was read from a solid, with the number of ignored faces.
struct ProfileFromStep {
  TargetProfile target;
  std::size_t ignoredFaces = 0;  // number of faces that are not surfaces of revolution
};

// The treatment of faces of a STEP file that are not surfaces of revolution.
enum class UnturnedFaces { Refuse, Ignore };

// Reads a turned part from a STEP file. The function finds the axis, checks that every face is a surface of revolution
// about it, and extracts the half section. Curves other than lines and arcs become arcs within 1e-4 mm. z = 0 is the
// point of the axis nearest to the origin of the file. The file is read in a process of its own
// (docs/adr/0025-isolated-readers.md), and the call blocks until that process has finished. Errors:
// TargetError::NotOneSolid, NoAxis, NotTurned, SeveralProfiles, and the errors of readIsolated() and
// TargetProfile::make().
Result<ProfileFromStep> readProfileFromStep(std::string_view bytes, UnturnedFaces others, Progress progress = {});

// Reads the target from the answer of the process that reads the file. The answer is not trusted. Errors: the errors of
// readProfileFromStep(), and LibraryFailed if the text is not an answer.
Result<ProfileFromStep> profileFromStepAnswer(std::string_view answer, Progress progress = {});

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/problems/PlanningSet.h"

#include <filesystem>

namespace handwheel {

// Reads a planning set from a file or folder. The file may be JSON, or one of a pair of YAML files of MotionBenchMaker
// (scene0001.yaml and request0001.yaml); a folder may contain such pairs. Errors: the errors of readFileBytes(),
// readPlanningSet() and readMoveItProblem(), with the file as subject.
Result<PlanningSet> readPlanningFiles(const std::filesystem::path& path);

}  // namespace handwheel

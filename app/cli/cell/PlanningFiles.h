// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/problems/PlanningSet.h"

#include <filesystem>

namespace handwheel {

// Reads a planning set from a file or folder. It may be a JSON file; a YAML file of MotionBenchMaker, with the other
// one of its pair (scene0001.yaml, request0001.yaml) beside it; or a folder of such pairs. Errors: those of
// readFileBytes(), readPlanningSet() and readMoveItProblem(), with the file.
Result<PlanningSet> readPlanningFiles(const std::filesystem::path& path);

}  // namespace handwheel

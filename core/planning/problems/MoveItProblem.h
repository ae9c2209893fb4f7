// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/problems/PlanningSet.h"

namespace handwheel {

// Reads a problem of MotionBenchMaker from its pair of YAML files. These are a scene and a request of MoveIt. The
// planned joints are those of the goal; other joints of the start are left out. name: name of the set and of its only
// problem. Obstacles that are not supported (meshes, planes, octomaps, attached bodies, other frames than the root's)
// are refused. Errors: ElementMalformed, whose element begins with "scene" or "request".
Result<PlanningSet> readMoveItProblem(std::string_view scene, std::string_view request, const std::string& name);

}  // namespace handwheel

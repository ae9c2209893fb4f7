// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramSetup.h"
#include "machining/program/ToolPath.h"
#include "viewport/path/PathLayer.h"

namespace handwheel {

// Returns a tool path as lines in the plane y = 0 of the scene. Lines of the same look are adjacent in the result.
// Rapid moves are dashed, and arcs are approximated within 0.02 mm. zero: z of the program's zero in the scene, mm;
// dash: length of a dash, mm. A very long path is truncated. May be called on any thread.
PathLayer::Lines toolPathLines(const ToolPath& path, double zero, double dash);

// Returns the nose of a tool at a position on its path, and an insert behind the nose, in the plane y = 0. tip:
// position (r, z) of the tip in the program, mm.
std::vector<std::vector<Vec3>> toolOutline(const ProgramTool& tool, ProgramDialect dialect, const ProfilePoint& tip,
                                           double zero);

}  // namespace handwheel

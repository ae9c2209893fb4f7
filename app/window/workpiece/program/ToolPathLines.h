// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramSetup.h"
#include "machining/program/ToolPath.h"
#include "viewport/path/PathLayer.h"

namespace handwheel {

// Returns a tool path as lines in the plane y = 0 of the scene. Lines of one look are adjacent: rapid moves dashed,
// arcs within 0.02 mm. zero: mm, z of the program's zero in the scene; dash: mm. A very long path is truncated. Any
// thread.
PathLayer::Lines toolPathLines(const ToolPath& path, double zero, double dash);

// Returns the nose of a tool at a position on its path, and an insert behind it, in the same plane. tip: mm, (r, z) of
// the program.
std::vector<std::vector<Vec3>> toolOutline(const ProgramTool& tool, ProgramDialect dialect, const ProfilePoint& tip,
                                           double zero);

}  // namespace handwheel

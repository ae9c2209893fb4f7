// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/holes/Fairing.h"
#include "mesh/holes/HoleContext.h"
#include "mesh/holes/Obstacles.h"
#include "mesh/holes/Patch.h"

#include <optional>

namespace handwheel {

// Fills a hole so that the creases ending at it continue through it. The creases are those that findCreaseEnds() finds
// above tolerance::kCreaseAngle. The pieces between them are filled one by one, each refined and faired to the surface
// on its own side, and the creases stay sharp. Returns nothing if no two crease ends match or a piece cannot be filled.
// density and continuity have the same meaning as in FillOptions.
std::optional<Patch> fillAlongCreases(const HoleContext& hole, const Obstacles& obstacles, double density,
                                      Continuity continuity = Continuity::Tangent, Progress progress = {});

}  // namespace handwheel

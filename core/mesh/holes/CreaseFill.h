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

// Fills a hole so that the creases ending at it continue through it. The pieces between the creases (Creases.h, above
// tolerance::kCreaseAngle) are filled one by one, each refined and faired by what is around it on its own side, and the
// creases stay sharp. None when no two ends belong together or a piece cannot be filled. density and continuity: as in
// FillOptions.
std::optional<Patch> fillAlongCreases(const HoleContext& hole, const Obstacles& obstacles, double density,
                                      Continuity continuity = Continuity::Tangent, Progress progress = {});

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/Fairing.h"
#include "mesh/HoleContext.h"
#include "mesh/Obstacles.h"
#include "mesh/Patch.h"

#include <optional>

namespace handwheel {

// Carries the creases that end at the hole (Ridges.h, above tolerance::kRidgeAngle) through it, fills what is between
// them piece by piece, each refined and faired by what is around it on its own side, and keeps the creases sharp. None
// when no two ends belong together or a piece cannot be filled. density and continuity: as FillOptions has them.
std::optional<Patch> fillAlongRidges(const HoleContext& hole, const Obstacles& obstacles, double density,
                                     Continuity continuity = Continuity::Tangent, Progress progress = {});

}  // namespace handwheel

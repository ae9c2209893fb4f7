// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Returns the surface finish of a turned part as JSON, for stretches along the axis. It is an object with "outside" and
// "bore", arrays of at most kMostStretches objects with "from", "to" (mm, Z of the document), "roughness_um" (Ra that
// no more than a sixth of the stretch exceeds) and "largest_um" (µm; null for a tool without a nose radius), "grade"
// (N1 to N12, null if there is none), "pass" (counted from 1), "tool" (its id; null if the pass does not record it),
// "kind", "nose_radius" and "feed" (mm per revolution), and "text": "Ra 0.78 µm (N6), Z 20 to 40". "faces" has the same
// for each face, with "z", "inner_radius" and "outer_radius" (mm) instead of "from" and "to".
// position: Z of the lower end of the bar in the document, mm.
inline constexpr std::size_t kMostStretches = 1'000;
nlohmann::json finishJson(const TurnedPart& part, double position);

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPasses.h"
#include "machining/section/TurnedSection.h"

#include <vector>

namespace handwheel {

// The finish of a flat or nearly flat face of a turned part. Samples along the axis say nothing of a face.
struct FaceFinish {
  double height = 0.0;              // mm above the lower end of the part, at the middle of the face
  double inner = 0.0, outer = 0.0;  // mm, its radii
  std::uint32_t pass = 0;           // index of the pass that made it
  double feed = 0.0;                // mm per revolution, the largest feed on it
  double roughness = 0.0;           // µm Ra, by feed and nose; infinite for a tool without a nose radius
};

// Returns the faces that passes have left, from the lower end to the upper, if the feed on them is known. A face leans
// by at most 15°. O(segments × points of their passes).
std::vector<FaceFinish> faceFinish(const TurnedSection& section, const TurningPasses& passes);

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/search/FaceHierarchy.h"
#include "mesh/selection/FaceSelection.h"

#include <vector>

namespace handwheel {

// A closed selection curve, drawn with a pointer.
struct Lasso {
  std::vector<Ray> rays;    // rays of the pointer; unusable rays are ignored
  std::optional<Vec3> eye;  // common eye of all rays; absent under parallel projection
  bool through = false;     // true: back-facing and hidden faces are included
};

// Finds the faces whose three corners are all projected inside a lasso. The even-odd rule applies if it crosses itself.
// Unless Lasso::through is set, only front-facing faces with a visible centre are selected; a face without area counts
// as front-facing. The selection is empty for fewer than three rays, or rays that are not all in front of one viewer.
// Returns nothing if cancelled. O(n) on all threads of the arena, plus one ray query for each face that does not face
// away.
std::optional<FaceSelection> facesInLasso(const FaceHierarchy& faces, const Lasso& lasso, Progress progress = {});

}  // namespace handwheel

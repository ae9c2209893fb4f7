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
  std::vector<Ray> rays;    // of the pointer; those that are not usable do not count
  std::optional<Vec3> eye;  // of all of them; none under parallel projection
  bool through = false;     // also what faces away or is hidden
};

// Finds the faces whose three corners all appear inside a lasso. Where it crosses itself, by the even-odd rule. Unless
// it goes through, only those that show their front and whose centre is not hidden; a face without area has no back.
// Nothing for fewer than three rays, or rays that no viewer sees at once. Empty optional when cancelled. O(n) on all
// threads of the arena, and a ray for each face that does not face away.
std::optional<FaceSelection> facesInLasso(const FaceHierarchy& faces, const Lasso& lasso, Progress progress = {});

}  // namespace handwheel

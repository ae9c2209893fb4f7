// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

// Finds second layers of a surface, as where two scans overlap. Layers are open shells of at least
// tolerance::kCrumbFaces faces that lie along larger shells: nine tenths of their area are nearer to a larger shell
// than the reach (mm), and face the same direction. The walls of a thin part face opposite directions, so they are no
// layers of each other. Returns the faces of these shells; without them, the largest layer is left. The result is
// incomplete if cancelled. O(n log n) for each shell that is no layer, up to a fixed number of them; the work counts as
// effort.
std::vector<Face> findDoubleLayers(const HalfEdgeMesh& mesh, double reach, Progress progress = {});

}  // namespace handwheel

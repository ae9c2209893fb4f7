// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/defects/Defects.h"
#include "mesh/repair/Repair.h"

namespace handwheel {

// Why a repair left the defects that remain in its result. Each for itself: as MeshChange::reason, in the order of
// Defects. Empty where there are none.
struct RemainingDefects {
  std::vector<const char*> nonManifoldEdges;
  std::vector<const char*> nonManifoldVertices;
  std::vector<const char*> nonOrientableEdges;
  std::vector<const char*> nearVertices;
};

// after: the result of that repair, with its defects. Empty if cancelled. O(n) where there are such defects.
RemainingDefects remainingDefects(const InspectedMesh& after, const RepairReport& report, Progress progress = {});

}  // namespace handwheel

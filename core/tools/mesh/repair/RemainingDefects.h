// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/defects/Defects.h"
#include "mesh/repair/Repair.h"

namespace handwheel {

// Reasons why a repair left the defects that remain in its result. Each is as MeshChange::reason, in the order of
// Defects. Empty if there are no such defects.
struct RemainingDefects {
  std::vector<const char*> nonManifoldEdges;
  std::vector<const char*> nonManifoldVertices;
  std::vector<const char*> nonOrientableEdges;
  std::vector<const char*> nearVertices;
};

// Finds the reasons. after: the result of that repair, with its defects. Empty if cancelled. O(n) if there are such
// defects.
RemainingDefects remainingDefects(const InspectedMesh& after, const RepairReport& report, Progress progress = {});

}  // namespace handwheel

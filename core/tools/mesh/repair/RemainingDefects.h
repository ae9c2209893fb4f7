// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/defects/Defects.h"
#include "mesh/repair/Repair.h"

namespace handwheel {

// The reasons why defects remain in the result of a repair. Each list contains reasons as in MeshChange::reason, in the
// order of the defects in Defects. A list is empty if no defects of its kind remain.
struct RemainingDefects {
  std::vector<const char*> nonManifoldEdges;
  std::vector<const char*> nonManifoldVertices;
  std::vector<const char*> nonOrientableEdges;
  std::vector<const char*> nearVertices;
};

// Finds the reasons why defects remain after a repair. after: the result of the repair, with its defects. The result is
// empty if cancelled. O(n) if any of these defects remain.
RemainingDefects remainingDefects(const InspectedMesh& after, const RepairReport& report, Progress progress = {});

}  // namespace handwheel

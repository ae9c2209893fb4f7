// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/repair/Repair.h"
#include "tools/mesh/MeshServices.h"

#include <optional>

namespace handwheel {

// Filling and repair as used by the window and 'handwheel edit'.

// Fills a hole of the filler's mesh, and returns the patch or the failure. prepared: the patch, if it was already
// proposed.
FillAttempt fillHole(HoleFiller& filler, const BoundaryLoop& loop, const FillOptions& options,
                     const std::optional<FillAttempt>& prepared, Progress progress = {});
// Returns the step of 'handwheel edit', as text, that fills a hole with these options. loop: the key of the loop, from
// keyOf() (mesh/boundary/BoundaryLoops.h).
std::string fillStep(Vertex loop, const FillOptions& options);

// Creates the change that repairs a mesh. report: set by the change on the thread on which it runs; may be null.
MeshChange repairChange(const RepairOptions& options, std::shared_ptr<RepairReport> report = nullptr);

}  // namespace handwheel

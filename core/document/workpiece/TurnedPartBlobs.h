// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "document/workpiece/WorkpieceSnapshot.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Writes the turned part of a workpiece into a container. It is "turned" in the object "document" of the manifest, and
// the blobs "workpiece/radii/NNNN" (a double for each sample), "workpiece/inner/NNNN" (the same for a bored part) and
// "workpiece/path/NNNN" (time, r and z of each point, one pass after the other), and the finish if it is kept. For an
// uncut bar, null and no blobs.
void writeTurnedPart(const WorkpieceSnapshot& workpiece, Container& container);

// Reads it; accepts any input. If samples are lost, the profile is cut again from the passes, unless that would take
// too long. Data that cannot be recovered is added to the damage, and the bar is then uncut (null). Error: Cancelled.
Result<std::shared_ptr<const TurnedPart>> readTurnedPart(const nlohmann::json& document,
                                                         const WorkpieceSnapshot& workpiece, const Container& container,
                                                         std::vector<Error>& damage, Progress progress);

}  // namespace handwheel

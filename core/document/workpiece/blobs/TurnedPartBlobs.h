// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "document/workpiece/WorkpieceSnapshot.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Writes the turned part of a workpiece into a container. The manifest has it as "turned" in the object "document". The
// blobs "workpiece/radii/NNNN" hold a double for each sample, "workpiece/inner/NNNN" the same for a bored part, and
// "workpiece/path/NNNN" the time, r and z of each point, one pass after the other. The finish is written, too, if the
// part has one. For an uncut bar "turned" is null, and there are no blobs.
void writeTurnedPart(const WorkpieceSnapshot& workpiece, Container& container);

// Reads the turned part of a workpiece. Accepts any input. If samples are lost, the profile is cut again from the
// passes, unless that would take too long. Losses are added to `damage`. Returns null, an uncut bar, if the profile
// cannot be recovered. Error: Cancelled.
Result<std::shared_ptr<const TurnedPart>> readTurnedPart(const nlohmann::json& document,
                                                         const WorkpieceSnapshot& workpiece, const Container& container,
                                                         std::vector<Error>& damage, Progress progress);

}  // namespace handwheel

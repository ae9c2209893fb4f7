// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "document/workpiece/WorkpieceSnapshot.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Writes the target of a workpiece into a container. The target is "target" in the object "document" of the manifest,
// and the blob "workpiece/target" with five doubles for each segment (r and z of both ends in mm, bulge). Without a
// target, "target" is null and there is no blob.
void writeTarget(const WorkpieceSnapshot& workpiece, Container& container);

// Reads the target of a workpiece from any input. An unreadable target is added to the damage, and the result is null.
std::shared_ptr<const WorkpieceTarget> readTarget(const nlohmann::json& document, const Container& container,
                                                  std::vector<Error>& damage);

}  // namespace handwheel

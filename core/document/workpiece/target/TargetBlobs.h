// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "document/workpiece/WorkpieceSnapshot.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Writes the target of a workpiece into a container. It is "target" in the object "document" of the manifest, and the
// blob "workpiece/target" with five doubles for each segment (r and z of both ends in mm, bulge). Without a target,
// null and no blob.
void writeTarget(const WorkpieceSnapshot& workpiece, Container& container);

// Reads it; accepts any input. An unreadable target is added to the damage and gives null.
std::shared_ptr<const WorkpieceTarget> readTarget(const nlohmann::json& document, const Container& container,
                                                  std::vector<Error>& damage);

}  // namespace handwheel

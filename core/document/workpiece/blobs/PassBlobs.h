// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "machining/TurningPasses.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Writes the passes of a turned part into a container. Points and speeds are written as blobs. Returns the remaining
// data as a list for the manifest.
nlohmann::json writePasses(const TurningPasses& passes, Container& container);

// Reads the passes that writePasses() wrote. Lost or malformed passes are left out. Error: Cancelled.
Result<TurningPasses> readPasses(const nlohmann::json& listed, const Container& container, Progress progress);

}  // namespace handwheel

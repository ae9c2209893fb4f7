// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "machining/TurningPasses.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// The passes of a turned part in a container: their points and speeds are blobs. Returns the list of what else they
// have, for the manifest.
nlohmann::json writePasses(const TurningPasses& passes, Container& container);

// The passes of such a list; those that are lost or malformed are left out. Error: Cancelled.
Result<TurningPasses> readPasses(const nlohmann::json& listed, const Container& container, Progress progress);

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <filesystem>

namespace handwheel {

// VersionNewer when a container stands there that a newer program wrote: to write over it would lose what only that one
// knows. Anything else may be replaced, or fails to be for reasons of its own. Reads the file, but unpacks its manifest
// only.
Status mayReplace(const std::filesystem::path& path);

}  // namespace handwheel

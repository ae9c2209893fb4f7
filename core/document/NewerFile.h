// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <filesystem>

namespace handwheel {

// Checks that a file was not written by a newer program. Errors: VersionNewer for a container of a newer program,
// because overwriting it would lose the parts that only that program knows. All other files pass, even if they cannot
// be read. Reads the whole file, but unpacks only the manifest.
Status checkNotNewer(const std::filesystem::path& path);

}  // namespace handwheel

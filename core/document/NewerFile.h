// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <filesystem>

namespace handwheel {

// Checks that a file was not written by a newer program. Errors: VersionNewer for such a container: overwriting it
// would lose the parts that only that program knows. Any other file may be replaced, or cannot be for other reasons.
// Reads the file, but unpacks its manifest only.
Status checkNotNewer(const std::filesystem::path& path);

}  // namespace handwheel

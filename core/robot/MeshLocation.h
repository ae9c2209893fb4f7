// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <filesystem>
#include <string_view>

namespace handwheel {

// Resolves a mesh name in a robot description to a file. folder: that of the description. The forms of names:
//   package://name/rest, model://name/rest   "rest" in the nearest folder called "name" that lies in the description's
//                                            folder or in one above it; never outside that folder
//   file:///rest                             the absolute path, %20 and the like decoded
//   rest                                     from the description's folder; up by "../" at most four folders
// Errors: ReferenceMissing {"the mesh", name} if there is no such file, {"the package", name, folder} if there is
// no such package; Unsupported if the name leads outside these folders, or is of another kind.
Result<std::filesystem::path> locateMesh(std::string_view name, const std::filesystem::path& folder);

}  // namespace handwheel

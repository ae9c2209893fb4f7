// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <filesystem>
#include <string_view>

namespace handwheel {

// Resolves a mesh name in a robot description to a file. folder: that of the description. By the form of the name:
//   package://name/rest, model://name/rest   "rest" in the nearest folder called "name" that lies in the description's
//                                            folder or in one above it; never outside of that folder
//   file:///rest                             as it stands, %20 and its like decoded
//   rest                                     from the description's folder; up by "../" at most four folders
// Errors: ReferenceMissing {"the mesh", name} when there is no such file, {"the package", name, folder} when there is
// no such package; Unsupported when the name leads where it may not, or is of another kind.
Result<std::filesystem::path> locateMesh(std::string_view name, const std::filesystem::path& folder);

}  // namespace handwheel

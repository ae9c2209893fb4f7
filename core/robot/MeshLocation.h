// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <filesystem>
#include <string_view>

namespace handwheel {

// Resolves a mesh name in a robot description to a file. folder: the folder of the description. Names have these forms:
//   package://name/rest, model://name/rest   "rest" in the nearest folder called "name" that lies in the description's
//                                            folder or in a folder above it; "rest" may not leave the package
//   file:///rest                             an absolute path, in which %20 and other escapes are decoded
//   rest                                     a path relative to the description's folder, with at most four "../"
// Errors: ReferenceMissing {"the mesh", name} if there is no such file, {"the package", name, folder} if there is
// no such package; Unsupported if the name leads outside these folders, or has another form.
Result<std::filesystem::path> locateMesh(std::string_view name, const std::filesystem::path& folder);

}  // namespace handwheel

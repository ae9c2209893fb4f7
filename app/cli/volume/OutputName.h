// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace handwheel {

// Returns true if a path has one of these extensions (such as ".vdb"), ignoring case.
bool hasOneOf(const std::filesystem::path& path, const std::vector<std::string>& endings);

}  // namespace handwheel

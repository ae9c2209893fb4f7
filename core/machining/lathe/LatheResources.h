// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace handwheel {

// Returns the text of the file resources/machining/tools.json, which is built into the library.
std::string_view latheToolsResource();

}  // namespace handwheel

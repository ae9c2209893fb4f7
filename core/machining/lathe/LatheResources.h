// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace handwheel {

// The file resources/machining/tools.json.
std::string_view latheToolsResource();

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace handwheel {

// The file of resources/drilling, which is built into the library.
std::string_view drillMaterialsResource();  // materials.json

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace handwheel {

// The files of resources/drilling, which are built into the library.
std::string_view drillMaterialsResource();  // materials.json
std::string_view drillBitsResource();       // tools.json

}  // namespace handwheel

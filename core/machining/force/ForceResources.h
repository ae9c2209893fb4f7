// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace handwheel {

// Return the files of resources/machining about forces, which are built into the library.
std::string_view kosilovaResource();    // kosilova.json
std::string_view materialsResource();   // materials.json
std::string_view forceModelResource();  // force-model.json

}  // namespace handwheel

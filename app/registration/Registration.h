// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/KindUi.h"

namespace handwheel {

// Every kind of document that the program knows: the one place to add another. They are asked in this order whose a
// file is; meshes take what nobody else does.
std::vector<KindEntry> registeredKinds();

}  // namespace handwheel

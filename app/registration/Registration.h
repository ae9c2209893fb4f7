// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/kinds/KindUi.h"

namespace handwheel {

// All kinds of documents of the program. The one place to add further ones. They are asked in this order whether a file
// is theirs; meshes take what no other kind takes.
std::vector<KindEntry> registeredKinds();

}  // namespace handwheel

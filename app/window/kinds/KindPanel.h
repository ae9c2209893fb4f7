// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/kinds/KindUi.h"

namespace handwheel {

// Brings the panel of the kind before the panels that share its place. One that a person has closed stays so.
void raiseKindPanel(const WindowContext& window);
// Also one that was closed, for kinds that are worked on in it.
void showKindPanel(const WindowContext& window);

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/kinds/KindUi.h"

namespace handwheel {

// Raises the panel of the kind above the panels that share its dock area. A panel closed by the user stays closed.
void raiseKindPanel(const WindowContext& window);
// Raises the panel even if the user has closed it, for kinds whose work is done in the panel.
void showKindPanel(const WindowContext& window);

}  // namespace handwheel

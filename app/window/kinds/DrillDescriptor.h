// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/kinds/KindUi.h"

namespace handwheel {

// Returns the descriptor of the tool for drilling by hand, which several kinds offer.
ToolDescriptor drillToolDescriptor(std::function<std::unique_ptr<Tool>()> make);

}  // namespace handwheel

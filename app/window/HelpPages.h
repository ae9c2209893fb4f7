// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/HintBar.h"

class QMainWindow;

namespace handwheel {

// Functions that show the help windows, which are not modal.

// Shows the present mouse and key bindings, and the shortcuts of all menu commands.
void showKeys(QMainWindow& window, const std::vector<Hint>& now);
// Shows the version and licence of the program.
void showAbout(QMainWindow& window);

}  // namespace handwheel

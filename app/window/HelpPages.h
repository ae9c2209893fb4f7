// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/HintBar.h"

class QMainWindow;

namespace handwheel {

// Small windows that stay open beside the work.

// What the mouse and the keys do now, and the present keys of all commands in the menus.
void showKeys(QMainWindow& window, const std::vector<Hint>& now);
void showAbout(QMainWindow& window);

}  // namespace handwheel

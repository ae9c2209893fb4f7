// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace handwheel {

class MainWindow;

// Waits until everything asked for is open and drawn, saves a picture of the window and ends the program: exit code 1
// when the picture could not be written.
void takeScreenshot(MainWindow& window, const QString& path);

}  // namespace handwheel

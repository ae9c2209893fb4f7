// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace handwheel {

class MainWindow;

// Saves a picture of the window and ends the program. Waits until all requested files are open and drawn. The exit code
// is 1 if the picture could not be written.
void takeScreenshot(MainWindow& window, const QString& path);

}  // namespace handwheel

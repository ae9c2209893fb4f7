// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

class QDockWidget;
class QMainWindow;

namespace handwheel {

// Restores size, position and panels of the window from the settings. At the first start the window is maximised on a
// screen too small for its default size. The given docks are then hidden if the window is small, so that the viewport
// keeps most of it; the last of them, the Log, is always hidden.
void restoreLayout(QMainWindow& window, const QList<QDockWidget*>& foldable);
// Stores size, position and panels of the window in the settings.
void saveLayout(const QMainWindow& window);

}  // namespace handwheel

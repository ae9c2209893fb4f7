// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

class QDockWidget;
class QMainWindow;

namespace handwheel {

// Size, place and panels of the window, remembered over restarts. At the first start the window fills a screen that is
// too small for its usual size; the given docks are folded away where the window is small, so that the viewport keeps
// most of the window; the Log always is.
void restoreLayout(QMainWindow& window, const QList<QDockWidget*>& foldable);
void saveLayout(const QMainWindow& window);

}  // namespace handwheel

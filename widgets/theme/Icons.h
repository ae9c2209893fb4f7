// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>

namespace handwheel {

// Returns an icon from resources/icons, by file name without extension. It is drawn with the text colour of the present
// palette (the accent when checked), so it follows a change of the theme automatically.
QIcon icon(const QString& name);

// Returns an icon in a fixed colour, for defects and states.
QIcon icon(const QString& name, const QColor& colour);

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace handwheel {

// Returns a file name made from words of the user. It is valid on any system: "Your first shoulder, Ada.handwheel".
// ending: the extension without the dot.
QString fileNameOf(const QStringList& words, const QString& ending);

}  // namespace handwheel

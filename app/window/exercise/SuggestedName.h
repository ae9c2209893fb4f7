// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace handwheel {

// A name for a file from what people have written, which any system takes: "Your first shoulder, Ada.handwheel".
// ending: without the dot.
QString fileNameOf(const QStringList& words, const QString& ending);

}  // namespace handwheel

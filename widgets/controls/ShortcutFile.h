// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>

#include "base/Result.h"

namespace handwheel {

// Shortcuts that differ from the defaults, by the id of the action. They are written in Qt's portable form
// ("Ctrl+Shift+Z"). An empty list means that the action has no shortcut.
using ShortcutChanges = QMap<QString, QStringList>;

inline constexpr qint64 kLargestShortcutFile = 1 << 20;  // bytes

// Converts the changes to JSON.
QByteArray toJson(const ShortcutChanges& changes);

// Reads the changes from JSON. Errors: FileTooLarge, FormatUnknown, VersionNewer, ElementMalformed.
Result<ShortcutChanges> shortcutsFromJson(const QByteArray& json);

}  // namespace handwheel

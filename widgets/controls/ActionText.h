// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QList>
#include <QString>

class QAction;
class QMenuBar;
class QObject;

namespace handwheel {

// The text of an action or a menu without its mnemonic.
QString withoutMnemonic(const QString& text);

// The menus that lead to each action: "View › Shading".
QHash<const QAction*, QString> menuPaths(const QMenuBar* bar);

// The program's own actions below this object: those that have a name and a text. Menus and separators are none.
QList<QAction*> namedActions(const QObject& root);

}  // namespace handwheel

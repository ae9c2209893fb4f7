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

// The menus that lead to each action: "View › Shading". Of several, that which is seen.
QHash<const QAction*, QString> menuPaths(const QMenuBar* bar);

// That of one action among these paths; one that is there only in a scope has its own.
QString pathOf(const QAction& action, const QHash<const QAction*, QString>& menuPaths);

// Whether it is a command of the program: with a name and a text, and not one of Qt's own, a menu or a separator.
bool isCommand(const QAction& action);

// Those below this object.
QList<QAction*> commandsOf(const QObject& root);

}  // namespace handwheel

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

// Returns the text of an action or a menu without its mnemonic.
QString withoutMnemonic(const QString& text);

// Returns the menu path of each action: "View › Shading". For an action in several menus, the path is through the
// visible menu.
QHash<const QAction*, QString> menuPaths(const QMenuBar* bar);

// Returns the path of one action: the path of a ContextAction, or its path in menuPaths.
QString pathOf(const QAction& action, const QHash<const QAction*, QString>& menuPaths);

// Returns true if the action is a command of the program. It has a name and a text, and is not an action of Qt itself,
// a menu or a separator.
bool isCommand(const QAction& action);

// Returns the commands among the children of an object, including indirect children.
QList<QAction*> commandsOf(const QObject& root);

}  // namespace handwheel

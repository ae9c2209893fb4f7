// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/ActionText.h"

#include "controls/ContextAction.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <algorithm>

namespace handwheel {

namespace {

void collect(const QList<QAction*>& actions, const QString& path, QHash<const QAction*, QString>& paths) {
  for (const QAction* action : actions) {
    if (!action->menu()) {
      if (!paths.contains(action)) paths.insert(action, path);
      continue;
    }
    const QString title = withoutMnemonic(action->text());
    collect(action->menu()->actions(), path.isEmpty() ? title : path + QStringLiteral(" › ") + title, paths);
  }
}

}  // namespace

QString withoutMnemonic(const QString& text) {
  // Chinese and Japanese append it in brackets: 文件(&F).
  static const QRegularExpression kAppended(QStringLiteral(R"(\s*\(&\w\))"));
  static const QRegularExpression kMark(QStringLiteral("&(.)"));
  return QString(text).remove(kAppended).replace(kMark, QStringLiteral("\\1"));
}

QHash<const QAction*, QString> menuPaths(const QMenuBar* bar) {
  QHash<const QAction*, QString> paths;
  if (!bar) return paths;
  QList<QAction*> menus = bar->actions();
  std::stable_partition(menus.begin(), menus.end(), [](const QAction* menu) { return menu->isVisible(); });
  collect(menus, {}, paths);
  return paths;
}

QString pathOf(const QAction& action, const QHash<const QAction*, QString>& menuPaths) {
  const auto* scoped = qobject_cast<const ContextAction*>(&action);
  return scoped ? scoped->path() : menuPaths.value(&action);
}

bool isCommand(const QAction& action) {
  // Qt names the actions of its own widgets with an underscore or "qt_" in front.
  const QString name = action.objectName();
  return !name.isEmpty() && !name.startsWith(QLatin1Char('_')) && !name.startsWith(QLatin1String("qt_")) &&
         !action.text().isEmpty() && !action.isSeparator() && !action.menu();
}

QList<QAction*> commandsOf(const QObject& root) {
  QList<QAction*> commands = root.findChildren<QAction*>();
  commands.removeIf([](const QAction* action) { return !isCommand(*action); });
  return commands;
}

}  // namespace handwheel

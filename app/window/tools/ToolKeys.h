// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/ToolKey.h"

#include <QKeySequence>
#include <QObject>
#include <QPointer>
#include <map>
#include <string>

class QAction;
class QKeyEvent;
class QWidget;

namespace handwheel {

class ContextAction;

// The keys of all tools as actions of the window. Therefore they can be listed, searched and changed like its other
// commands. They are visible while their tool declares them.
class ToolKeys : public QObject {
  Q_OBJECT

 public:
  // view: the widget that receives the keys of the tools.
  ToolKeys(QWidget& view, QObject* parent);

  // Adds the keys of a tool with this title and Tool::id(). Repeated calls have no effect.
  void add(const QString& title, const std::string& tool, std::span<const ToolKey> keys);
  // Enables the keys of the actions that the tool declares. Null: no tool is running.
  void follow(const Tool* tool, const std::vector<ToolAction>& declared);

  // Returns the key of an action in native text; empty if it has none.
  QString text(const Tool& tool, const ToolAction& action);
  // Returns the enabled action of a key; none if there is no action, or more than one.
  std::optional<ToolAction> actionFor(const Tool& tool, const QKeyEvent& event);
  // Returns true if an action that is not enabled at present has the key, and it is one that ends an operation: Return,
  // Enter or Esc. No command of the window may have it in the meantime.
  bool isReserved(const Tool& tool, const QKeyEvent& event);

 signals:
  void triggered(const std::string& action);  // emitted for other triggers than the keyboard
  void changed();                             // a key was changed

 private:
  QList<QKeySequence> keysOf(const Tool& tool, const ToolAction& action);
  QAction* command(const std::string& name);  // command of the window; null if there is none
  void watch(QAction& action);

  QWidget& m_view;
  std::map<std::string, std::map<std::string, ContextAction*>> m_actions;  // by tool and action
  std::map<std::string, QPointer<QAction>> m_commands;
};

}  // namespace handwheel

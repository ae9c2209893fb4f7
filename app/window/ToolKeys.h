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

class ScopedAction;

// The keys of all tools as actions of the window: so they are listed, searched and changed like its other commands.
// They are visible while their tool declares them.
class ToolKeys : public QObject {
  Q_OBJECT

 public:
  // view: gets the keys of the tools.
  ToolKeys(QWidget& view, QObject* parent);

  // Of a tool of this title and Tool::id(). Once more does no harm.
  void add(const QString& title, const std::string& tool, std::span<const ToolKey> keys);
  // Which of them can be used now: what the tool declares. Null: no tool is running.
  void follow(const Tool* tool, const std::vector<ToolAction>& declared);

  // The key of an action as the user's system writes it; empty when it has none.
  QString text(const Tool& tool, const ToolAction& action);
  // What the key does now; none: nothing, or two things at once.
  std::optional<ToolAction> actionFor(const Tool& tool, const QKeyEvent& event);

 signals:
  void triggered(const std::string& action);  // from elsewhere than the keyboard
  void changed();                             // a key

 private:
  QList<QKeySequence> keysOf(const Tool& tool, const ToolAction& action);
  QAction* command(const std::string& name);  // of the window; null when there is none
  void watch(QAction& action);

  QWidget& m_view;
  std::map<std::string, std::map<std::string, ScopedAction*>> m_actions;  // by tool and action
  std::map<std::string, QPointer<QAction>> m_commands;
};

// Whether the tool takes the key from the window's commands. They come first where both do the same, and where a key
// ends something: what is chosen in a list, before what is done in the tool.
bool comesFirst(const ToolAction& action, const QKeyEvent& event);

}  // namespace handwheel

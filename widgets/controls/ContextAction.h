// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>

namespace handwheel {

// An action that is available only within a scope, such as a tool. While such an action is not added to a widget, Qt
// does not handle its shortcut. In this case, the code that receives the key events of the scope compares them with the
// shortcuts of its actions.
class ContextAction : public QAction {
  Q_OBJECT

 public:
  // scope: the displayed name of the scope, such as "Select faces"; path: the text shown before the name of the action
  // in lists, such as "Tools › Select faces".
  ContextAction(const QString& text, QString scope, QString path, QObject* parent);

  const QString& scope() const { return m_scope; }
  const QString& path() const { return m_path; }

 private:
  QString m_scope;
  QString m_path;
};

// Returns true if the sequence uses Return, Enter or Esc. These keys end the present operation, and are reserved for
// the commands that have them by default.
bool isEndingKey(const QKeySequence& keys);

}  // namespace handwheel

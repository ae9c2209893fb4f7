// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>

namespace handwheel {

// An action that is available only within a scope, such as a tool. While it is added to no widget, Qt does not handle
// its shortcut; the code that receives the key events of the scope looks them up here.
class ContextAction : public QAction {
  Q_OBJECT

 public:
  // scope: its displayed name, "Select faces"; path: shown before the text in lists, "Tools › Select faces".
  ContextAction(const QString& text, QString scope, QString path, QObject* parent);

  const QString& scope() const { return m_scope; }
  const QString& path() const { return m_path; }

 private:
  QString m_scope;
  QString m_path;
};

// Returns true if the sequence uses Return, Enter or Esc. These end the present operation: they are reserved for the
// commands that have them by default.
bool isEndingKey(const QKeySequence& keys);

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>

namespace handwheel {

// A command that is there only while something is in use, its scope: a tool. As long as it is in no widget its keys are
// none of Qt's; whoever gets the keys in that scope looks them up here.
class ScopedAction : public QAction {
  Q_OBJECT

 public:
  // scope: as the user knows it, "Select faces"; path: what stands before the text in lists, "Tools › Select faces".
  ScopedAction(const QString& text, QString scope, QString path, QObject* parent);

  const QString& scope() const { return m_scope; }
  const QString& path() const { return m_path; }

 private:
  QString m_scope;
  QString m_path;
};

// Whether Return, Enter or Esc is pressed for it. These end whatever one does: they stay with the commands that have
// them from the beginning, and no other can have them.
bool isEndingKey(const QKeySequence& keys);

}  // namespace handwheel

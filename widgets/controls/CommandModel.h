// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <QHash>
#include <QPointer>
#include <QStringList>
#include <vector>

#include "controls/CommandSearch.h"

class QAction;

namespace handwheel {

// The name of the property of an action that says why it is disabled, translated. Without it the tool tip is said.
inline constexpr const char* kDisabledReason = "disabledReason";

// The list of actions that match the search text, best first.
class CommandModel : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role {
    PathRole = Qt::UserRole,  // its menu path
    ShortcutRole,
    ReasonRole,  // why it is disabled; empty when it is enabled
  };

  using QAbstractListModel::QAbstractListModel;

  // Invisible actions are left out.
  void setActions(const QList<QAction*>& actions, const QHash<const QAction*, QString>& paths);
  void setRecent(const QStringList& ids) { m_recent = ids; }
  void setQuery(const QString& query);
  QAction* action(const QModelIndex& index) const;  // null: the action was deleted

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  struct Command {
    QPointer<QAction> action;
    QString path;
  };
  std::vector<Command> m_commands;
  CommandSearch m_search;
  QStringList m_recent;
  std::vector<int> m_found;
};

}  // namespace handwheel

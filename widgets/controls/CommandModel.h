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

// Name of the action property with the translated reason why the action is disabled. For an action without this
// property, the tooltip is shown.
inline constexpr const char* kDisabledReason = "disabledReason";

// A list model of the actions that match the search text, best first.
class CommandModel : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role {
    PathRole = Qt::UserRole,  // its menu path
    ShortcutRole,
    ReasonRole,  // the reason if it is disabled; else empty
  };

  using QAbstractListModel::QAbstractListModel;

  // Sets the actions and their menu paths. Invisible actions are omitted.
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

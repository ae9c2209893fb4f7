// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QKeySequence>
#include <QPointer>
#include <vector>

#include "controls/ShortcutFile.h"

class QAction;
class QMenuBar;

namespace handwheel {

// The keys of all named actions of the program. What the user changes takes effect at once and is kept in the settings,
// as far as it differs from the defaults.
class ShortcutModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Command, Keys, ColumnCount };
  enum Role { ConflictRole = Qt::UserRole, ChangedRole, IdRole, PathRole };

  using QAbstractTableModel::QAbstractTableModel;

  // Of these, the commands. The present keys of those that are new here are their defaults; then those of the user are
  // applied. To be called again when actions have come.
  void setActions(const QList<QAction*>& actions, const QMenuBar* menus);

  QList<QKeySequence> keys(int row) const;
  void setKeys(int row, const QList<QKeySequence>& keys);
  void reset(int row);
  void resetAll();

  // The other rows that one of these keys, or its beginning, would start as well.
  QList<int> conflicts(int row) const;
  // Takes from those what they have in common with this row.
  void resolveInFavourOf(int row);

  ShortcutChanges changes() const;
  // Replaces all changes; ids that are not known here are left out.
  void setChanges(const ShortcutChanges& changes);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Entry {
    QPointer<QAction> action;
    QString id;
    QString title;
    QString path;
    QList<QKeySequence> defaults;
  };
  Entry entryOf(QAction* action, const QString& path) const;
  void apply(const Entry& entry, const QList<QKeySequence>& keys);
  void announce();

  std::vector<Entry> m_entries;
};

}  // namespace handwheel

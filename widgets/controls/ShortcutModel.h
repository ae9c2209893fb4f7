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
  enum Role {
    ConflictRole = Qt::UserRole,  // the names of the rows of conflicts()
    AmbiguousRole,                // whether one of these is there at the same time, so that neither works
    ChangedRole,
    FixedRole,  // its key cannot be changed
    IdRole,
    PathRole,
  };

  using QAbstractTableModel::QAbstractTableModel;

  // Of these, the commands. The present keys of those that are new here are their defaults; then those of the user are
  // applied, as far as they are keys that the command may have. To be called again when actions have come.
  void setActions(const QList<QAction*>& actions, const QMenuBar* menus);

  QList<QKeySequence> keys(int row) const;
  // Without those that the row may not have.
  void setKeys(int row, const QList<QKeySequence>& keys);
  // Why the row may not have the key, as a sentence; empty when it may.
  QString objection(int row, const QKeySequence& key) const;
  void reset(int row);
  void resetAll();

  // The other rows that one of these keys, or its beginning, would start as well. Commands of two scopes are never
  // there at the same time.
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
    QString scope;  // empty: there at any time
    QList<QKeySequence> defaults;
  };
  Entry entryOf(QAction* action, const QString& path) const;
  const Entry& entry(int row) const { return m_entries[static_cast<std::size_t>(row)]; }
  static bool isFixed(const Entry& entry);
  static QString objection(const Entry& entry, const QKeySequence& key);
  static QList<QKeySequence> possibleOf(const Entry& entry, QList<QKeySequence> keys);
  static bool areTogether(const Entry& a, const Entry& b);
  static QString nameOf(const Entry& entry);
  void apply(const Entry& entry, const QList<QKeySequence>& keys);
  void announce();

  std::vector<Entry> m_entries;
};

}  // namespace handwheel

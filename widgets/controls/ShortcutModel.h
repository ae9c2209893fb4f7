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

// A table model of the shortcuts of all named actions. Changes take effect at once; those that differ from the defaults
// are stored in the settings.
class ShortcutModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Command, Keys, ColumnCount };
  enum Role {
    ConflictRole = Qt::UserRole,  // the names of the rows that conflicts() returns
    AmbiguousRole,  // true if a conflicting command is active at the same time, so that the key triggers no command
    ChangedRole,
    FixedRole,  // true if the shortcut cannot be changed
    IdRole,
    PathRole,
  };

  using QAbstractTableModel::QAbstractTableModel;

  // Sets the actions; only commands are listed. The present keys of new actions become their defaults; then the user's
  // keys are applied, except those that the command may not have. To be called again after actions have been added.
  void setActions(const QList<QAction*>& actions, const QMenuBar* menus);

  QList<QKeySequence> keys(int row) const;
  // Sets the keys of a row, except those that the row may not have.
  void setKeys(int row, const QList<QKeySequence>& keys);
  // Returns a sentence that states why the row may not have the key. The result is empty if the key is allowed.
  QString objection(int row, const QKeySequence& key) const;
  void reset(int row);
  void resetAll();

  // Returns the other rows that a key of this row, or a prefix of it, also triggers. Commands of two scopes are never
  // active at the same time.
  QList<int> conflicts(int row) const;
  // Removes the keys that conflict with this row from the other rows.
  void resolveInFavourOf(int row);

  ShortcutChanges changes() const;
  // Replaces all changes of the shortcuts. Unknown ids are skipped.
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
    QString scope;  // name of the scope; empty: always active
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

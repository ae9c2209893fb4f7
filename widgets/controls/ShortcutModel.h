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
    AmbiguousRole,                // true if one of these is active at the same time, so that neither works
    ChangedRole,
    FixedRole,  // its key cannot be changed
    IdRole,
    PathRole,
  };

  using QAbstractTableModel::QAbstractTableModel;

  // Sets the actions; only commands are listed. The present keys of new actions become their defaults; then the user's
  // keys are applied, as far as the command may have them. To be called again when actions were added.
  void setActions(const QList<QAction*>& actions, const QMenuBar* menus);

  QList<QKeySequence> keys(int row) const;
  // Sets the keys, without those that the row may not have.
  void setKeys(int row, const QList<QKeySequence>& keys);
  // Returns the reason why the row may not have the key, as a sentence; empty when it may.
  QString objection(int row, const QKeySequence& key) const;
  void reset(int row);
  void resetAll();

  // Returns the other rows that a key of this row, or a prefix of it, also triggers. Commands of two scopes are never
  // active at the same time.
  QList<int> conflicts(int row) const;
  // Removes from the conflicting rows the keys they share with this row.
  void resolveInFavourOf(int row);

  ShortcutChanges changes() const;
  // Replaces all changes; unknown ids are skipped.
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
    QString scope;  // empty: always active
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

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSortFilterProxyModel>
#include <QWidget>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeView;

namespace handwheel {

class ShortcutModel;

// A widget that lists all commands and edits their shortcuts. Every change is applied at once.
class ShortcutEditor : public QWidget {
  Q_OBJECT

 public:
  explicit ShortcutEditor(ShortcutModel* model, QWidget* parent = nullptr);

 private:
  void buildKeyLine(QLayout& column);
  void buildFileLine(QLayout& column);
  int row() const;  // selected row of the model; -1: none
  void showRow();
  void useKey();
  void importFile();
  void exportFile();
  void say(const QString& what, bool wrong);

  ShortcutModel* m_model;
  QSortFilterProxyModel m_filtered;
  QTreeView* m_list;
  QKeySequenceEdit* m_keys;
  QPushButton* m_none;
  QPushButton* m_reset;
  QPushButton* m_take;
  QLabel* m_status;
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/ResultModel.h"

#include <QTreeView>

namespace handwheel {

// A table of results, such as the marks of a class. The first column, which names the owners of the results, stays
// visible while the others scroll. Clicks on headings and the menu of the table sort it. Ctrl+C copies the selected
// rows with the headings, separated by tabs for spreadsheets.
class ResultTable : public QTreeView {
  Q_OBJECT

 public:
  explicit ResultTable(QWidget* parent = nullptr);

  void setTable(QStringList headings, std::vector<ResultModel::Row> rows);
  // Returns the selected rows, or all if none is selected, with the headings. A text that a spreadsheet would take for
  // a formula gets an apostrophe in front.
  QString copyText() const;

 signals:
  void rowActivated(std::size_t row);  // row: index in the table that was set

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void copy();
  void keepFirstColumn();
  void placeFirstColumn();

  ResultModel* m_model;
  QTreeView* m_first;  // a view of the first column that lies over the others
};

}  // namespace handwheel

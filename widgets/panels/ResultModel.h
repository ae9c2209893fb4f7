// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <optional>
#include <vector>

namespace handwheel {

// A cell of a table of results: its text, and its number if any.
struct ResultCell {
  enum class State { Plain, Good, Bad };
  QString text;
  std::optional<double> number = {};
  State state = State::Plain;
  QString reason = {};  // tool tip
};

// A table of results as a model that can be sorted by any column. Numbers are sorted by value and texts in the order of
// the locale. Empty cells come last in both directions, and equal rows keep their order.
class ResultModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using Row = std::vector<ResultCell>;
  using QAbstractTableModel::QAbstractTableModel;

  // Sets the table. Rows that are too short are filled up with empty cells. The present sorting is applied to the new
  // table.
  void setTable(QStringList headings, std::vector<Row> rows);

  // Returns the index in the table passed to setTable() of a displayed row.
  std::size_t source(int row) const { return m_order[static_cast<std::size_t>(row)]; }
  bool isNumber(int row, int column) const { return cell(source(row), column).number.has_value(); }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  void sort(int column, Qt::SortOrder order) override;

 private:
  const ResultCell& cell(std::size_t row, int column) const;
  void order();

  QStringList m_headings;
  std::vector<Row> m_rows;
  std::vector<std::size_t> m_order;
  int m_sorted = -1;  // sorted column; -1: not sorted
  Qt::SortOrder m_direction = Qt::AscendingOrder;
};

}  // namespace handwheel

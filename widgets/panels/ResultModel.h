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

// A table of results as a model, sorted by any column. Numbers by value, texts as the locale sorts them, empty cells
// last in both directions; rows that are equal keep their order.
class ResultModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using Row = std::vector<ResultCell>;
  using QAbstractTableModel::QAbstractTableModel;

  // Sets the table. Rows that are too short end with empty cells. The sorting stays.
  void setTable(QStringList headings, std::vector<Row> rows);

  // Returns the row of the table that was set for a displayed row.
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
  int m_sorted = -1;  // column; -1: not sorted
  Qt::SortOrder m_direction = Qt::AscendingOrder;
};

}  // namespace handwheel

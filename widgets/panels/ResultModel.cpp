// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ResultModel.h"

#include "theme/Theme.h"

#include <QCollator>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace handwheel {

namespace {

bool isNothing(const ResultCell& cell) {
  return cell.number ? !std::isfinite(*cell.number) : cell.text.isEmpty();
}

}  // namespace

void ResultModel::setTable(QStringList headings, std::vector<Row> rows) {
  beginResetModel();
  m_headings = std::move(headings);
  m_rows = std::move(rows);
  if (m_sorted >= m_headings.size()) m_sorted = -1;
  order();
  endResetModel();
}

const ResultCell& ResultModel::cell(std::size_t row, int column) const {
  static const ResultCell none;
  const Row& cells = m_rows[row];
  const auto at = static_cast<std::size_t>(column);
  return column >= 0 && at < cells.size() ? cells[at] : none;
}

void ResultModel::order() {
  m_order.resize(m_rows.size());
  std::iota(m_order.begin(), m_order.end(), std::size_t(0));
  if (m_sorted < 0) return;
  QCollator collator;
  collator.setNumericMode(true);
  collator.setCaseSensitivity(Qt::CaseInsensitive);
  const bool isDown = m_direction == Qt::DescendingOrder;
  std::stable_sort(m_order.begin(), m_order.end(), [&](std::size_t one, std::size_t other) {
    const ResultCell *a = &cell(one, m_sorted), *b = &cell(other, m_sorted);
    if (isNothing(*a) || isNothing(*b)) return !isNothing(*a) && isNothing(*b);
    if (isDown) std::swap(a, b);
    if (a->number && b->number) return *a->number < *b->number;
    if (a->number.has_value() != b->number.has_value()) return a->number.has_value();
    return collator.compare(a->text, b->text) < 0;
  });
}

int ResultModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int ResultModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_headings.size());
}

QVariant ResultModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const ResultCell& shown = cell(source(index.row()), index.column());
  const ThemeColours& colours = themeColours(currentTheme());
  switch (role) {
    case Qt::DisplayRole:
      return shown.text;
    case Qt::ToolTipRole:
      return shown.reason;
    case Qt::TextAlignmentRole:
      return static_cast<int>((shown.number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::ForegroundRole:
      if (shown.state == ResultCell::State::Good) return colours.success;
      if (shown.state == ResultCell::State::Bad) return colours.error;
      return {};
    default:
      return {};
  }
}

QVariant ResultModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::DisplayRole) return m_headings.value(section);
  if (role != Qt::TextAlignmentRole) return {};
  const auto isNumber = [&](const Row& row) {
    const auto at = static_cast<std::size_t>(section);
    return at < row.size() && row[at].number;
  };
  const bool isNumeric = std::any_of(m_rows.begin(), m_rows.end(), isNumber);
  return static_cast<int>((isNumeric ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
}

void ResultModel::sort(int column, Qt::SortOrder direction) {
  emit layoutAboutToBeChanged();
  const QModelIndexList before = persistentIndexList();
  std::vector<std::size_t> rows;
  for (const QModelIndex& index : before) rows.push_back(source(index.row()));
  m_sorted = column < m_headings.size() ? column : -1;
  m_direction = direction;
  order();
  for (qsizetype i = 0; i < before.size(); ++i) {
    const auto at = std::find(m_order.begin(), m_order.end(), rows[static_cast<std::size_t>(i)]);
    changePersistentIndex(before[i], index(static_cast<int>(at - m_order.begin()), before[i].column()));
  }
  emit layoutChanged();
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/LogModel.h"

#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QFontDatabase>

namespace handwheel {

namespace {
enum Column { Time, Event, Command, Columns };
}

void LogModel::add(const QString& text, const QString& command, LogEntry::Weight weight) {
  const int row = rowCount();
  beginInsertRows({}, row, row);
  m_entries.push_back({QTime::currentTime(), weight, text, command});
  endInsertRows();
}

int LogModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_entries.size());
}

int LogModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : Columns;
}

QVariant LogModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const LogEntry& entry = m_entries[static_cast<std::size_t>(index.row())];
  const ThemeColours& colours = themeColours(currentTheme());
  const QString text = index.column() == Time    ? entry.time.toString(QStringLiteral("HH:mm:ss"))
                       : index.column() == Event ? entry.text
                                                 : entry.command;
  switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
      return text;
    case Qt::ForegroundRole:
      return index.column() == Time ? colours.muted : colours.text;
    case Qt::FontRole:
      return index.column() == Command ? QFontDatabase::systemFont(QFontDatabase::FixedFont) : QVariant();
    case Qt::DecorationRole:
      if (index.column() != Event || entry.weight == LogEntry::Weight::Info) return {};
      return entry.weight == LogEntry::Weight::Error ? icon(QStringLiteral("error"), colours.error)
                                                     : icon(QStringLiteral("warning"), colours.warning);
    default:
      return {};
  }
}

QVariant LogModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return section == Time ? tr("Time") : section == Event ? tr("Event") : tr("Command line");
}

}  // namespace handwheel

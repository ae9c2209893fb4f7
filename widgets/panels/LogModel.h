// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QDateTime>
#include <vector>

namespace handwheel {

// One entry of the log.
struct LogEntry {
  enum class Weight { Info, Warning, Error };
  QTime time;
  Weight weight = Weight::Info;
  QString text;
  QString command;  // the equivalent command line; empty if there is none
};

// A table model of the events since the program was started. Each row shows the time, the event, and the equivalent
// command line. The newest event is last.
class LogModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;

  void add(const QString& text, const QString& command = {}, LogEntry::Weight weight = LogEntry::Weight::Info);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<LogEntry> m_entries;
};

}  // namespace handwheel

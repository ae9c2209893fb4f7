// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <vector>

namespace handwheel {

// The present state and cost of a background service.
struct ServiceStatus {
  enum class Budget { None, Frame, ServoTick };
  QString id;
  QString name;  // translated
  bool running = false;
  double ticksPerSecond = 0.0;
  double microsecondsPerTick = 0.0;
  Budget budget = Budget::None;
  double share = 0.0;   // fraction of the budget; 1: all of it
  double behind = 0.0;  // fraction of the time by which it is behind
  int dropped = 0;      // inputs that it had no room for
};

// A table model of the background services. New statistics of the same services keep rows and selection.
class ServiceModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Name, State, Ticks, Cost, Share, ColumnCount };
  enum Role { ShareRole = Qt::UserRole };  // share of the budget, as a number; none without a budget

  using QAbstractTableModel::QAbstractTableModel;

  void setServices(std::vector<ServiceStatus> services);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<ServiceStatus> m_services;
};

}  // namespace handwheel

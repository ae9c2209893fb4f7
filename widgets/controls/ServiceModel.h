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
  double share = 0.0;   // fraction of the budget that is used; 1: all of the budget
  double behind = 0.0;  // seconds lost by late ticks, per second; 0: the service is fast enough
  int dropped = 0;      // number of inputs that the service did not accept in time
};

// A table model of the background services. Setting new statistics of the same services keeps rows and selection.
class ServiceModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Name, State, Ticks, Cost, Share, ColumnCount };
  enum Role { ShareRole = Qt::UserRole };  // used fraction of the budget, as a number; invalid: no budget

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

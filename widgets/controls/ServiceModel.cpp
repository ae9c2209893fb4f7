// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/ServiceModel.h"

#include <QLocale>
#include <algorithm>

namespace handwheel {

namespace {

QString number(double value) {
  return QLocale().toString(value, 'f', value < 1.0 ? 2 : value < 10.0 ? 1 : 0);
}

QString shareText(const ServiceStatus& service) {
  if (!service.running) return {};
  const QString percent = number(service.share * 100.0);
  switch (service.budget) {
    case ServiceStatus::Budget::Frame:
      return ServiceModel::tr("%1 % of the frame").arg(percent);
    case ServiceStatus::Budget::ServoTick:
      return ServiceModel::tr("%1 % of the servo tick").arg(percent);
    case ServiceStatus::Budget::None:
      break;
  }
  return {};
}

QString stateText(const ServiceStatus& service) {
  constexpr double kSeen = 0.01;  // smaller delays come from the scheduler, and nobody notices them
  if (!service.running) return ServiceModel::tr("idle");
  QStringList troubles;
  if (service.behind >= kSeen) troubles << ServiceModel::tr("too slow by %1 %").arg(number(service.behind * 100.0));
  if (service.dropped > 0) troubles << ServiceModel::tr("%n input(s) dropped", nullptr, service.dropped);
  return troubles.isEmpty() ? ServiceModel::tr("running") : troubles.join(QStringLiteral(", "));
}

QString cell(const ServiceStatus& service, int column) {
  switch (column) {
    case ServiceModel::Name:
      return service.name;
    case ServiceModel::State:
      return stateText(service);
    case ServiceModel::Ticks:
      return service.running ? number(service.ticksPerSecond) : QString();
    case ServiceModel::Cost:
      return service.running ? number(service.microsecondsPerTick) : QString();
    case ServiceModel::Share:
      return shareText(service);
    default:
      return {};
  }
}

}  // namespace

void ServiceModel::setServices(std::vector<ServiceStatus> services) {
  const bool same = std::equal(services.begin(), services.end(), m_services.begin(), m_services.end(),
                               [](const ServiceStatus& a, const ServiceStatus& b) { return a.id == b.id; });
  if (!same) beginResetModel();
  m_services = std::move(services);
  if (!same) {
    endResetModel();
  } else if (!m_services.empty()) {
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  }
}

int ServiceModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_services.size());
}

int ServiceModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant ServiceModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const ServiceStatus& service = m_services[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return cell(service, index.column());
    case Qt::ToolTipRole:
      return service.id;
    case Qt::TextAlignmentRole: {
      const bool figure = index.column() == Ticks || index.column() == Cost;
      return QVariant::fromValue(Qt::Alignment(Qt::AlignVCenter | (figure ? Qt::AlignRight : Qt::AlignLeft)));
    }
    case ShareRole:
      if (index.column() != Share || !service.running || service.budget == ServiceStatus::Budget::None) return {};
      return service.share;
    default:
      return {};
  }
}

QVariant ServiceModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case Name:
      return tr("Service");
    case State:
      return tr("State");
    case Ticks:
      return tr("Ticks/s");
    case Cost:
      return tr("µs per tick");
    default:
      return tr("Share");
  }
}

}  // namespace handwheel

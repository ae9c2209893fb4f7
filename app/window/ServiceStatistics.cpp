// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/ServiceStatistics.h"

#include "window/WindowServices.h"

#include <QLocale>
#include <utility>

namespace handwheel {

namespace {

constexpr int kIntervalMs = 500;  // as in the panel

}  // namespace

ServiceStatistics::ServiceStatistics(const WindowServices& services, QWidget* parent)
    : QToolButton(parent), m_services(services) {
  setObjectName(QStringLiteral("serviceStatistics"));
  setAutoRaise(true);
  m_timer.setInterval(kIntervalMs);
  connect(&m_timer, &QTimer::timeout, this, &ServiceStatistics::refresh);
}

void ServiceStatistics::showEvent(QShowEvent* event) {
  refresh();
  m_timer.start();
  QToolButton::showEvent(event);
}

void ServiceStatistics::hideEvent(QHideEvent* event) {
  m_timer.stop();
  QToolButton::hideEvent(event);
}

void ServiceStatistics::refresh() {
  const double seconds = m_since.isValid() ? 1e-9 * static_cast<double>(m_since.nsecsElapsed()) : 0.0;
  m_since.start();
  double sum = 0.0;
  QStringList lines;
  std::map<QString, double> now;
  for (const auto& [name, microseconds] : m_services.costs()) {
    const auto before = m_before.find(name);
    const bool isKnown = before != m_before.end() && seconds > 0.0;
    const double rate = isKnown ? (microseconds - before->second) / seconds : 0.0;
    now[name] = microseconds;
    sum += rate;
    lines << tr("%1: %2 µs/s").arg(name, locale().toString(rate, 'f', 0));
  }
  m_before = std::move(now);
  setText(tr("%1 µs/s").arg(locale().toString(sum, 'f', 0)));
  setAccessibleName(tr("Services: %1").arg(text()));
  if (lines.isEmpty()) lines << tr("No service runs");
  setToolTip(tr("CPU time that what runs beside the window takes in a second") + QLatin1Char('\n') +
             lines.join(QLatin1Char('\n')));
}

}  // namespace handwheel

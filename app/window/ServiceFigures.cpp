// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/ServiceFigures.h"

#include "window/WindowServices.h"

#include <QLocale>

namespace handwheel {

namespace {

constexpr int kIntervalMs = 500;  // as in the panel

}  // namespace

ServiceFigures::ServiceFigures(const WindowServices& services, QWidget* parent)
    : QToolButton(parent), m_services(services) {
  setObjectName(QStringLiteral("serviceFigures"));
  setAutoRaise(true);
  m_timer.setInterval(kIntervalMs);
  connect(&m_timer, &QTimer::timeout, this, &ServiceFigures::refresh);
}

void ServiceFigures::showEvent(QShowEvent* event) {
  refresh();
  m_timer.start();
  QToolButton::showEvent(event);
}

void ServiceFigures::hideEvent(QHideEvent* event) {
  m_timer.stop();
  QToolButton::hideEvent(event);
}

void ServiceFigures::refresh() {
  double sum = 0.0;
  QStringList lines;
  for (const auto& [name, microseconds] : m_services.costs()) {
    sum += microseconds;
    lines << tr("%1: %2 µs").arg(name, locale().toString(microseconds, 'f', 0));
  }
  setText(tr("%1 µs").arg(locale().toString(sum, 'f', 0)));
  setAccessibleName(tr("Services: %1").arg(text()));
  if (lines.isEmpty()) lines << tr("No service runs");
  setToolTip(tr("CPU time of one tick of what runs beside the window") + QLatin1Char('\n') +
             lines.join(QLatin1Char('\n')));
}

}  // namespace handwheel

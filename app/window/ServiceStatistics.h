// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QToolButton>
#include <map>

namespace handwheel {

class WindowServices;

// A status bar button with the CPU time per second of all running services. A click opens the panel with the details.
class ServiceStatistics : public QToolButton {
  Q_OBJECT

 public:
  explicit ServiceStatistics(const WindowServices& services, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void refresh();

  const WindowServices& m_services;
  QTimer m_timer;
  QElapsedTimer m_since;               // the last refresh,
  std::map<QString, double> m_before;  // and the CPU time of each service by then, µs
};

}  // namespace handwheel

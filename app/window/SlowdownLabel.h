// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"

#include <QElapsedTimer>
#include <QLabel>
#include <QTimer>

namespace handwheel {

// A label that is visible while a service runs slower than real time.
class SlowdownLabel : public QLabel {
  Q_OBJECT

 public:
  // The service must outlive the label.
  explicit SlowdownLabel(const Service& service, QWidget* parent = nullptr);

 private:
  void update();

  static constexpr int kInterval = 1000;       // ms
  static constexpr double kNoticeable = 0.05;  // fraction of real time; a smaller slowdown is due to the scheduler

  const Service& m_service;
  QTimer m_timer;
  QElapsedTimer m_sinceUpdate;
  double m_lost = 0.0;  // time that the service had lost at the last update, s
};

}  // namespace handwheel

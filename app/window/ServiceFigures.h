// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QToolButton>
#include <map>

namespace handwheel {

class WindowServices;

// In the status bar: the CPU time that all services that run take together in a second. A click opens the panel with
// the details.
class ServiceFigures : public QToolButton {
  Q_OBJECT

 public:
  explicit ServiceFigures(const WindowServices& services, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void refresh();

  const WindowServices& m_services;
  QTimer m_timer;
  QElapsedTimer m_since;               // the last look,
  std::map<QString, double> m_before;  // and what each had cost by then, µs
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QToolButton>

namespace handwheel {

class WindowServices;

// In the status bar: what one tick of all services that run costs together. A click opens the panel with the details.
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
};

}  // namespace handwheel

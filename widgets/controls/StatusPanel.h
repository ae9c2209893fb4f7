// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>
#include <functional>

#include "controls/ServiceModel.h"

namespace handwheel {

// A panel with the running services and their costs. It queries the statistics twice a second, and only while it is
// visible.
class StatusPanel : public QWidget {
  Q_OBJECT

 public:
  using Source = std::function<std::vector<ServiceStatus>()>;

  explicit StatusPanel(QWidget* parent = nullptr);

  void setSource(Source source);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void refresh();

  ServiceModel m_model;
  Source m_source;
  QTimer m_timer;
};

}  // namespace handwheel

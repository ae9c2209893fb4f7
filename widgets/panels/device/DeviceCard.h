// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/device/DeviceInUse.h"

#include <QWidget>

class QComboBox;
class QFrame;
class QLabel;
class QToolButton;

namespace handwheel {

// Shows and selects the device in use. Has its status, and advice when it is not ready.
class DeviceCard : public QWidget {
  Q_OBJECT

 public:
  explicit DeviceCard(QWidget* parent = nullptr);

  void showDevice(const DeviceInUse& view);
  void showStatus(DeviceStatus status);  // status of the chosen device, as it changes
  void showLoop(const ServoLoopStatus& loop);

 signals:
  void deviceChosen(const std::string& driver, const std::string& address);
  void deviceLeft();  // no device is to be used any more
  void rescanRequested();
  void realTimeAdviceRequested();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* stateFrame();
  void fillList();
  void choose(int row);
  void showState();

  DeviceInUse m_view;
  bool m_isRealTimeRefused = false;
  std::vector<DeviceInfo> m_listed;  // the rows after the first
  QComboBox* m_choice;
  QFrame* m_state;
  QLabel* m_icon;
  QLabel* m_headline;
  QLabel* m_detail;
  QToolButton* m_notRealTime;
};

}  // namespace handwheel

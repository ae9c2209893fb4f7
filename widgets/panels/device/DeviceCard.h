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

// A card that shows and selects the device in use. It displays the status of the device, and advice if the device is
// not ready.
class DeviceCard : public QWidget {
  Q_OBJECT

 public:
  explicit DeviceCard(QWidget* parent = nullptr);

  void showDevice(const DeviceInUse& view);
  void showStatus(DeviceStatus status);  // to be called when the status of the chosen device changes
  void showLoop(const ServoLoopStatus& loop);

 signals:
  void deviceChosen(const std::string& driver, const std::string& address);
  void deviceLeft();  // emitted when the user chooses to use no device
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
  std::vector<DeviceInfo> m_listed;  // devices of the rows after the first
  QComboBox* m_choice;
  QFrame* m_state;
  QLabel* m_icon;
  QLabel* m_headline;
  QLabel* m_detail;
  QToolButton* m_notRealTime;
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/device/DevicePanel.h"

#include "haptics/device/PoseTrajectory.h"

#include <QElapsedTimer>
#include <optional>

namespace handwheel {

class HapticSession;

// The device panel connected to the haptic session. While it is hidden, it requests no data and no devices are searched
// for.
class DeviceDock : public DevicePanel {
  Q_OBJECT

 public:
  explicit DeviceDock(HapticSession& session, QWidget* parent = nullptr);  // the session outlives it

  // The names of the devices that move the view.
  void setSpaceMice(std::vector<std::string> names);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void showChosen();
  void showTick();
  void leadHand();
  void showRun();

  HapticSession& m_session;
  std::vector<std::string> m_spaceMice;
  QElapsedTimer m_sinceRun;        // since timings were last shown
  std::optional<HandPose> m_goal;  // of the simulated hand, on its way there
};

}  // namespace handwheel

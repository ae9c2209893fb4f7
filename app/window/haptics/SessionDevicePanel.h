// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/device/DevicePanel.h"

#include "haptics/device/PoseTrajectory.h"
#include "mesh/search/PickRay.h"

#include <QElapsedTimer>
#include <optional>

namespace handwheel {

class HapticSession;

// The device panel connected to the haptic session. While the panel is hidden, it requests no data, and no devices are
// searched for.
class SessionDevicePanel : public DevicePanel {
  Q_OBJECT

 public:
  explicit SessionDevicePanel(HapticSession& session, QWidget* parent = nullptr);  // the session must outlive the panel

  // Sets the names of the devices that move the view.
  void setSpaceMice(std::vector<std::string> names);
  // Sets the axis about which the work turns, such as that of a lathe. The axes of the simulated hand are named after
  // this axis.
  void setTurningAxis(const std::optional<Ray>& axis);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void showChosen();
  void showTick();
  void leadHand();
  void showRun();
  void nameAxes();

  HapticSession& m_session;
  std::vector<std::string> m_spaceMice;
  std::optional<Ray> m_turningAxis;
  QElapsedTimer m_sinceRun;        // time since timings were last shown
  std::optional<HandPose> m_goal;  // goal of the simulated hand while it is moving
};

}  // namespace handwheel

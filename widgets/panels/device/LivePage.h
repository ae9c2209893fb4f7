// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/PoseTrajectory.h"
#include "panels/device/DeviceInUse.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;

namespace handwheel {

class AxisBars;
class ButtonLamps;
class ForcePlot;
struct ServoSample;

// The page with the live axes, buttons and force of a device.
class LivePage : public QWidget {
  Q_OBJECT

 public:
  explicit LivePage(QWidget* parent = nullptr);

  void showDevice(const DeviceInUse& view);
  void showSample(const ServoSample& sample, double forceGain);
  void showHand(const HandPose& hand);          // the target of a simulated hand
  void setAxisWords(const QStringList& words);  // see AxisBars
  void clear();

 signals:
  void handLed(const handwheel::HandPose& hand);
  void forceOnChanged(bool isOn);
  void forceTestRequested();

 private:
  void enableForce(DeviceStatus status);
  void showTorque(double torque);  // N·mm

  DeviceInUse m_view;
  HandPose m_hand;
  AxisBars* m_axes;
  ButtonLamps* m_buttons;
  QCheckBox* m_forceOn;
  QPushButton* m_forceTest;
  QLabel* m_noForce;
  QLabel* m_torque;
  ForcePlot* m_plot;
  double m_shown = 0.0;  // s: time of the sample whose axes are shown
};

}  // namespace handwheel

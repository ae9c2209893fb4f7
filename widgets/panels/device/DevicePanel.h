// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mapping/WorkspaceMapping.h"
#include "panels/device/DeviceInUse.h"
#include "panels/device/SafetyActionHold.h"

#include <QWidget>

class QLabel;
class QTabWidget;

namespace handwheel {

class DeviceCard;
class LivePage;
class ServoStatistics;
class MappingForm;
class PropertyList;
class TimingPage;
struct HandPose;
struct ServoSample;

// The panel for the haptic devices. For the device in use, it has pages for live values, mapping, servo timing and data
// sheet, and it shows the state of the safety chain. The panel only displays values, and emits signals for the user's
// requests. While it is hidden, it ignores samples and timings.
class DevicePanel : public QWidget {
  Q_OBJECT

 public:
  explicit DevicePanel(QWidget* parent = nullptr);

  // Adds a page after the others.
  void addPage(QWidget* page, const QString& title);
  void showPage(QWidget* page);

  void showDevice(const DeviceInUse& view);
  void setMapping(const WorkspaceMapping& mapping);
  // Shows a sample of the servo loop. To be called at the rate of the display. stiffnessAtDevice: the stiffness at the
  // device for a stiffness of 1 in the scene.
  void showSample(const ServoSample& sample, double stiffnessAtDevice = 1.0);
  void showHand(const HandPose& hand);          // shows the target of a simulated hand
  void setAxisWords(const QStringList& words);  // see AxisBars
  void showLoop(const ServoLoopStatus& loop);   // to be called at a low rate, like the next function
  void showTiming(const ServoStatistics& measure);

 signals:
  void deviceChosen(const std::string& driver, const std::string& address);
  void deviceLeft();
  void rescanRequested();
  // Emitted with the changed mapping. Its sceneFromView is unchanged since the last call of setMapping().
  void mappingChanged(const handwheel::WorkspaceMapping& mapping);
  void forceOnChanged(bool isOn);
  void forceTestRequested();
  void handLed(const handwheel::HandPose& hand);

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  void addPages();
  void connectParts();
  void clearLive();
  void noteSoftening(const ServoSample& sample, double stiffnessAtDevice);
  void showSafety(SafetyActions actions);

  DeviceCard* m_card;
  QTabWidget* m_pages;
  LivePage* m_live;
  MappingForm* m_mapping;
  TimingPage* m_timing;
  PropertyList* m_dataSheet;
  QLabel* m_safety;
  SafetyActionHold m_memory;
  DeviceInUse m_view;
  double m_rate = 0.0;        // measured rate of the loop, Hz
  QString m_softened;         // text on the reduced stiffness
  double m_softenedAt = 0.0;  // time of this text, s since the loop started
};

}  // namespace handwheel

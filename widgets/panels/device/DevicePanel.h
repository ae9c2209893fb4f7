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

// The panel for the haptic devices. For the one in use it has pages for live values, mapping, servo timing and data
// sheet, and the state of the safety chain. It only displays, and emits signals for the user's requests; while it is
// hidden, samples and timings are ignored.
class DevicePanel : public QWidget {
  Q_OBJECT

 public:
  explicit DevicePanel(QWidget* parent = nullptr);

  // Adds a page after the others.
  void addPage(QWidget* page, const QString& title);
  void showPage(QWidget* page);

  void showDevice(const DeviceInUse& view);
  void setMapping(const WorkspaceMapping& mapping);
  // To be called at the rate of the display. stiffnessAtDevice: felt as 1 in the scene.
  void showSample(const ServoSample& sample, double stiffnessAtDevice = 1.0);
  void showHand(const HandPose& hand);          // for a device that nobody holds: the target of its hand
  void setAxisWords(const QStringList& words);  // see AxisBars
  void showLoop(const ServoLoopStatus& loop);   // at a low rate, like the next function
  void showTiming(const ServoStatistics& measure);

 signals:
  void deviceChosen(const std::string& driver, const std::string& address);
  void deviceLeft();
  void rescanRequested();
  // Emitted with the changed mapping. Its sceneFromView is the one last set.
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
  double m_rate = 0.0;        // measured, Hz
  QString m_softened;         // text on the reduced stiffness
  double m_softenedAt = 0.0;  // s since the loop started
};

}  // namespace handwheel

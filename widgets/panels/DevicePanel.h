// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/WorkspaceMapping.h"
#include "panels/DeviceInUse.h"
#include "panels/SafetyMemory.h"

#include <QWidget>

class QLabel;
class QTabWidget;

namespace handwheel {

class DeviceCard;
class LivePage;
class LoopMeasure;
class MappingForm;
class PropertyList;
class TimingPage;
struct ServoSample;

// The devices, and all about the one in use: what it does now, how it moves the tip, how regularly the servo loop runs,
// its data sheet, and what the safety chain is doing. Shows what it is told and asks for what the user wants; while
// nobody can see it, samples and timings are let pass.
class DevicePanel : public QWidget {
  Q_OBJECT

 public:
  explicit DevicePanel(QWidget* parent = nullptr);

  // A page of another subject, behind the others.
  void addPage(QWidget* page, const QString& title);

  void showDevice(const DeviceInUse& view);
  void setMapping(const WorkspaceMapping& mapping);
  void showSample(const ServoSample& sample);  // at the rate of the display
  void showLoop(const LoopView& loop);         // now and then, as the next
  void showTiming(const LoopMeasure& measure);

 signals:
  void deviceChosen(const std::string& driver, const std::string& address);
  void deviceLeft();
  void rescanAsked();
  // Its sceneFromView is as it was set last.
  void mappingChanged(const handwheel::WorkspaceMapping& mapping);
  void forceOnChanged(bool isOn);
  void forceTestAsked();

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  void addPages();
  void connectParts();
  void clearLive();
  void showSafety(SafetyActions actions);

  DeviceCard* m_card;
  QTabWidget* m_pages;
  LivePage* m_live;
  MappingForm* m_mapping;
  TimingPage* m_timing;
  PropertyList* m_dataSheet;
  QLabel* m_safety;
  SafetyMemory m_memory;
  std::optional<DeviceListing> m_chosen;
};

}  // namespace handwheel

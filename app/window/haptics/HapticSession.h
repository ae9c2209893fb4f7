// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Recording.h"
#include "haptics/ServoLoop.h"
#include "haptics/SimulatedDevice.h"
#include "panels/MessageBar.h"
#include "viewport/CameraState.h"
#include "window/haptics/DeviceFinder.h"
#include "window/haptics/TouchSettings.h"

#include <QElapsedTimer>
#include <QList>
#include <optional>

namespace handwheel {

class ForceRecorder;
class MouseDevice;
class WindowServices;

// The haptic device that the user has chosen, and the servo loop that runs as long as it is open: without one there is
// no thread, no timer and no scene. The choice and its mapping are kept in the settings. Window thread.
class HapticSession : public QObject {
  Q_OBJECT

 public:
  // What a session needs of the program. The clock outlives the session.
  struct Parts {
    JobRunner& jobs;  // opening and closing; shown to the user
    QThreadPool& pool;
    WindowServices& services;
    ServoClock& clock;
  };
  explicit HapticSession(const Parts& parts, std::vector<std::unique_ptr<DeviceDriver>> drivers = {},
                         QObject* parent = nullptr);
  ~HapticSession() override;

  // The simulated hand and the mouse, then what was found when somebody looked.
  QList<DeviceListing> found() const;
  // Looks for devices every two seconds, as long as a list of them is seen.
  void setWatching(bool isOn);
  const std::vector<PluginListing>& plugins() const { return m_finder.plugins(); }

  // Opens it in a job, in the place of the one before.
  void choose(const std::string& driver, const std::string& address);
  void close();
  // The device that was in use when the program ended, if it is there: without a word if not.
  void takeUp();
  bool isOpen() const { return m_open != nullptr; }
  DeviceListing chosen() const { return m_chosen; }  // being opened or open; all empty: none
  DeviceCapabilities capabilities() const;           // of the open one

  // The last tick as of sampled(); null: none is open, or no tick has passed. Valid until the next sampled().
  const ServoSample* latest() const;
  const LoopMeasure* measure() const;  // null: none is open
  RealTimeState realTime() const;
  std::uint64_t missedTicks() const;
  double rate() const { return m_rate; }  // ticks a second, as measured over the last half second

  // The user's part: axes, inversion, scale, gain, dead zones, clutch. A scale of 1 lets the workspace fill the view.
  WorkspaceMapping mapping() const { return m_mapping; }
  void setMapping(const WorkspaceMapping& mapping);
  // The view part. The tip stays where it is as long as it can be seen, else it comes into the view. seen: what is seen
  // in the middle of it.
  void setView(const CameraState& camera, const Box& model, const std::optional<Vec3>& seen = {});
  const CameraState& camera() const { return m_camera; }
  // Brings the tip to where the device is in the present view.
  void recentre();
  // How the device lies in the scene now.
  WorkspaceMapping mappingInScene() const;

  // Rate and window of the loop. One that runs lets the force go, and takes them up within some 50 ms; the force comes
  // back by the ramp.
  const ServoSettings& servo() const { return m_servo; }
  void setServo(const ServoSettings& servo);

  // How what is touched feels.
  const TouchSettings& touch() const { return m_touch; }
  void setTouch(const TouchSettings& touch);

  bool isForceOn() const { return m_isForceOn; }
  void setForceOn(bool isOn);
  // Pulls gently along each axis of the device, up to kTestForce, through the safety chain; the scene is not felt
  // meanwhile.
  void startForceTest();
  bool isTesting() const { return m_testEnd.has_value(); }
  static constexpr double kTestForce = 0.5;  // N

  // Records every tick from now on, until stopRecording(), the end of the device, or ForceRecorder::kMostTicks; then
  // recorded() hands it over. Nothing when no device is open, or one is recording already.
  void startRecording();
  void stopRecording();
  const ForceRecorder* recorder() const;  // null: nothing is being recorded
  // Notes in the recording that something happened, if there is one.
  void mark(const QString& event);

  // What is felt from the next tick on; dropped when nothing is open, and while a test goes on. sceneWanted() asks for
  // it again.
  void setScene(std::unique_ptr<HapticScene> scene);
  void announceLeap();

  // Null unless that is the open device.
  MouseDevice* mouse() const;
  SimulatedDevice* simulatedHand() const;

 signals:
  void foundChanged();
  void chosenChanged();  // another, opened, or closed
  void sampled();        // 60 times a second while one is open
  void sceneWanted();
  void forceOnChanged(bool isOn);
  void mappingChanged();  // the user's part
  // What mappingInScene() says, and from where the scene is seen. A scene that is set meanwhile is felt from the same
  // tick on as the view.
  void viewChanged();
  void touchChanged();
  void recordingStarted();
  // forceLimit: N in the scene, of the device, as the scale was at the end.
  void recorded(const handwheel::Recording& recording, const QString& device, double forceLimit);
  void message(const handwheel::Message& message);

 private:
  struct OpenDevice;
  void startOpening(bool isQuiet);
  void opened(std::unique_ptr<Device> device);
  void failed(const Error& error, bool isQuiet);
  void closeLoop();
  void applyMapping(bool keepsTip, bool mayLeap);
  void sample();
  void changeServo();
  void endForceTest();
  void measureRate();
  void tellStatus(DeviceStatus status);
  void tellPlugins();
  void setLost(bool isLost);
  void takeUpReturned();

  Parts m_parts;
  DeviceFinder m_finder;
  DeviceListing m_chosen;
  std::unique_ptr<OpenDevice> m_open;
  ServoSettings m_servo;
  WorkspaceMapping m_mapping;
  TouchSettings m_touch = keptTouch();
  CameraState m_camera;
  Box m_model;
  std::optional<Vec3> m_seen;
  QTimer m_timer;
  double m_rate = 0.0;
  QElapsedTimer m_rateClock;
  std::uint64_t m_rateTick = 0;
  bool m_isForceOn = true;
  std::optional<double> m_testEnd;  // s, by the clock of the loop
  std::size_t m_pluginsTold = 0;
  bool m_isWatched = false;  // by somebody who sees the list
  bool m_isLost = false;     // the open device was unplugged, and is waited for
  bool m_isMissed = false;   // and since then was not in the list
};

}  // namespace handwheel

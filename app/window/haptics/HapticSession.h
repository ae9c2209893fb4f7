// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/SimulatedDevice.h"
#include "haptics/recording/Recording.h"
#include "haptics/servo/ServoLoop.h"
#include "panels/MessageBar.h"
#include "viewport/camera/CameraState.h"
#include "window/haptics/DeviceFinder.h"
#include "window/haptics/TouchSettings.h"

#include <QElapsedTimer>
#include <QList>
#include <optional>

namespace handwheel {

class ForceRecorder;
class MouseDevice;
class WindowServices;

// The chosen haptic device with the servo loop that drives it. The loop runs while the device is open; while no device
// is open there is no thread, no timer and no scene. A device that is unplugged, or has failed for some seconds, is
// closed; it is opened again when it is plugged in again. The choice and its mapping are stored in the settings. Must
// be used on the window thread.
class HapticSession : public QObject {
  Q_OBJECT

 public:
  // The objects of the program that a session uses. The clock must outlive the session.
  struct Parts {
    JobRunner& jobs;  // opens and closes devices as jobs that the user sees
    QThreadPool& pool;
    WindowServices& services;
    ServoClock& clock;
  };
  explicit HapticSession(const Parts& parts, std::vector<std::unique_ptr<DeviceDriver>> drivers = {},
                         QObject* parent = nullptr);
  ~HapticSession() override;

  // Returns the simulated device and the mouse, then the devices of the last search.
  QList<DeviceInfo> found() const;
  DeviceFinder& finder() { return m_finder; }
  // Searches for devices every two seconds while a list of them is visible.
  void setWatching(bool isOn);
  const std::vector<PluginInfo>& plugins() const { return m_finder.plugins(); }

  // Opens a device in a job. It replaces the previous device.
  void choose(const std::string& driver, const std::string& address);
  void close();
  // Opens the device that was in use when the program ended, unless it was the mouse, which would not move the view any
  // more. Shows no message if the device is not connected.
  void takeUp();
  bool isOpen() const { return m_open != nullptr; }
  DeviceInfo chosen() const {
    return m_chosen;
  }                             // the device that is open, being opened or waited for; all members empty: none
  DeviceStatus status() const;  // status of the chosen device
  DeviceCapabilities capabilities() const;  // capabilities of the open device

  // Returns the latest tick at the last sampled(); null: no device is open, or no tick has passed. The pointer is valid
  // until the next sampled().
  const ServoSample* latest() const;
  const ServoStatistics* measure() const;  // null: no device is open
  RealTimeState realTime() const;
  std::uint64_t missedTicks() const;
  double rate() const { return m_rate; }  // measured ticks per second over the last half second

  // The user's settings of the mapping: axes, inversion, scale, gain, dead zones, clutch. A scale of 1 means that the
  // workspace fills the view.
  WorkspaceMapping mapping() const { return m_mapping; }
  void setMapping(const WorkspaceMapping& mapping);
  // Sets the view of the mapping. The tip stays unchanged while it is within the view, otherwise it moves into the
  // view. seen: the surface point in the middle of the view.
  void setView(const CameraState& camera, const Box& model, const std::optional<Vec3>& seen = {});
  const CameraState& camera() const { return m_camera; }
  // Moves the tip to the position of the device in the present view.
  void recentre();
  // The present mapping from the device to the scene.
  WorkspaceMapping mappingInScene() const;

  // The rate and velocity window of the loop. When they change, a running loop releases the force, applies them within
  // about 50 ms, and ramps the force up again.
  const ServoSettings& servo() const { return m_servo; }
  void setServo(const ServoSettings& servo);

  // The haptic properties of touched surfaces.
  const TouchSettings& touch() const { return m_touch; }
  void setTouch(const TouchSettings& touch);

  bool isForceOn() const { return m_isForceOn; }
  void setForceOn(bool isOn);
  // Starts a test that pulls gently along each axis of the device. The force is at most kTestForce and passes through
  // the safety chain; the forces of the scene are off during the test.
  void startForceTest();
  bool isTesting() const { return m_testEnd.has_value(); }
  static constexpr double kTestForce = 0.5;  // N

  // Starts recording every tick. The recording ends with stopRecording(), when the device is closed, or at
  // ForceRecorder::kMostTicks; recorded() is then emitted. Does nothing if no device is open or a recording is already
  // running.
  void startRecording();
  void stopRecording();
  const ForceRecorder* recorder() const;  // null: nothing is being recorded
  // Adds an event to the running recording, if there is one.
  void mark(const QString& event);

  // Sets the scene whose forces are felt from the next tick on. The scene is dropped if no device is open, or during a
  // force test; sceneRequested() later requests a scene again. note: the contents of the scene for a recording, as a
  // JSON object.
  void setScene(std::unique_ptr<HapticScene> scene, const std::string& note = "{}");
  // Tells the servo loop that the force may change abruptly; starts the force ramp.
  void announceDiscontinuity();

  // Return the open device if it is the mouse, or the simulated device; otherwise null.
  MouseDevice* mouse() const;
  SimulatedDevice* simulatedHand() const;

 signals:
  void foundChanged();
  void chosenChanged();  // another device was chosen, opened, or closed
  void sampled();        // 60 times a second while a device is open
  void sceneRequested();
  void forceOnChanged(bool isOn);
  void mappingChanged();  // the user's settings of the mapping have changed
  // Emitted when mappingInScene() and the camera have changed. A scene that is set during this signal takes effect in
  // the same tick as the view.
  void viewChanged();
  void touchChanged();
  void recordingStarted();
  // Emitted when a recording has ended. forceLimit: the force limit of the device, N, converted to the scene with the
  // scale at the end of the recording.
  void recorded(const handwheel::Recording& recording, const QString& device, double forceLimit);
  void message(const handwheel::Message& message);

 private:
  struct ActiveDevice;
  void startOpening(bool isQuiet);
  void opened(std::unique_ptr<Device> device);
  void failed(const Error& error, bool isQuiet);
  void closeLoop();
  void applyMapping(bool keepsTip, bool isDiscontinuous);
  void sample();
  void changeServo();
  void endForceTest();
  void measureRate();
  void reportStatus(DeviceStatus status);
  bool isGone() const;
  void lose(DeviceStatus status);
  void reportPlugins();
  void setLost(std::optional<DeviceStatus> how);
  std::optional<DeviceInfo> listingOf(const DeviceInfo& device) const;  // listing of the device as it is connected now
  void openAgain(const DeviceInfo& device);
  void takeUpReturned();

  Parts m_parts;
  DeviceFinder m_finder;
  DeviceInfo m_chosen;
  std::unique_ptr<ActiveDevice> m_open;
  ServoSettings m_servo;
  WorkspaceMapping m_mapping;
  TouchSettings m_touch = loadTouch();
  CameraState m_camera;
  Box m_model;
  std::optional<Vec3> m_seen;
  QTimer m_timer;
  double m_rate = 0.0;
  QElapsedTimer m_rateClock;
  std::uint64_t m_rateTick = 0;
  bool m_isForceOn = true;
  std::optional<double> m_testEnd;  // end of the force test, s by the clock of the loop; none: no test runs
  std::size_t m_pluginsReported = 0;
  bool m_isWatched = false;            // a list of devices is visible
  std::optional<DeviceStatus> m_lost;  // status in which the chosen device was lost; none: its return is not waited for
  bool m_isMissed = false;             // the lost device has been absent from the list since it was lost
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

namespace handwheel {

class HapticSession;
class Viewport;
struct HandPose;
struct ServoSample;

// One step of a scripted demonstration. The demonstration calls begin, waits until isReady returns true, moves the tip
// to the goal, and rests.
struct DemoStep {
  QString caption;  // description of the step; empty: the description of the previous step
  QString detail;   // instructions for the user; ignored if there is no caption
  std::function<void()> begin;
  std::function<bool()> isReady;  // condition for the motion of the tip; none: the tip moves at once
  std::function<std::optional<Vec3>()>
      goal;                   // returns the goal of the tip, mm; called when isReady; none: the tip stays unchanged
  std::uint32_t buttons = 0;  // buttons held during the motion
  double rest = 0.0;          // s, pause at the goal
};

// Plays a scripted demonstration with the simulated haptic device. The tip is moved through space and the buttons are
// pressed, so that the servo loop and the tools work as with a real device. Must be used on the window thread.
class ScriptedDeviceDemo : public QObject {
  Q_OBJECT

 public:
  ScriptedDeviceDemo(HapticSession& session, Viewport& viewport, QObject* parent = nullptr);
  ~ScriptedDeviceDemo() override;

  // Starts the demonstration with the simulated device. The device in use before is opened again at the end.
  void start(std::vector<DemoStep> steps);
  // Ends the demonstration early; does nothing if none is running.
  void stop();
  bool isRunning() const { return m_isRunning; }
  const QString& caption() const { return m_caption; }
  const QString& detail() const { return m_detail; }
  // Sets the speed factor, for tests.
  void setPace(double pace) { m_pace = pace; }

 signals:
  void captionChanged();
  void ended(bool isWhole);

 private:
  enum class Phase { Waiting, Moving, Resting };
  void beginStep();
  void follow();
  void startMoving(const ServoSample& now);
  void move(const ServoSample& now);
  Vec3 positionAt(double share) const;
  void lead(const ServoSample& now, const Vec3& goal);
  void press(std::uint32_t buttons);
  double seconds() const;
  void finish(bool isWhole);

  HapticSession& m_session;
  Viewport& m_viewport;
  std::vector<DemoStep> m_steps;
  std::size_t m_step = 0;
  bool m_isRunning = false;
  QString m_caption, m_detail;
  double m_pace = 1.0;
  std::string m_driver, m_address;  // driver and address of the device that was in use

  Phase m_phase = Phase::Waiting;
  int m_samples = 0;  // servo samples since m_duration was over (in Moving), or since the goal was reached (in Resting)
  QElapsedTimer m_clock;         // time since the beginning of the phase
  Vec3 m_from, m_to;             // start and end of the motion of the tip, in the scene; mm
  double m_duration = 0.0;       // s
  double m_lift = 0.0;           // mm towards the viewer at half of the motion
  Vec3 m_effort = Vec3::Zero();  // mm, offset of the target that compensates forces on the tip
};

}  // namespace handwheel

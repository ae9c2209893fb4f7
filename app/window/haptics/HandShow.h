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

// One thing that the simulated hand does: something happens, it is waited for, the tip goes somewhere, and rests.
struct HandStep {
  QString caption;  // what is done; empty: as in the step before
  QString detail;   // how one does it oneself; with a caption
  std::function<void()> begin;
  std::function<bool()> isReady;               // waited for before the hand moves; none: at once
  std::function<std::optional<Vec3>()> place;  // mm, of the tip, asked for when ready; none: it stays
  std::uint32_t buttons = 0;                   // held on the way
  double rest = 0.0;                           // s at the place
};

// Lets the simulated hand do what a person would with a device: its tip is led through space and its buttons are
// pressed, so that everything between the servo loop and the tools is what it is for a real one. Window thread.
class HandShow : public QObject {
  Q_OBJECT

 public:
  HandShow(HapticSession& session, Viewport& viewport, QObject* parent = nullptr);
  ~HandShow() override;

  // Takes up the simulated hand, whatever device is in use; that one comes back at the end.
  void start(std::vector<HandStep> steps);
  // In the midst, or when nothing is shown.
  void stop();
  bool isRunning() const { return m_isRunning; }
  const QString& caption() const { return m_caption; }
  const QString& detail() const { return m_detail; }
  // How many times as fast; for tests.
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
  Vec3 wayAt(double share) const;
  void lead(const ServoSample& now, const Vec3& place);
  void press(std::uint32_t buttons);
  double seconds() const;
  void finish(bool isWhole);

  HapticSession& m_session;
  Viewport& m_viewport;
  std::vector<HandStep> m_steps;
  std::size_t m_step = 0;
  bool m_isRunning = false;
  QString m_caption, m_detail;
  double m_pace = 1.0;
  std::string m_driver, m_address;  // of the device that was in use

  Phase m_phase = Phase::Waiting;
  int m_samples = 0;             // since the way is over, or at rest
  QElapsedTimer m_clock;         // of the phase
  Vec3 m_from, m_to;             // of the tip, in the scene; mm
  double m_duration = 0.0;       // s
  double m_lift = 0.0;           // mm towards the viewer, half-way
  Vec3 m_effort = Vec3::Zero();  // mm, by which the hand aims further because something holds the tip back
};

}  // namespace handwheel

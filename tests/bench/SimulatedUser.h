// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/ThreadClock.h"
#include "bench/Bars.h"
#include "gui/window/WindowDriver.h"

#include <QApplication>
#include <QComboBox>
#include <functional>
#include <thread>

namespace handwheel::bench {

constexpr double kBarMs = 50.0;

// An application that times each event, including all that it triggers.
class TimedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  // The longest times that one event took.
  CpuTimes outside;  // time outside the graphics library
  CpuTimes drawing;  // time inside the graphics library

  // Sets the watched viewport; null: none.
  void watch(const Viewport* viewport) {
    m_viewport = viewport;
    if (!viewport) return;
    // Qt composes the picture of the renderer with that of the window by the same graphics library; this counts as
    // drawing.
    connect(viewport, &Viewport::aboutToCompose, this, [this] { m_composing = CpuTimes::now(); });
    connect(viewport, &Viewport::frameSwapped, this,
            [this] { m_composed = m_composed + (CpuTimes::now() - m_composing); });
  }

  bool notify(QObject* receiver, QEvent* event) override {
    if (m_isInside || !m_viewport) return QApplication::notify(receiver, event);
    m_isInside = true;
    const CpuTimes start = CpuTimes::now(), drawnBefore = m_viewport->timeDrawing() + m_composed;
    const bool isAccepted = QApplication::notify(receiver, event);
    const CpuTimes drawn = m_viewport->timeDrawing() + m_composed - drawnBefore;
    keepLongest(outside, CpuTimes::now() - start - drawn);
    keepLongest(drawing, drawn);
    m_isInside = false;
    return isAccepted;
  }

 private:
  static void keepLongest(CpuTimes& longest, const CpuTimes& one) {
    longest = {std::max(longest.clock, one.clock), std::max(longest.cpu, one.cpu)};
  }

  bool m_isInside = false;
  const Viewport* m_viewport = nullptr;
  CpuTimes m_composing;
  CpuTimes m_composed;
};

// A simulated user of a window. Prints how long each piece of work keeps the thread of the window busy.
class SimulatedUser {
 public:
  SimulatedUser(TimedApplication& application, Bars& bars)
      : m_application(application), m_bars(bars), m_view(m_driver.find<Viewport>("viewport")) {
    m_application.watch(m_view);
    std::printf("%-26s %8s %8s   %8s\n", "longest event, ms", "CPU", "clock", "drawing");
  }
  ~SimulatedUser() { m_application.watch(nullptr); }

  // Measures how long the work and all its consequences keep the thread busy, until the window has come to rest.
  void does(const char* what, const std::function<void()>& work, double bar = kBarMs) {
    waits(
        what, [&] { return QMetaObject::invokeMethod(&m_driver.window(), work, Qt::QueuedConnection); }, bar);
  }
  // Does the same as does() for work that processes its events itself, one by one, such as a gesture.
  void waits(const char* what, const std::function<bool()>& work, double bar = kBarMs) {
    m_application.outside = m_application.drawing = {};
    if (!work()) qFatal("%s could not be done", what);
    for (int turn = 0; turn < 30 || !m_driver.window().isSettled(); ++turn) {
      QCoreApplication::processEvents();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    const CpuTimes &outside = m_application.outside, &drawing = m_application.drawing;
    std::printf("%-26s %8.1f %8.1f   %8.1f\n", what, outside.cpu, outside.clock, drawing.clock);
    m_bars.atMost(std::string(what) + ": the window's thread, ms of CPU", bar, outside.cpu);
  }

  // Triggers an action. A disabled action is a fatal error: it would cost no time, and so never exceed a limit.
  void trigger(const char* name) {
    auto* action = m_driver.find<QAction>(name);
    if (!action->isEnabled()) qFatal("%s is disabled", name);
    action->trigger();
  }

  test::WindowDriver& driver() { return m_driver; }
  Viewport& view() { return *m_view; }
  QPoint at(double x, double y) const {
    return {static_cast<int>(x * m_view->width()), static_cast<int>(y * m_view->height())};
  }
  bool drag(Qt::MouseButton button, QPoint from, QPoint to) {
    QTest::mousePress(m_view, button, {}, from);
    for (int step = 1; step <= 20; ++step) QTest::mouseMove(m_view, from + (to - from) * step / 20);
    QTest::mouseRelease(m_view, button, {}, to);
    return true;
  }
  void choose(const char* dock, const char* property, int index) {
    auto* row = m_driver.find<QWidget>(dock)->findChild<QWidget*>(QStringLiteral("property/") + property);
    auto* box = row->findChild<QComboBox*>();
    box->setCurrentIndex(index);
    emit box->activated(index);
  }

 private:
  TimedApplication& m_application;
  Bars& m_bars;
  test::WindowDriver m_driver;
  Viewport* m_view;
};

}  // namespace handwheel::bench

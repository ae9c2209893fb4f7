// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceKind.h"
#include "machining/lathe/LatheJson.h"
#include "tools/ToolRunner.h"
#include "tools/workpiece/ManualLatheTool.h"

#include <QTest>
#include <chrono>
#include <cmath>
#include <thread>

// A manual lathe whose levers and wheels a test works.
namespace handwheel::test {

inline constexpr auto kCarriageAxis = static_cast<std::size_t>(LatheAxis::Carriage);
inline constexpr auto kCrossAxis = static_cast<std::size_t>(LatheAxis::Cross);

// A clock that stands still. Each wait of the simulation takes only a short pause of real time.
class HurriedClock : public ServoClock {
 public:
  explicit HurriedClock(std::chrono::microseconds pause) : m_pause(pause) {}
  std::int64_t now() noexcept override { return 0; }
  void waitUntil(std::int64_t) noexcept override { std::this_thread::sleep_for(m_pause); }

 private:
  std::chrono::microseconds m_pause;
};

// A bar of 50 × 100 mm in the lathe. The first tool of the lathe starts at a distance of 20 mm in X and Z.
struct HandLathe {
  WorkpieceKind kind;
  std::unique_ptr<Document> made;
  WorkpieceDocument& document;
  HurriedClock clock;
  Service simulation{"simulation"};
  ToolRunner runner;
  ManualLatheTool* tool = nullptr;
  std::shared_ptr<std::optional<ManualLatheTool::Left>> left = std::make_shared<std::optional<ManualLatheTool::Left>>();

  explicit HandLathe(SnapshotPointer opened, std::chrono::microseconds pause = std::chrono::microseconds(50))
      : made(kind.make({&kind, {}, std::move(opened)})),
        document(static_cast<WorkpieceDocument&>(*made)),
        clock(pause) {
    start();
  }
  void start() {
    ManualLatheTool::Start begin;
    begin.spacing = 0.05;
    begin.left = left;
    auto started =
        std::make_unique<ManualLatheTool>(document, SimulationServices{clock, simulation}, shippedLatheTools(), begin);
    tool = started.get();
    runner.start(std::move(started), document);
  }
  explicit HandLathe(std::chrono::microseconds pause = std::chrono::microseconds(50))
      : HandLathe(WorkpieceKind().blank(), pause) {}
  LatheState machine() const { return tool->moment()->machine; }
  double slide(std::size_t axis) const { return machine().slides[axis]; }
  void send(LatheCommand::Kind what, double value, LatheAxis axis = LatheAxis::Carriage) {
    runner.deliver([&] { tool->command({what, axis, value}); });
  }
  // Turns a wheel until its slide has reached a travel, mm.
  bool wind(LatheAxis axis, double to) {
    const auto i = static_cast<std::size_t>(axis);
    send(LatheCommand::Kind::Turn, to - slide(i), axis);
    return QTest::qWaitFor([&] { return std::abs(slide(i) - to) < 1e-9; });
  }
  bool spin() {
    send(LatheCommand::Kind::Spindle, 1.0);
    return QTest::qWaitFor([&] { return machine().speed == machine().setSpeed; });
  }
  // Turns 10 mm of the end to a radius by the automatic feed; the tool stays at the end of the cut.
  bool cutTo(double radius) {
    if (!wind(LatheAxis::Carriage, 101.0) || !wind(LatheAxis::Cross, radius)) return false;
    send(LatheCommand::Kind::Feed, -0.2);
    const bool isThere = QTest::qWaitFor([&] { return slide(kCarriageAxis) < 90.0; });
    send(LatheCommand::Kind::Feed, 0.0);
    return isThere && QTest::qWaitFor([&] { return machine().feed == 0.0; });
  }
  bool endPass() {
    bool isEnded = false;
    runner.deliver([&] { isEnded = tool->endPass(true); });
    return isEnded;
  }
  // Pushes the edge into the bar, which does not turn.
  bool crash() {
    const std::size_t before = tool->collisions().size();
    if (!wind(LatheAxis::Carriage, 60.0)) return false;
    send(LatheCommand::Kind::Turn, -40.0, LatheAxis::Cross);
    return QTest::qWaitFor([&] { return tool->collisions().size() > before; });
  }
  std::size_t crashes() const {
    const auto& recorded = document.workpiece().crashes;
    return recorded ? recorded->size() : 0;
  }
  // Undoes a step like the window on Ctrl+Z.
  void undo() {
    if (runner.undo() == ToolReply::Ignored) document.history()->undo();
  }
  double radiusAt(double z) const {
    const TurnedProfile& profile = tool->moment()->profile;
    return profile.radius(static_cast<std::size_t>(std::lround(z / profile.spacing())));
  }
};

}  // namespace handwheel::test

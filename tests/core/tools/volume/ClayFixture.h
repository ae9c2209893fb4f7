// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/VolumeKind.h"
#include "tools/ToolRunner.h"
#include "tools/volume/ClayTool.h"
#include "volume/VolumeSampler.h"

#include <QtTest>

namespace handwheel::test {

// A ball of clay of 20 mm with its tool, seen from above.
struct ClayFixture {
  VolumeKind kind;
  std::unique_ptr<Document> made = kind.make(DocumentKinds::blank(kind));
  VolumeDocument& document = static_cast<VolumeDocument&>(*made);
  MonotonicClock clock;
  Service simulation{"simulation"};
  ToolRunner runner;
  ClayTool* tool = nullptr;

  ClayFixture() {
    auto started = std::make_unique<ClayTool>(document, SimulationServices{clock, simulation});
    tool = started.get();
    runner.start(std::move(started), document);
  }
  std::optional<double> pressure = {};  // pressure of the pen; nullopt: a mouse

  ToolReply event(PointerEvent::Kind what, double x, double y, Modifiers modifiers = {}) {
    PointerEvent event;
    event.pressure = pressure;
    event.kind = what;
    event.button = what == PointerEvent::Kind::Hover ? PointerButton::None : PointerButton::First;
    event.ray = {Vec3(x, y, 500.0), -Vec3::UnitZ()};
    event.modifiers = modifiers;
    return runner.pointer(event);
  }
  void stroke(double fromX, double toX, double y = 0.0, Modifiers modifiers = {}) {
    QCOMPARE(event(PointerEvent::Kind::Press, fromX, y, modifiers), ToolReply::Used);
    for (int i = 1; i <= 20; ++i) event(PointerEvent::Kind::Drag, fromX + i / 20.0 * (toX - fromX), y, modifiers);
    QCOMPARE(event(PointerEvent::Kind::Release, toX, y, modifiers), ToolReply::Used);
    complete();
  }
  // Resumes the tool until it is done, as the frames of the window do.
  void complete() {
    while (tool->isLive()) {
      QTest::qSleep(2);
      runner.resume();
    }
  }
  void set(const char* id, PropertyValue value) { runner.setSetting(id, value); }
  void choose(ClayAction action) { set("action", PropertyValue(static_cast<double>(action))); }
  double depthAt(const Vec3& p) const { return VolumeSampler(document.volume()->volume).depthAt(p).depth; }
  int steps() const { return document.history()->index(); }
};

}  // namespace handwheel::test

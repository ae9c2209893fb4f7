// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workpiece/TurnTool.h"

#include "TestClass.h"
#include "document/workpiece/WorkpieceKind.h"
#include "tools/ToolRunner.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

// A bar of 50 × 100 mm and the tool on it, seen from the front: the plane of the tool is y = 0.
struct TurningBench {
  WorkpieceKind kind;
  std::unique_ptr<Document> made = kind.make(DocumentKinds::blank(kind));
  WorkpieceDocument& document = static_cast<WorkpieceDocument&>(*made);
  MonotonicClock clock;
  Service simulation{"simulation"};
  ToolRunner runner;
  TurnTool* tool = nullptr;

  TurningBench() {
    auto started = std::make_unique<TurnTool>(document, TurnServices{clock, simulation}, 0.1);
    tool = started.get();
    runner.start(std::move(started), document);
  }
  void event(PointerEvent::Kind kindOfEvent, double x, double z) {
    PointerEvent event;
    event.kind = kindOfEvent;
    event.button = kindOfEvent == PointerEvent::Kind::Hover ? PointerButton::None : PointerButton::First;
    event.ray = {Vec3(x, -500.0, z), Vec3::UnitY()};
    runner.pointer(event);
  }
  void pass(double x, double from, double to) {
    event(PointerEvent::Kind::Press, x, from);
    for (int i = 1; i <= 20; ++i) event(PointerEvent::Kind::Drag, x, from + (to - from) * i / 20.0);
    event(PointerEvent::Kind::Release, x, to);
  }
  double radiusAt(double z) const {
    const TurnedProfile& profile = document.workpiece().part->profile;
    return profile.radius(static_cast<std::size_t>(std::lround(z / profile.spacing())));
  }
};

}  // namespace

class TurnToolTest : public QObject {
  Q_OBJECT

 private slots:
  // A nose of 1 mm whose centre moves 23 mm beside the axis leaves a radius of 22 mm.
  void aPassIsOneUndoStep() {
    TurningBench bench;
    QVERIFY(!bench.document.workpiece().part);
    bench.pass(23.0, 30.0, 60.0);
    QCOMPARE(bench.document.history()->count(), 1);
    for (const double z : {30.0, 45.0, 60.0}) QVERIFY(std::abs(bench.radiusAt(z) - 22.0) < 1e-9);
    QCOMPARE(bench.radiusAt(10.0), 25.0);
    bench.pass(-20.0, 30.0, 40.0);  // from the other side it is the same part
    QCOMPARE(bench.document.history()->count(), 2);
    QVERIFY(std::abs(bench.radiusAt(35.0) - 19.0) < 1e-9);
    const TurnedProfile after = bench.document.workpiece().part->profile;
    bench.document.history()->undo();
    QVERIFY(std::abs(bench.radiusAt(35.0) - 22.0) < 1e-9);
    bench.document.history()->undo();
    QVERIFY(!bench.document.workpiece().part);
    bench.document.history()->redo();
    bench.document.history()->redo();
    QVERIFY(bench.document.workpiece().part->profile == after);
    // The stored passes give the same part.
    TurnedProfile again(bench.document.workpiece().stock, after.spacing());
    for (const auto& pass : bench.document.workpiece().part->passes) cut(again, *pass);
    QVERIFY(again == after);
  }

  // The simulation works on its own thread: what it has cut is shown within a few of its steps.
  void whatIsCutIsShownBeforeItIsCommitted() {
    TurningBench bench;
    const auto before = bench.tool->preview().replaced;
    QVERIFY(before && bench.tool->preview().replaced == before);  // what is the same costs nothing
    bench.event(PointerEvent::Kind::Press, 27.0, 50.0);
    bench.event(PointerEvent::Kind::Drag, 20.0, 50.0);
    const auto shownRadius = [&] {
      double least = 25.0;
      for (const DisplayPart& part : bench.tool->preview().replaced->parts) {
        for (const Vec3& p : part.soup->points) {
          if (std::abs(p.z() - 50.0) < 0.04) least = std::min(least, std::hypot(p.x(), p.y()));
        }
      }
      return least;
    };
    QTRY_VERIFY(std::abs(shownRadius() - 19.0) < 1e-9);
    QCOMPARE(bench.document.history()->count(), 0);
    QVERIFY(!bench.tool->preview().lines.empty());
  }

  void escapeDropsThePass() {
    TurningBench bench;
    bench.event(PointerEvent::Kind::Press, 23.0, 50.0);
    bench.event(PointerEvent::Kind::Drag, 20.0, 50.0);
    QCOMPARE(bench.runner.perform("revert"), ToolReply::Used);
    bench.event(PointerEvent::Kind::Release, 20.0, 50.0);
    QCOMPARE(bench.document.history()->count(), 0);
    bench.pass(24.0, 10.0, 20.0);  // and the next one begins anew
    QVERIFY(std::abs(bench.radiusAt(15.0) - 23.0) < 1e-9);
    QCOMPARE(bench.document.workpiece().part->profile.radius(500), 25.0);
  }

  void besideTheBarNothingIsCommitted() {
    TurningBench bench;
    bench.pass(40.0, 10.0, 90.0);
    QCOMPARE(bench.document.history()->count(), 0);
    QVERIFY(!bench.document.workpiece().part);
  }

  // An undo under the tool: the next pass cuts what the document has.
  void followsTheDocument() {
    TurningBench bench;
    bench.pass(15.0, 10.0, 90.0);
    bench.document.history()->undo();
    bench.pass(23.0, 40.0, 50.0);
    QCOMPARE(bench.radiusAt(20.0), 25.0);
  }

  // The size of a bar that was cut stays; undone, it may change again.
  void aCutBarKeepsItsSize() {
    TurningBench bench;
    bench.pass(23.0, 40.0, 50.0);
    QVERIFY(!bench.document.setProperty("diameter", 60.0));
    QVERIFY(!bench.document.setProperty("length", 60.0));
    QVERIFY(bench.document.setProperty("chord", 0.02));
    QVERIFY(bench.document.setProperty("position", 5.0));
    for (int i = 0; i < 3; ++i) bench.document.history()->undo();
    QVERIFY(bench.document.setProperty("diameter", 60.0));
  }
};

HANDWHEEL_TEST(TurnToolTest)
#include "TurnToolTest.moc"

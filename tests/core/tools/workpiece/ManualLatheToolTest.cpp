// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "HandLathe.h"
#include "TestClass.h"
#include "document/workpiece/TurnedPartDisplay.h"
#include "machining/finish/FinishMeter.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

class ManualLatheToolTest : public QObject {
  Q_OBJECT

 private slots:
  void aPassIsOneStep() {
    HandLathe lathe;
    QVERIFY(lathe.spin() && lathe.cutTo(23.0));
    QCOMPARE(lathe.document.history()->count(), 0);
    QVERIFY(lathe.endPass());
    QCOMPARE(lathe.document.history()->count(), 1);
    QVERIFY(std::abs(lathe.radiusAt(95.0) - 23.0) < 0.02);  // the work bends a little
    QCOMPARE(lathe.radiusAt(40.0), 25.0);
    QVERIFY(!lathe.document.workpiece().crashes);
  }

  // Another document was worked on meanwhile: the slides are where they were left, and nothing turns.
  void theSlidesStayWhereTheyWere() {
    HandLathe lathe;
    QVERIFY(lathe.spin() && lathe.cutTo(23.0));
    const LatheState before = lathe.machine();
    lathe.runner.stop();
    QCOMPARE(lathe.document.history()->count(), 1);
    lathe.start();
    QCOMPARE(lathe.machine().slides, before.slides);
    QCOMPARE(lathe.machine().wheels, before.wheels);
    QCOMPARE(lathe.machine().tool, before.tool);
    QVERIFY(lathe.machine().speed == 0.0 && lathe.machine().direction == 0 && lathe.machine().feed == 0.0);
    // The removed material comes back around the tool: it begins beside the bar.
    lathe.runner.stop();
    lathe.document.history()->undo();
    lathe.start();
    QVERIFY(lathe.slide(kCrossAxis) > before.slides[kCrossAxis]);
  }

  // So that the view has no triangles of the uncut bar to build again.
  void undoGivesTheSameTrianglesBack() {
    HandLathe lathe;
    const auto triangles = [&lathe] {
      std::vector<std::shared_ptr<const TriangleSoup>> all;
      const auto model = lathe.tool->preview().replaced;
      for (const DisplayPart& part : model->parts) {
        if (part.group == kStockGroup) all.push_back(part.soup);
      }
      return all;
    };
    const auto bar = triangles();
    QVERIFY(lathe.spin() && lathe.cutTo(23.0) && lathe.endPass());
    const auto cut = triangles();
    QCOMPARE(cut.size(), bar.size());
    QVERIFY(cut.front() == bar.front());  // in the chuck
    QVERIFY(cut.back() != bar.back());
    lathe.undo();
    QVERIFY(triangles() == bar);
  }

  // The spindle continues and the slides rest; a tool inside the restored material is drawn back beside the bar, 1 mm
  // clear of its 25 mm, at the same position along the bed.
  void undoTakesBackThePassAndTheTool() {
    HandLathe lathe;
    QVERIFY(lathe.spin() && lathe.cutTo(23.0) && lathe.endPass());
    QVERIFY(lathe.cutTo(21.0));  // not in the document yet
    const double along = lathe.slide(kCarriageAxis);
    lathe.undo();
    const std::array<double, kLatheAxes> first = lathe.machine().slides;
    QVERIFY(std::abs(lathe.tool->moment()->tip.x() - 26.0) < 1e-9);
    QVERIFY(std::abs(lathe.slide(kCarriageAxis) - along) < 0.1);
    QCOMPARE(lathe.document.history()->count(), 2);
    QCOMPARE(lathe.document.history()->index(), 1);
    QVERIFY(lathe.machine().direction == 1 && lathe.machine().speed != 0.0 && lathe.machine().feed == 0.0);
    QCOMPARE(lathe.tool->returnCount(), 1);
    QVERIFY(std::abs(lathe.radiusAt(95.0) - 23.0) < 0.02);
    lathe.document.history()->redo();
    QVERIFY(std::abs(lathe.radiusAt(95.0) - 21.0) < 0.02);
    QVERIFY(lathe.machine().slides == first);
    QVERIFY(lathe.wind(LatheAxis::Carriage, 110.0));
    const std::array<double, kLatheAxes> clear = lathe.machine().slides;
    lathe.undo();
    lathe.undo();
    QVERIFY(!lathe.document.workpiece().part);
    QVERIFY(lathe.machine().slides == clear);  // clear of all material that came back
    QCOMPARE(lathe.tool->returnCount(), 1);
    QVERIFY(lathe.wind(LatheAxis::Carriage, 115.0));  // it can be moved
    QVERIFY(lathe.tool->collisions().empty());
  }

  // The tool is drawn straight back where it was stopped, or a millimetre before the jaws where that would be in them;
  // it does not go to where the pass began. The spindle stays at rest.
  void undoBesideTheJaws() {
    HandLathe lathe;
    QVERIFY(lathe.spin() && lathe.wind(LatheAxis::Carriage, 25.0) && lathe.wind(LatheAxis::Cross, 24.5));
    lathe.send(LatheCommand::Kind::Feed, -0.2);
    QVERIFY(QTest::qWaitFor([&] { return !lathe.tool->collisions().empty(); }));
    QVERIFY(lathe.tool->collisions().front().struck == LathePart::Jaws);
    QVERIFY(lathe.endPass());
    const double stopped = lathe.tool->moment()->tip.y();
    QVERIFY2(stopped < 20.5, qPrintable(QString::number(stopped)));  // at the jaws
    lathe.undo();
    const ProfilePoint tip = lathe.tool->moment()->tip;
    QVERIFY2(tip.y() > 19.99 && tip.y() < 21.0 + 1e-9, qPrintable(QString::number(tip.y())));
    QVERIFY2(std::abs(tip.x() - 26.0) < 1e-9, qPrintable(QString::number(tip.x())));
    QCOMPARE(lathe.machine().direction, 0);
    QCOMPARE(lathe.tool->returnCount(), 1);
  }

  // The distance of the tool from touching: a radius of the work for X, a face of it for Z.
  void howFarTheToolIsFromTouching() {
    HandLathe lathe;
    const auto tip = [&lathe] { return lathe.tool->moment()->tip; };
    QVERIFY(std::abs(lathe.tool->touchGap(true) - (tip().x() - 25.0)) < 1e-9);    // 20 mm beside the bar
    QVERIFY(std::abs(lathe.tool->touchGap(false) - (tip().y() - 100.0)) < 1e-6);  // and before it
    QVERIFY(lathe.spin() && lathe.cutTo(23.0) && lathe.endPass());
    QVERIFY(lathe.tool->touchGap(true) < ManualLatheTool::kTouching);
    QVERIFY(lathe.wind(LatheAxis::Carriage, 110.0));  // away along the bed, to measure
    QVERIFY(lathe.tool->touchGap(true) < ManualLatheTool::kTouching);
    // The size to be entered is that of the cut, not of the bar: ⌀46, and a little more as the work bends.
    QVERIFY(std::abs(*lathe.tool->touchedSize(true) - 46.0) < 0.04);
    QVERIFY(lathe.tool->touchGap(false) > 5.0);
    QVERIFY(lathe.wind(LatheAxis::Cross, 24.0));  // between the two diameters
    QVERIFY(std::abs(lathe.tool->touchGap(true) - 1.0) < 0.03);
  }

  void undoWithoutAStepStopsTheLathe() {
    HandLathe lathe;
    QVERIFY(lathe.spin());
    QVERIFY(lathe.runner.undo() == ToolReply::Used);
    QVERIFY(QTest::qWaitFor([&] { return lathe.machine().speed == 0.0; }));
    QVERIFY(lathe.runner.undo() == ToolReply::Ignored);
  }

  // A curl at the tip while it cuts, unless it is switched off.
  void chipsWhileCutting() {
    HandLathe lathe;
    QVERIFY(lathe.spin());
    const std::size_t lines = lathe.tool->preview().lines.size();
    QVERIFY(lathe.wind(LatheAxis::Carriage, 101.0) && lathe.wind(LatheAxis::Cross, 23.0));
    lathe.send(LatheCommand::Kind::Feed, -0.2);
    QVERIFY(QTest::qWaitFor([&] { return lathe.tool->moment()->load.isCutting; }));
    const auto now = lathe.tool->preview().lines;
    QCOMPARE(now.size(), lines + 1);
    for (const Vec3& p : now.back()) QVERIFY(p.allFinite() && p.y() >= -4.0 && (p - now.back()[0]).norm() < 40.0);
    lathe.runner.setSetting("chips", false);
    QCOMPARE(lathe.tool->preview().lines.size(), lines);
    QCOMPARE(lathe.document.history()->count(), 0);
  }

  // Each key has its slide and its direction, whatever was turned before: mm along the axis and across it.
  void keysHaveTheirSlides() {
    struct Move {
      const char* action;
      double along, across;
    };
    constexpr Move kMoves[] = {
        {"carriage-left", -0.2, 0.0},       {"cross-in", 0.0, -0.02},         {"carriage-right", 0.2, 0.0},
        {"cross-out", 0.0, 0.02},           {"carriage-far-left", -2.0, 0.0}, {"cross-far-in", 0.0, -0.2},
        {"carriage-fine-right", 0.02, 0.0}, {"cross-fine-in", 0.0, -0.002},   {"carriage-fine-left", -0.02, 0.0},
        {"cross-fine-out", 0.0, 0.002},     {"carriage-far-right", 2.0, 0.0}, {"cross-far-out", 0.0, 0.2}};
    HandLathe lathe;
    double z = lathe.slide(kCarriageAxis), r = lathe.slide(kCrossAxis);
    for (const Move& move : kMoves) {
      z += move.along, r += move.across;
      QVERIFY(lathe.runner.perform(move.action) == ToolReply::Used);
      const auto isThere = [&] {
        return std::abs(lathe.slide(kCarriageAxis) - z) < 1e-9 && std::abs(lathe.slide(kCrossAxis) - r) < 1e-9;
      };
      QVERIFY2(QTest::qWaitFor(isThere), move.action);
    }
  }

  // The traverse has the speed of the machine, only while the key is held; into the work it is a crash.
  void rapidTraverse() {
    HandLathe lathe(std::chrono::milliseconds(1));
    const double from = lathe.slide(kCarriageAxis);
    lathe.runner.perform("carriage-rapid-left");
    QVERIFY(QTest::qWaitFor([&] { return lathe.slide(kCarriageAxis) < from - 5.0; }));
    const auto before = lathe.tool->moment();
    QVERIFY(QTest::qWaitFor([&] { return lathe.tool->moment()->machine.time > before->machine.time; }));
    const LatheState now = lathe.machine();
    const double travel = before->machine.slides[kCarriageAxis] - now.slides[kCarriageAxis];
    QVERIFY(std::abs(travel - lathe.tool->setup().rapidSpeed * (now.time - before->machine.time)) < 1e-6);
    lathe.runner.deliver([&] { lathe.tool->stopRapids(); });
    QVERIFY(QTest::qWaitFor([&] { return lathe.machine().rapids[kCarriageAxis] == 0; }));
    QVERIFY(lathe.wind(LatheAxis::Carriage, 60.0));
    lathe.runner.perform("cross-rapid-in");
    QVERIFY(QTest::qWaitFor([&] { return !lathe.tool->collisions().empty(); }));
    QVERIFY(lathe.tool->collisions().front().cause == CrashCause::Rapid);
    QVERIFY(lathe.slide(kCrossAxis) >= 25.0 - 1e-9);
    QCOMPARE(lathe.radiusAt(60.0), 25.0);
  }

  // A crash is in the document at once, and once, also after undo.
  void crashesAreRecordedOnce() {
    HandLathe lathe;
    QVERIFY(lathe.crash());
    QVERIFY(lathe.tool->hasToCommit());
    QVERIFY(!lathe.endPass());  // nothing was cut
    QVERIFY(!lathe.tool->hasToCommit());
    QVERIFY(lathe.document.isModified() && !lathe.document.workpiece().part);
    QCOMPARE(lathe.document.history()->count(), 0);
    QVERIFY(lathe.wind(LatheAxis::Cross, 30.0));
    QVERIFY(lathe.spin() && lathe.cutTo(23.0) && lathe.endPass());
    QCOMPARE(lathe.tool->collisions().size(), std::size_t{1});
    QCOMPARE(lathe.crashes(), std::size_t{1});
    lathe.undo();
    QVERIFY(lathe.spin() && lathe.cutTo(24.0) && lathe.endPass());
    QCOMPARE(lathe.crashes(), std::size_t{1});
    QVERIFY(lathe.document.workpiece().crashes->front().cause == CrashCause::SpindleAtRest);
  }

  // Also a crash after the last pass in the document, and even if all passes are undone.
  void undoTakesNoCrashBack() {
    HandLathe lathe;
    QVERIFY(lathe.spin() && lathe.cutTo(23.0) && lathe.endPass());
    QVERIFY(lathe.wind(LatheAxis::Cross, 30.0));
    lathe.runner.perform("revert");
    QVERIFY(QTest::qWaitFor([&] { return lathe.machine().speed == 0.0; }));
    QVERIFY(lathe.crash());
    lathe.undo();
    QCOMPARE(lathe.crashes(), std::size_t{1});
    while (lathe.document.history()->canUndo()) lathe.undo();  // drawn back, the edge may have touched the shoulder
    QVERIFY(!lathe.document.workpiece().part);
    QCOMPARE(lathe.crashes(), std::size_t{1});
    lathe.document.history()->redo();
    QVERIFY(lathe.document.workpiece().part);
    QCOMPARE(lathe.crashes(), std::size_t{1});
  }

  // Starting another tool loses neither a crash nor what the automatic feed has cut until then.
  void theEndOfTheToolLosesNothing() {
    HandLathe lathe;
    QVERIFY(lathe.crash());
    QVERIFY(lathe.wind(LatheAxis::Cross, 30.0));
    QVERIFY(lathe.spin() && lathe.cutTo(23.0));
    lathe.runner.stop();
    QVERIFY(!lathe.runner.tool());
    QCOMPARE(lathe.document.history()->count(), 1);
    QCOMPARE(lathe.crashes(), std::size_t{1});
    const TurnedPart& part = *lathe.document.workpiece().part;
    const double radius = part.profile.radius(static_cast<std::size_t>(std::lround(95.0 / part.profile.spacing())));
    QVERIFY(std::abs(radius - 23.0) < 0.02);
    QCOMPARE(part.passes.size(), std::size_t{1});
  }

  // Saving while the feed runs saves the cut so far, and the feed continues.
  void savingTakesThePassAlong() {
    HandLathe lathe;
    QVERIFY(lathe.spin() && lathe.wind(LatheAxis::Carriage, 101.0) && lathe.wind(LatheAxis::Cross, 23.0));
    lathe.send(LatheCommand::Kind::Feed, -0.2);
    QVERIFY(QTest::qWaitFor([&] { return lathe.slide(kCarriageAxis) < 95.0; }));
    lathe.document.settle();
    const auto part = lathe.document.workpiece().part;
    QVERIFY(part);
    QVERIFY(std::abs(part->profile.radius(static_cast<std::size_t>(std::lround(97.0 / 0.05))) - 23.0) < 0.02);
    const double there = lathe.slide(kCarriageAxis);
    QVERIFY(QTest::qWaitFor([&] { return lathe.slide(kCarriageAxis) < there - 2.0; }));
    QVERIFY(lathe.machine().feed == -0.2 && lathe.tool->collisions().empty());
    lathe.document.settle();
    QCOMPARE(lathe.document.history()->count(), 2);
    lathe.runner.perform("revert");
    lathe.document.settle();  // no gesture is under travel
    QVERIFY(lathe.document.history()->count() <= 3);
  }

  // An autosave has the cuts of passes under travel, which continue; its part is that of its passes, bit for bit.
  void anAutosaveHasThePassUnderWay() {
    HandLathe lathe;
    QVERIFY(!lathe.tool->withGesture());
    QVERIFY(lathe.spin() && lathe.wind(LatheAxis::Carriage, 101.0) && lathe.wind(LatheAxis::Cross, 23.0));
    QVERIFY(!lathe.tool->withGesture());
    lathe.send(LatheCommand::Kind::Feed, -0.2);
    QVERIFY(QTest::qWaitFor([&] { return lathe.slide(kCarriageAxis) < 95.0; }));
    const auto kept = std::static_pointer_cast<const WorkpieceSnapshot>(lathe.tool->withGesture());
    QVERIFY(kept && kept->part && kept->part->passes.size() == 1);
    QVERIFY(std::abs(kept->part->profile.radius(static_cast<std::size_t>(std::lround(97.0 / 0.05))) - 23.0) < 0.02);
    TurnedProfile again(kept->stock, 0.05);
    FinishMeter meter(again, SurfaceFinish(again.size()));
    cut(again, kept->part->passes.front(), 0, meter);
    QVERIFY(again == kept->part->profile && meter.finish() == kept->part->finish);
    // Nothing was committed, and the pass is one step when it ends.
    QVERIFY(!lathe.document.workpiece().part && lathe.document.history()->count() == 0);
    const double there = lathe.slide(kCarriageAxis);
    QVERIFY(QTest::qWaitFor([&] { return lathe.slide(kCarriageAxis) < there - 2.0; }));
    QVERIFY(lathe.endPass());
    QCOMPARE(lathe.document.history()->count(), 1);
    QCOMPARE(lathe.document.workpiece().part->passes.size(), std::size_t{1});
  }

  // Saved with the blade in its groove, the file opens with a lathe that stands clear of it, and nothing was struck.
  void savedWithTheToolInAGroove() {
    HandLathe lathe;
    QVERIFY(!lathe.tool->mount(0, "grooving-2"));
    QVERIFY(lathe.spin() && lathe.wind(LatheAxis::Carriage, 60.0) && lathe.wind(LatheAxis::Cross, 26.0));
    lathe.send(LatheCommand::Kind::Feed, -0.05, LatheAxis::Cross);
    QVERIFY(QTest::qWaitFor([&] { return lathe.slide(kCrossAxis) < 22.0; }));
    lathe.document.settle();
    Container container;
    lathe.kind.save(lathe.document.workpiece(), container);
    std::vector<Error> damage;
    const auto loaded = lathe.kind.load(container, damage, {});
    QVERIFY(loaded.hasValue() && damage.empty());
    const auto opened = std::static_pointer_cast<const WorkpieceSnapshot>(*loaded);
    QVERIFY(opened->part && !opened->crashes);
    // The saved pass continues, in and out.
    const double there = lathe.slide(kCrossAxis);
    QVERIFY(QTest::qWaitFor([&] { return lathe.slide(kCrossAxis) < there; }));
    lathe.send(LatheCommand::Kind::Feed, 0.0, LatheAxis::Cross);
    QVERIFY(QTest::qWaitFor([&] { return lathe.machine().feed == 0.0; }));
    QVERIFY(lathe.wind(LatheAxis::Cross, 30.0));
    QVERIFY(lathe.tool->collisions().empty() && !lathe.document.workpiece().crashes);
    HandLathe other(opened);
    QVERIFY(other.spin());
    QVERIFY(other.wind(LatheAxis::Carriage, 90.0) && other.tool->collisions().empty());
  }

  void toolsAreMounted() {
    HandLathe lathe;
    QVERIFY(!lathe.tool->mount(0, "facing"));
    QCOMPARE(lathe.document.history()->count(), 1);
    QVERIFY(lathe.tool->moment()->tool && lathe.tool->moment()->tool->id == "facing");
    QVERIFY(!lathe.tool->setup().stations[0].hasOffset[0]);
    QVERIFY(!lathe.tool->mount(0, "drill-12"));
    QCOMPARE(lathe.tool->setup().tailstock.drill, std::string("drill-12"));
    QVERIFY(lathe.tool->setup().tailstock.fitting == LatheFitting::Drill);
    QVERIFY(lathe.tool->mount(0, "spoon") == MountRefusal::Unknown);
    QVERIFY(lathe.tool->mount(99, "facing") == MountRefusal::Unknown);
    QVERIFY(lathe.spin());
    QVERIFY(lathe.tool->mount(0, "grooving-2") == MountRefusal::Turning);
    lathe.runner.perform("revert");
    QVERIFY(QTest::qWaitFor([&] { return lathe.machine().speed == 0.0; }));
    // Close before the face a file, which is 20 mm wide, would be in the work.
    QVERIFY(lathe.wind(LatheAxis::Carriage, 106.0) && lathe.wind(LatheAxis::Cross, 10.0));
    QVERIFY(lathe.tool->mount(0, "file-flat") == MountRefusal::InTheWay);
    LatheSetup allowed = lathe.tool->setup();
    allowed.allowed = {"facing"};
    QVERIFY(lathe.tool->setUp(allowed, "Set up"));
    QVERIFY(lathe.tool->mount(0, "right-roughing") == MountRefusal::NotAllowed);
    QVERIFY(!lathe.tool->mount(0, ""));
    QVERIFY(!lathe.tool->moment()->tool);
    lathe.undo();
    QVERIFY(lathe.tool->moment()->tool && lathe.tool->moment()->tool->id == "facing");
  }
};

HANDWHEEL_TEST(ManualLatheToolTest)
#include "ManualLatheToolTest.moc"

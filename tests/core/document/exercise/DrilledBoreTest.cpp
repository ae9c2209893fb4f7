// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "TurningExercises.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/exercise/TurningMeasurements.h"
#include "machining/lathe/LatheJson.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// The diameter of a bore by the tool that has left it.
class DrilledBoreTest : public QObject {
  Q_OBJECT

 private slots:
  // A twist drill of 10 mm holds IT11, 0.090 mm, at best: its hole is no H7, whatever the simulation cuts, and may be
  // an H12. One that is bored to the same size is measured.
  void aDrilledHole() {
    const ExerciseKind kind(turningOnly());
    const auto exercise = exerciseFrom(kind, shoulderDescription());
    const auto figureOf = [&](const char* tool, const ProfilePoint& from, const ProfilePoint& to, double width) {
      WorkpieceSnapshot work = static_cast<const WorkpieceSnapshot&>(*exercise->subject->start(*exercise->task));
      for (const char* const id : {"drill-10", tool}) {
        TurningPass pass;
        pass.tool = toolNamed(shippedLatheTools(), id);
        pass.side = TurningSide::Bore;
        const bool isDrill = std::string_view(id) == "drill-10";
        pass.path = {isDrill ? ProfilePoint(0.0, 105.0) : from, isDrill ? ProfilePoint(0.0, 40.0) : to};
        pass.times = {0.0, 65.0};
        pass.speeds = {600.0, 600.0};
        work.part = withPass(work, pass, 0.02);
        if (std::string(tool) == id) break;
      }
      MarkingCriterion c{.id = "b", .name = "⌀", .figure = "bore", .arguments = {70, 98}};
      c.lower = 9.9;
      c.upper = 9.9 + width;
      return MeasuredPart(static_cast<const TurningTask&>(*exercise->task), work, {}).measure(c);
    };
    const ProfilePoint axis(0.0, 0.0);
    const Measurement fine = figureOf("drill-10", axis, axis, 0.015);
    const Measurement coarse = figureOf("drill-10", axis, axis, 0.15);
    QVERIFY(!fine.value);
    QCOMPARE(fine.remark.inEnglish(),
             std::string("a twist drill leaves H11 to H12, here +0.09 mm: bore or ream a finer hole"));
    QVERIFY(coarse.value && std::abs(*coarse.value - 10.0) < 0.02);
    const Measurement bored = figureOf("boring-8", ProfilePoint(6.0, 104.0), ProfilePoint(6.0, 60.0), 0.015);
    QVERIFY2(bored.value && std::abs(*bored.value - 12.0) < 0.02, bored.remark.inEnglish().c_str());
  }
};

HANDWHEEL_TEST(DrilledBoreTest)
#include "DrilledBoreTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "TurningExercises.h"
#include "document/workpiece/exercise/TurningFigures.h"
#include "document/workpiece/exercise/TurningTask.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;
using Json = nlohmann::json;

namespace {

std::shared_ptr<const ExerciseSnapshot> shoulder() {
  static const ExerciseKind kKind(turningOnly());
  static const auto kExercise = exerciseFrom(kKind, shoulderDescription());
  return kExercise;
}

}  // namespace

// What work asked of the lathe, what must not happen at it, and where: as it is said of passes, in marks and reports.
class TurningLoadsTest : public QObject {
  Q_OBJECT

 private slots:
  // The peak is that of Kienzle's law for a groove as wide as the cut.
  void forceAndPower() {
    const TurningTask& task = static_cast<const TurningTask&>(*shoulder()->task);
    const Json work = {{"passes", {{{"nose_radius", 0.8}, {"feed", 0.3}, {"points", {{18.8, 100}, {18.8, 60}}}}}}};
    const auto snapshot = workFrom(*shoulder(), work);
    const MeasuredPart part(task, static_cast<const WorkpieceSnapshot&>(*snapshot), {});
    double force = 0.0, power = 0.0;
    for (const auto& load : part.loads()) force = std::max(force, load.force), power = std::max(power, load.power);
    // 2 mm deep at 0.3 mm: Fc = 1500 · 2 · 0.3^(1 - 0.22); Pc = Fc v / 60000 at ⌀40 and 600 r/min. The end of the nose
    // makes the cut up to a fiftieth wider.
    const double expected = 1500.0 * 2.0 * std::pow(0.3, 0.78), speed = M_PI * 40.0 * 600.0 / 1000.0;
    QVERIFY2(force > 0.999 * expected && force < 1.05 * expected, QByteArray::number(force));
    QVERIFY2(power > 0.999 * expected * speed / 60000 && power < 1.05 * expected * speed / 60000,
             QByteArray::number(power));
  }

  // What is said of a pass, or of a program, is of that alone, whatever was cut before.
  void loadsOfEachPass() {
    const TurningTask& task = static_cast<const TurningTask&>(*shoulder()->task);
    const Json heavy = {{"nose_radius", 0.8}, {"feed", 0.3}, {"points", {{18.8, 100}, {18.8, 60}}}};
    const Json light = {{"nose_radius", 0.8}, {"feed", 0.1}, {"points", {{18.3, 100}, {18.3, 70}}}};
    const auto one = workFrom(*shoulder(), {{"passes", {heavy}}});
    const auto two = workFrom(*shoulder(), {{"passes", {heavy, light}}});
    const auto& before = static_cast<const WorkpieceSnapshot&>(*one);
    const auto& after = static_cast<const WorkpieceSnapshot&>(*two);
    // As above: 2 mm at 0.3 mm from ⌀40, then 0.5 mm at 0.1 mm from ⌀36.
    const auto isCut = [](const std::pair<double, double>& peaks, double depth, double feed, double diameter) {
      const double force = 1500.0 * depth * std::pow(feed, 0.78);
      const double power = force * M_PI * diameter * 600.0 / 1000.0 / 60000.0;
      return peaks.first > 0.999 * force && peaks.first < 1.05 * force && peaks.second > 0.999 * power &&
             peaks.second < 1.05 * power;
    };
    const auto all = peakLoads(task, after, nullptr), last = peakLoads(task, after, before.part.get());
    QVERIFY(all && last);
    QVERIFY2(isCut(*all, 2.0, 0.3, 40.0), QByteArray::number(all->first));
    QVERIFY2(isCut(*last, 0.5, 0.1, 36.0), QByteArray::number(last->first));
    const auto none = peakLoads(task, after, after.part.get());
    QVERIFY(none && none->first == 0.0 && none->second == 0.0);
  }
};

HANDWHEEL_TEST(TurningLoadsTest)
#include "TurningLoadsTest.moc"

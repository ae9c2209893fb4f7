// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ScriptReplay.h"
#include "SculptFixture.h"
#include "TestClass.h"
#include "tools/mesh/ScriptErrors.h"

#include <QTest>

using namespace handwheel;

// What is sculpted, done once more by its steps: the same bytes, levels included.
class SculptScriptTest : public QObject {
  Q_OBJECT

 private slots:
  void brushes_data();
  void brushes();
  void levels();
  void noise();
  void levelsThatWereForgotten();

 private:
  static std::string stepOf(const test::SculptFixture& bench, std::size_t i) {
    return scriptLinesSince(*bench.document).value().at(i);
  }
};

void SculptScriptTest::brushes_data() {
  QTest::addColumn<double>("brush");
  QTest::addColumn<bool>("onPatch");
  const char* names[] = {"drag", "smooth", "inflate", "flatten"};
  for (int brush = 0; brush < 4; ++brush) {
    QTest::newRow(names[brush]) << double(brush) << false;
    QTest::addRow("%s of a patch", names[brush]) << double(brush) << true;
  }
}

void SculptScriptTest::brushes() {
  QFETCH(double, brush);
  QFETCH(bool, onPatch);
  test::SculptFixture bench(onPatch ? test::middle() : FaceSelection());
  bench.lift(1.25);  // else there is nothing to smooth or flatten
  bench.runner.setSetting("brush", brush);
  bench.runner.setSetting("moves_border", true);
  bench.runner.setSetting("strength", 0.3);
  bench.stroke({{9.1, 10.2}, {11.0, 11.5}, {12.3, 10.1}});
  bench.stroke({{10.0, 10.0}, {8.7, 9.9}}, {true, false, false});   // smooths
  bench.stroke({{10.0, 10.0}, {9.1, 10.9}}, {false, true, false});  // the other way
  QVERIFY(bench.steps() >= 3);
  QCOMPARE(test::replayed(test::sheet(), *bench.document), std::string());
}

void SculptScriptTest::levels() {
  test::SculptFixture bench(test::middle());
  bench.runner.perform("subdivide");
  QVERIFY2(stepOf(bench, 0).starts_with("subdivide --patch "), stepOf(bench, 0).c_str());
  bench.lift(0.5);
  bench.runner.perform("subdivide");
  bench.runner.perform("coarser");
  bench.runner.perform("coarser");
  bench.lift(1.0, 9.0);
  QVERIFY2(QString::fromStdString(stepOf(bench, 3)).contains(" --finest 2 --level 0 "), stepOf(bench, 3).c_str());
  QCOMPARE(test::replayed(test::sheet(), *bench.document), std::string());
  bench.runner.perform("back");
  bench.runner.perform("finer");
  bench.lift(-0.3);
  QVERIFY2(stepOf(bench, 4).starts_with("level-back --patch "), stepOf(bench, 4).c_str());
  QCOMPARE(test::replayed(test::sheet(), *bench.document), std::string());
  bench.document->history()->undo();
  bench.document->history()->undo();
  bench.lift(0.25);
  QCOMPARE(test::replayed(test::sheet(), *bench.document), std::string());
}

void SculptScriptTest::noise() {
  for (const FaceSelection& patch : {FaceSelection(), test::middle()}) {
    test::SculptFixture bench(patch);
    for (const double x : {3.0, 6.0, 9.0}) bench.lift(0.05, x);
    bench.runner.setSetting("noise_angle", 0.7);
    bench.runner.setSetting("moves_border", true);
    bench.runner.perform("noise");
    QCOMPARE(test::replayed(test::sheet(), *bench.document), std::string());
  }
}

// A step on levels that nobody has is an error, not a stroke elsewhere.
void SculptScriptTest::levelsThatWereForgotten() {
  test::SculptFixture bench(test::middle());
  bench.runner.perform("subdivide");
  bench.lift(0.5);
  const auto document = test::meshDocument(test::sheet());
  const auto done = applyScriptLine(*document, stepOf(bench, 1));
  QVERIFY(!done && done.error().code == ScriptError::Malformed);
  QCOMPARE(document->history()->count(), 0);
}

HANDWHEEL_TEST(SculptScriptTest)
#include "SculptScriptTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ScriptReplay.h"
#include "SculptFixture.h"
#include "TestClass.h"
#include "tools/mesh/ScriptErrors.h"

#include <QTest>

using namespace handwheel;

// Tests that replaying the steps of sculpting gives the same bytes, including levels.
class SculptScriptTest : public QObject {
  Q_OBJECT

 private slots:
  void brushes_data();
  void brushes();
  void levels();
  void noise();
  void levelsThatWereForgotten();

 private:
  static std::string stepOf(const test::SculptFixture& fixture, std::size_t i) {
    return scriptLinesSince(*fixture.document).value().at(i);
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
  test::SculptFixture fixture(onPatch ? test::middle() : FaceSelection());
  fixture.lift(1.25);  // else there is nothing to smooth or flatten
  fixture.runner.setSetting("brush", brush);
  fixture.runner.setSetting("moves_border", true);
  fixture.runner.setSetting("strength", 0.3);
  fixture.stroke({{9.1, 10.2}, {11.0, 11.5}, {12.3, 10.1}});
  fixture.stroke({{10.0, 10.0}, {8.7, 9.9}}, {true, false, false});   // smooths
  fixture.stroke({{10.0, 10.0}, {9.1, 10.9}}, {false, true, false});  // the opposite direction
  QVERIFY(fixture.steps() >= 3);
  QCOMPARE(test::replayed(test::sheet(), *fixture.document), std::string());
}

void SculptScriptTest::levels() {
  test::SculptFixture fixture(test::middle());
  fixture.runner.perform("subdivide");
  QVERIFY2(stepOf(fixture, 0).starts_with("subdivide --patch "), stepOf(fixture, 0).c_str());
  fixture.lift(0.5);
  fixture.runner.perform("subdivide");
  fixture.runner.perform("coarser");
  fixture.runner.perform("coarser");
  fixture.lift(1.0, 9.0);
  QVERIFY2(QString::fromStdString(stepOf(fixture, 3)).contains(" --finest 2 --level 0 "), stepOf(fixture, 3).c_str());
  QCOMPARE(test::replayed(test::sheet(), *fixture.document), std::string());
  fixture.runner.perform("back");
  fixture.runner.perform("finer");
  fixture.lift(-0.3);
  QVERIFY2(stepOf(fixture, 4).starts_with("level-back --patch "), stepOf(fixture, 4).c_str());
  QCOMPARE(test::replayed(test::sheet(), *fixture.document), std::string());
  fixture.document->history()->undo();
  fixture.document->history()->undo();
  fixture.lift(0.25);
  QCOMPARE(test::replayed(test::sheet(), *fixture.document), std::string());
}

void SculptScriptTest::noise() {
  for (const FaceSelection& patch : {FaceSelection(), test::middle()}) {
    test::SculptFixture fixture(patch);
    for (const double x : {3.0, 6.0, 9.0}) fixture.lift(0.05, x);
    fixture.runner.setSetting("noise_angle", 0.7);
    fixture.runner.setSetting("moves_border", true);
    fixture.runner.perform("noise");
    QCOMPARE(test::replayed(test::sheet(), *fixture.document), std::string());
  }
}

// A step on levels that nobody has is an error, not a stroke elsewhere.
void SculptScriptTest::levelsThatWereForgotten() {
  test::SculptFixture fixture(test::middle());
  fixture.runner.perform("subdivide");
  fixture.lift(0.5);
  const auto document = test::meshDocument(test::sheet());
  const auto done = applyScriptLine(*document, stepOf(fixture, 1));
  QVERIFY(!done && done.error().code == ScriptError::Malformed);
  QCOMPARE(document->history()->count(), 0);
}

HANDWHEEL_TEST(SculptScriptTest)
#include "SculptScriptTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/Fidelity.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

FidelitySetting fidelityChord() {
  FidelitySetting s;
  s.id = "nurbs.chord_mm";
  s.label = "Chord";
  s.scale = FidelityScale::Logarithmic;
  s.least = 1e-4;
  s.largest = 1.0;
  s.standard = 0.01;
  s.presets = {0.1, 0.02, 0.001};
  return s;
}

FidelitySetting method() {
  FidelitySetting s;
  s.id = "mesh.method";
  s.label = "Method";
  setChoices(s, {"ear", "minimal", "fair"});
  s.standard = 2;
  s.presets = {0, 1, 2};
  return s;
}

FidelitySetting faces() {
  FidelitySetting s;
  s.id = "view.faces";
  s.label = "Faces";
  s.least = 1;
  s.largest = 11;
  s.whole = true;
  s.standard = 5;
  s.presets = {1, 5, 11};
  return s;
}

}  // namespace

class FidelityTest : public QObject {
  Q_OBJECT

 private slots:
  void valuesOutsideAreRefused();
  void texts();
  void placesAndValues();
  void positionAndValueAreInverse();
  void choosing();
};

void FidelityTest::valuesOutsideAreRefused() {
  QVERIFY(checkValue(fidelityChord(), 1e-4));
  QVERIFY(checkValue(fidelityChord(), 1.0));
  for (double bad : {0.0, -1.0, 1.0001, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const Status status = checkValue(fidelityChord(), bad);
    QVERIFY(!status);
    QVERIFY(status.error().code == ErrorCode::ValueOutOfRange);
    QCOMPARE(status.error().arguments[0], std::string("nurbs.chord_mm"));
    QCOMPARE(status.error().arguments[2], std::string("1e-04"));
    QCOMPARE(status.error().arguments[3], std::string("1"));
  }
  QVERIFY(!checkValue(method(), 0.5));
  QVERIFY(!checkValue(method(), 3.0));
  QVERIFY(!checkValue(faces(), 1.5));
  QCOMPARE(checkValue(method(), 7.0).error().arguments, (std::vector<std::string>{"mesh.method", "7", "ear", "fair"}));
}

void FidelityTest::texts() {
  QCOMPARE(textOf(method(), 1), std::string("minimal"));
  QCOMPARE(textOf(fidelityChord(), 0.1), std::string("0.1"));
  QCOMPARE(*valueOf(method(), "fair"), 2.0);
  QCOMPARE(*valueOf(fidelityChord(), "1e-3"), 1e-3);
  for (const char* bad : {"", "0.1mm", "fair", "0,1", " 0.1"}) {
    QVERIFY(valueOf(fidelityChord(), bad).error().code == ErrorCode::NumberMalformed);
  }
  QVERIFY(valueOf(method(), "1").error().code == ErrorCode::NumberMalformed);  // a word is asked for
  QVERIFY(valueOf(fidelityChord(), "2").error().code == ErrorCode::ValueOutOfRange);
  QVERIFY(valueOf(fidelityChord(), "nan").error().code == ErrorCode::ValueOutOfRange);
  QVERIFY(rc::check("text reads back to the same value", [] {
    const double value = valueAt(fidelityChord(), *rc::gen::inRange(0, 1'000'001) * 1e-6);
    RC_ASSERT(*valueOf(fidelityChord(), textOf(fidelityChord(), value)) == value);
  }));
}

void FidelityTest::placesAndValues() {
  QCOMPARE(scalePositionOf(fidelityChord(), 0.01), 0.5);
  QCOMPARE(valueAt(fidelityChord(), 0.75), 0.1);
  QCOMPARE(scalePositionOf(faces(), 6), 0.5);
  QCOMPARE(valueAt(faces(), 0.26), 4.0);  // 3.6
  QCOMPARE(valueAt(method(), 0.5), 1.0);
  for (const FidelitySetting& s : {fidelityChord(), method(), faces()}) {
    QCOMPARE(valueAt(s, -1.0), s.least);
    QCOMPARE(valueAt(s, 2.0), s.largest);
  }
}

void FidelityTest::positionAndValueAreInverse() {
  QVERIFY(rc::check("place and value are inverse, values are valid", [] {
    const double position = *rc::gen::inRange(0, 1'000'001) * 1e-6;
    RC_ASSERT(std::abs(scalePositionOf(fidelityChord(), valueAt(fidelityChord(), position)) - position) < 1e-12);
    const double value = valueAt(fidelityChord(), position);
    RC_ASSERT(bool(checkValue(fidelityChord(), value)));
    RC_ASSERT(bool(checkValue(faces(), valueAt(faces(), position))));
    RC_ASSERT(bool(checkValue(method(), valueAt(method(), position))));
  }));
}

void FidelityTest::choosing() {
  FidelityValues values;
  QCOMPARE(values.of(fidelityChord()), 0.01);
  values = FidelityValues(FidelityPreset::Draft);
  QCOMPARE(values.of(fidelityChord()), 0.1);
  QCOMPARE(values.of(method()), 0.0);
  QVERIFY(values.set(fidelityChord(), 0.5));
  QCOMPARE(values.of(fidelityChord()), 0.5);
  QCOMPARE(values.of(method()), 0.0);  // the rest stays with the preset
  QVERIFY(!values.set(fidelityChord(), 5.0));
  QCOMPARE(values.of(fidelityChord()), 0.5);  // a refused value changes nothing
  QCOMPARE(values.overrides().size(), std::size_t{1});
  QCOMPARE(wordFor(FidelityPreset::Balanced), std::string_view("Balanced"));
}

HANDWHEEL_TEST(FidelityTest)
#include "FidelityTest.moc"

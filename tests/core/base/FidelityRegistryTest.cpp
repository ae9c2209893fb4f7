// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/FidelityRegistry.h"

#include <rapidcheck.h>
#include <QTest>

using namespace handwheel;

namespace {

FidelitySetting chord() {
  FidelitySetting s;
  s.id = "nurbs.chord_mm";
  s.label = "Chord";
  s.scale = FidelityScale::Logarithmic;
  s.least = 1e-4;
  s.largest = 1.0;
  s.standard = 0.03;
  s.presets = {0.1, 0.03, 0.001};
  s.error = {"largest distance", "mm"};
  s.cost = {"CPU time", "ms"};
  return s;
}

FidelityRegistry twoSettings() {
  FidelitySetting method;
  method.id = "mesh.method";
  method.label = "Method";
  setChoices(method, {"ear", "fair"});
  method.error = {"deviation", "mm"};
  method.cost = {"CPU time", "ms"};
  FidelityRegistry registry;
  registry.add(chord(), {});
  registry.add(method, {});
  return registry;
}

}  // namespace

class FidelityRegistryTest : public QObject {
  Q_OBJECT

 private slots:
  void registry();
  void chosenValuesAsText();
  void wrongChoices_data();
  void wrongChoices();
};

void FidelityRegistryTest::registry() {
  FidelityRegistry registry;
  registry.add(chord(), {{"list", "closed form", {}}});
  QCOMPARE(registry.entries().size(), std::size_t{1});
  QVERIFY(registry.find("nurbs.chord_mm"));
  QCOMPARE(registry.find("nurbs.chord_mm")->cases.front().name, std::string("list"));
  QVERIFY(!registry.find("nurbs.chord"));
}

void FidelityRegistryTest::chosenValuesAsText() {
  const FidelityRegistry all = twoSettings();
  const FidelitySetting& method = all.find("mesh.method")->setting;
  QVERIFY(readValues(all, "").value() == FidelityValues());
  QVERIFY(readValues(all, "exact").value() == FidelityValues(FidelityPreset::Exact));
  const FidelityValues values = readValues(all, "draft,mesh.method=fair,nurbs.chord_mm=0.25").value();
  QCOMPARE(values.of(chord()), 0.25);
  QCOMPARE(values.of(method), 1.0);
  QVERIFY(values.preset() == FidelityPreset::Draft);
  QCOMPARE(textOf(all, values), std::string("draft,mesh.method=fair,nurbs.chord_mm=0.25"));
  QVERIFY(rc::check("what is written reads back", [&] {
    const int preset = *rc::gen::inRange(-1, 3);
    FidelityValues chosen = preset < 0 ? FidelityValues() : FidelityValues(kFidelityPresets[preset]);
    if (*rc::gen::arbitrary<bool>()) RC_ASSERT(bool(chosen.set(method, *rc::gen::inRange(0, 2))));
    if (*rc::gen::arbitrary<bool>()) {
      RC_ASSERT(bool(chosen.set(chord(), valueAt(chord(), *rc::gen::inRange(0, 1001) * 1e-3))));
    }
    RC_ASSERT(readValues(all, textOf(all, chosen)).value() == chosen);
  }));
}

void FidelityRegistryTest::wrongChoices_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<ErrorCode>("code");
  const ErrorCode missing = ErrorCode::ReferenceMissing, malformed = ErrorCode::NumberMalformed;
  QTest::newRow("no such preset") << QByteArray("fast") << missing;
  QTest::newRow("preset not first") << QByteArray("nurbs.chord_mm=0.1,draft") << missing;
  QTest::newRow("no such setting") << QByteArray("draft,nurbs.chord=0.1") << missing;
  QTest::newRow("blank") << QByteArray("draft, nurbs.chord_mm=0.1") << missing;
  QTest::newRow("no value") << QByteArray("nurbs.chord_mm") << malformed;
  QTest::newRow("empty value") << QByteArray("nurbs.chord_mm=") << malformed;
  QTest::newRow("unit") << QByteArray("nurbs.chord_mm=0.1mm") << malformed;
  QTest::newRow("outside") << QByteArray("nurbs.chord_mm=7") << ErrorCode(ErrorCode::ValueOutOfRange);
}

void FidelityRegistryTest::wrongChoices() {
  QFETCH(QByteArray, text);
  QFETCH(ErrorCode, code);
  const Result<FidelityValues> read = readValues(twoSettings(), text.toStdString());
  QVERIFY(!read);
  QCOMPARE(read.error().code, code);
}

HANDWHEEL_TEST(FidelityRegistryTest)
#include "FidelityRegistryTest.moc"

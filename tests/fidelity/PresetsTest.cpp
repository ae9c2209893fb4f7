// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "TestClass.h"
#include "base/FidelityCurve.h"
#include "fidelity/CurveFile.h"
#include "fidelity/MeasuredSettings.h"

#include <QDate>
#include <QFile>
#include <QTest>
#include <limits>
#include <set>

using namespace handwheel;

// Presets are no matter of taste: the registry holds what the rule makes of the curves that are kept as data.
class PresetsTest : public QObject {
  Q_OBJECT

 private slots:
  void presetsFollowFromTheCurves_data();
  void presetsFollowFromTheCurves();
  void curveFilesReadBack();
  void damagedCurveFilesAreRefused();
};

void PresetsTest::presetsFollowFromTheCurves_data() {
  QTest::addColumn<QString>("id");
  const FidelityRegistry registry = measuredSettings();
  for (const auto& entry : registry.entries()) {
    QTest::newRow(entry.setting.id.c_str()) << QString::fromStdString(entry.setting.id);
  }
}

void PresetsTest::presetsFollowFromTheCurves() {
  QFETCH(QString, id);
  const FidelityRegistry registry = measuredSettings();
  const FidelityRegistry::Entry& entry = *registry.find(id.toStdString());
  QFile file(test::sourcePath("resources/fidelity/" + id + ".json"));
  QVERIFY2(file.open(QIODevice::ReadOnly), "'handwheel measure --write-curves' makes this file");
  const Result<CurveFile> curve = readCurveFile(entry.setting, file.readAll().toStdString());
  QVERIFY2(curve, curve ? "" : curve.error().arguments.back().c_str());
  QVERIFY(QDate::fromString(QString::fromStdString(curve.value().date), Qt::ISODate).isValid());
  QVERIFY(!curve.value().machine.empty());
  // On the very cases that are built in, each at the default too.
  std::set<std::string> measured, standard, builtIn;
  for (const FidelityRow& row : curve.value().rows) {
    measured.insert(row.testCase);
    if (row.value == entry.setting.standard) standard.insert(row.testCase);
  }
  for (const FidelityCase& c : entry.cases) builtIn.insert(c.name);
  QVERIFY(measured == builtIn);
  QVERIFY(standard == builtIn);
  const auto derived = derivedPresets(entry.setting, relativeCurveOf(entry.setting, curve.value().rows));
  QVERIFY(derived);
  for (FidelityPreset preset : kFidelityPresets) {
    QCOMPARE(QString::fromStdString(textOf(entry.setting, entry.setting.presetValue(preset))),
             QString::fromStdString(textOf(entry.setting, (*derived)[static_cast<std::size_t>(preset)])));
  }
}

void PresetsTest::curveFilesReadBack() {
  const FidelitySetting setting = chordSetting();
  CurveFile curve{"2026-07-01", "a \"machine\"", {}};
  for (double value : {1e-4, 0.01, 1.0 / 3.0}) {
    FidelityRow row;
    row.setting = setting.id;
    row.value = value;
    row.testCase = "bar, thin";
    row.error = value == 0.01 ? std::numeric_limits<double>::infinity() : 1.1 * value;
    row.errorUnit = setting.error.unit;
    row.cost = 1.0 / value;
    row.costUnit = setting.cost.unit;
    row.spread = 0.125;
    row.repeats = 7;
    row.seed = 0xffffffffffffffffu;
    row.truth = "closed form";
    curve.rows.push_back(row);
  }
  const std::string json = jsonOf(setting, curve);
  const Result<CurveFile> read = readCurveFile(setting, json);
  QVERIFY(read);
  QCOMPARE(read.value().machine, curve.machine);
  QCOMPARE(csvOf(setting, read.value().rows), csvOf(setting, curve.rows));
  QCOMPARE(jsonOf(setting, read.value()), json);
}

void PresetsTest::damagedCurveFilesAreRefused() {
  const FidelitySetting setting = chordSetting();
  const std::string good = jsonOf(setting, {"2026-07-01", "m", {}});
  QVERIFY(readCurveFile(setting, good));
  QVERIFY(!readCurveFile(blockFacesSetting(), good));
  for (std::size_t length = 0; length + 2 < good.size(); length += 7) {
    const Result<CurveFile> read = readCurveFile(setting, good.substr(0, length));
    QVERIFY(!read && read.error().code == ErrorCode::ElementMalformed);
  }
  for (const char* rows : {"3", "[1]", "[{}]", "[{\"value\":\"7\",\"case\":\"a\"}]", "[{\"value\":0.1}]"}) {
    std::string bad = good;
    bad.replace(bad.find("[\n  ]"), 5, rows);
    QVERIFY(!readCurveFile(setting, bad));
  }
  QVERIFY(machineClass().find(" cores") != std::string::npos);
  QVERIFY(QDate::fromString(QString::fromStdString(today()), Qt::ISODate).isValid());
}

HANDWHEEL_TEST(PresetsTest)
#include "PresetsTest.moc"

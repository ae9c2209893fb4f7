// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "fidelity/Calibration.h"
#include "fidelity/MeasuredSettings.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <limits>
#include <set>
#include <string>

using namespace handwheel;

namespace {

// A value v errs 1 / v and costs v; 1 gives no result.
FidelityRegistry madeUp(const char* testCase = "case") {
  FidelitySetting s;
  s.id = "made.up";
  s.label = "Made up";
  s.scale = FidelityScale::Logarithmic;
  s.least = 1.0;
  s.largest = 100.0;
  s.standard = 10.0;
  s.presets = {5.0, 10.0, 20.0};
  s.error = {"error", "mm"};
  s.cost = {"cost", "us"};
  s.budget = FidelityBudget::Tick;
  FidelityRegistry registry;
  registry.add(s,
               {{testCase, "closed form", [](double value, std::uint64_t, Progress) {
                   return FidelitySample{value == 1.0 ? std::numeric_limits<double>::infinity() : 1.0 / value, value};
                 }}});
  return registry;
}

Calibration measured(const FidelityRegistry& registry) {
  Calibration calibration;
  calibration.ticksInUse = {{500.0, 4.5}, {1000.0, 3.25}};
  if (!calibrate(registry.entries()[0], calibration, {})) qFatal("nothing cancels it");
  return calibration;
}

}  // namespace

class CalibrationTest : public QObject {
  Q_OBJECT

 private slots:
  void curvesAreMeasured() {
    const FidelityRegistry registry = madeUp();
    const Calibration calibration = measured(registry);
    const CurveFile& curve = calibration.curves.at("made.up");
    QCOMPARE(calibration.machine, machineClass());
    QCOMPARE(curve.date, today());
    QVERIFY(curve.rows.size() >= 5);
    for (const FidelityRow& row : curve.rows) QCOMPARE(row.cost, row.value);
  }

  void aFileReadsBack() {
    const QTemporaryDir folder;
    const auto path = std::filesystem::path(folder.path().toStdString()) / "new" / "folder" / "calibration.json";
    const FidelityRegistry registry = madeUp();
    const Calibration calibration = measured(registry);
    QVERIFY(loadCalibration(registry, path).error().code == ErrorCode::FileMissing);
    QVERIFY(storeCalibration(registry, calibration, path));
    const Result<Calibration> read = loadCalibration(registry, path);
    QVERIFY(read);
    QCOMPARE(read->machine, calibration.machine);
    QVERIFY(read->ticksInUse == calibration.ticksInUse);
    QCOMPARE(csvOf(registry.entries()[0].setting, read->curves.at("made.up").rows),
             csvOf(registry.entries()[0].setting, calibration.curves.at("made.up").rows));
    QCOMPARE(jsonOf(registry, *read), jsonOf(registry, calibration));
  }

  void whatCannotBeWrittenIsReported() {
    const FidelityRegistry registry = madeUp();
    QVERIFY(!storeCalibration(registry, measured(registry), "/proc/nowhere/calibration.json"));
  }

  void damagedFilesAreRefused() {
    const FidelityRegistry registry = madeUp();
    const std::string good = jsonOf(registry, measured(registry));
    for (std::size_t length = 0; length + 2 < good.size(); length += 11) {
      const Result<Calibration> read = readCalibration(registry, good.substr(0, length));
      QVERIFY(!read && read.error().code == ErrorCode::ElementMalformed);
    }
    const auto changed = [&](const char* from, const char* to) {
      std::string bad = good;
      const std::size_t at = bad.find(from);
      if (at == std::string::npos) qFatal("there is no %s", from);
      return readCalibration(registry, bad.replace(at, std::string(from).size(), to));
    };
    for (const char* version : {"0", "2", "-1"}) {
      const auto read = changed("\"version\": 1", (std::string("\"version\": ") + version).c_str());
      QVERIFY(!read && read.error().code == ErrorCode::VersionNewer);
    }
    QVERIFY(!changed("4.5", "-4.5"));
    QVERIFY(!changed("4.5", "\"much\""));
    QVERIFY(!changed("4.5", "null"));
    QVERIFY(!changed("\"value\": \"10\"", "\"value\": \"1e9\""));
    QVERIFY(!changed("\"cost\": 10", "\"cost\": -10"));
    QVERIFY(!changed("\"error\": 0.1", "\"error\": -0.1"));
  }

  // A program whose settings or cases are others measures them anew.
  void whatIsNotOfThisProgramIsLeftOut() {
    const FidelityRegistry registry = madeUp();
    const std::string json = jsonOf(registry, measured(registry));
    for (const FidelityRegistry& other : {madeUp("another case"), FidelityRegistry()}) {
      const Result<Calibration> read = readCalibration(other, json);
      QVERIFY(read && read->curves.empty());
    }
  }

  void cancelledItChangesNothing() {
    JobState state;
    FidelityRegistry registry = madeUp();
    FidelityRegistry::Entry entry = registry.entries()[0];
    int runs = 0;
    entry.cases[0].run = [&](double, std::uint64_t, Progress) {
      if (++runs == 3) state.cancelled = true;
      return FidelitySample{1.0, 1.0};
    };
    Calibration calibration;
    const Status status = calibrate(entry, calibration, Progress(state));
    QVERIFY(!status && status.error().code == ErrorCode::Cancelled);
    QCOMPARE(runs, 3);
    QVERIFY(calibration.curves.empty() && calibration.machine.empty());
  }

  // Time is what a machine changes. The loop comes first: Fit derives the others from its rate. What takes a hundredth
  // of a tick or frame whatever is chosen is not fitted; nor is what a plan may take, which has a time limit of its
  // own, or a volume, whose size people choose with its memory in view; nor the pieces of its display, which no frame
  // waits for.
  void theSettingsThatDependOnTheMachine() {
    const FidelityRegistry registry = measuredSettings();
    const auto entries = machineDependent(registry);
    QCOMPARE(entries.front()->setting.id, std::string("servo.rate"));
    for (const FidelityRegistry::Entry& entry : registry.entries()) {
      const std::string& unit = entry.setting.cost.unit;
      const std::string& id = entry.setting.id;
      const std::set<std::string> free{"turn.method",         "turn.resolution", "turn.step",     "turn.force_model",
                                       "plan.resolution",     "plan.shortcuts",  "verify.step",   "ik.tolerance",
                                       "proximity.tolerance", "volume.voxels",   "volume.method", "volume.reduction",
                                       "volume.polygons",     "volume.pieces",   "drill.erosion"};
      const bool isFree = free.count(id) > 0;
      const bool isTime = (unit == "us" || unit == "us/s" || unit == "ms") && !isFree;
      QCOMPARE(std::count(entries.begin(), entries.end(), &entry), isTime ? 1 : 0);
    }
  }
};

HANDWHEEL_TEST(CalibrationTest)
#include "CalibrationTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "document/AtomicFile.h"
#include "haptics/scene/TouchFidelity.h"
#include "window/fidelity/BenchmarkRunner.h"
#include "window/fidelity/FidelityChoice.h"

#include <QComboBox>
#include <QDockWidget>
#include <QProgressBar>
#include <QPushButton>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Returns curves for a machine that takes twice as long as the one from which the presets were derived.
Calibration slowMachine() {
  const FidelityChoice shipped;
  Calibration calibration;
  calibration.machine = machineClass();
  for (const auto* entry : machineDependent(shipped.registry())) {
    CurveFile curve = shipped.measurement(entry->setting.id);
    for (FidelityRow& row : curve.rows) row.cost *= 2.0;
    calibration.curves[entry->setting.id] = curve;
  }
  return calibration;
}

// The objects that the calibrator needs, without a window.
struct Fixture {
  QThreadPool pool;
  FidelityChoice choice;
  BenchmarkRunner calibrator;

  Fixture() : calibrator(choice, pool, defaultCalibrationFile()) {}
  ~Fixture() {
    calibrator.cancel();
    pool.waitForDone();
  }
};

}  // namespace

// The curves of this machine: measured, kept, and what follows from them.
class CalibrationWindowTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_cache;

  static void keep(const std::string& bytes) {
    std::filesystem::create_directories(defaultCalibrationFile().parent_path());
    QVERIFY(writeFileAtomically(defaultCalibrationFile(), bytes));
  }
  static void raisePanel(WindowDriver& driver) {
    auto* dock = driver.find<QDockWidget>("fidelityDock");
    dock->show();
    dock->raise();
    QTRY_VERIFY(!dock->visibleRegion().isEmpty());
  }

 private slots:
  void initTestCase() { qputenv("XDG_CACHE_HOME", m_cache.path().toLocal8Bit()); }
  void init() {
    QSettings().remove("fidelity");
    std::filesystem::remove(defaultCalibrationFile());
  }

  // Once one setting is measured, its curve holds and is kept; if cancelled, the others are unchanged.
  void measuredUntilItIsCancelled() {
    {
      WindowDriver driver;
      raisePanel(driver);
      auto& choice = *driver.window().findChild<FidelityChoice*>();
      QVERIFY(driver.text("calibrationText").contains("supplied with the program"));
      driver.click("calibrateButton");
      QVERIFY(driver.find<QProgressBar>("calibrationProgress")->isVisible());
      QVERIFY(driver.text("calibrationText").contains("Rate of the servo loop"));
      QTRY_VERIFY_WITH_TIMEOUT(choice.calibration().curves.contains("servo.rate"), 3 * kPatienceMs);
      QCOMPARE(choice.calibration().ticksInUse.size(), std::size_t(5));  // 500 Hz to 8 kHz
      // If that alone took kLongestCalibration, nothing is measured any more, and it begins anew.
      if (!driver.window().findChild<BenchmarkRunner*>()->isRunning()) driver.click("calibrateButton");
      QVERIFY(driver.find<QProgressBar>("calibrationProgress")->isVisible());
      driver.click("calibrateButton");
      QVERIFY(!driver.find<QProgressBar>("calibrationProgress")->isVisible());
      QCOMPARE(driver.find<QPushButton>("calibrateButton")->text(), QString("Measure this machine"));
      QVERIFY(driver.text("calibrationText").contains("measured on this machine"));
    }
    Fixture fixture;
    QVERIFY(fixture.choice.calibration().curves.contains("servo.rate"));
    QVERIFY(!fixture.choice.calibration().curves.contains("mesh.piece_edges"));
  }

  void itIsACommandToo() {
    WindowDriver driver;
    driver.choose("calibrate");
    auto& calibrator = *driver.window().findChild<BenchmarkRunner*>();
    QVERIFY(calibrator.isRunning());
    calibrator.cancel();
    QVERIFY(!calibrator.isRunning());
  }

  void whatWasKeptHolds() {
    keep(jsonOf(FidelityChoice().registry(), slowMachine()));
    const FidelityChoice shipped;
    Fixture fixture;
    QVERIFY(fixture.calibrator.problem().isEmpty());
    for (const auto* entry : machineDependent(shipped.registry())) {
      const double value = entry->setting.standard;
      const auto here = fixture.choice.predicted(entry->setting.id, value),
                 there = shipped.predicted(entry->setting.id, value);
      QCOMPARE(here->cost, 2.0 * there->cost);
      QCOMPARE(here->error, there->error);
    }
    QCOMPARE(*fixture.choice.predictedTick(1000.0), 2.0 * *shipped.predictedTick(1000.0));
  }

  // Between two rates on the line through both, where the scales are logarithmic; beyond, as at the end.
  void aTickInUse() {
    Fixture fixture;
    Calibration calibration = slowMachine();
    calibration.ticksInUse = {{1000.0, 8.0}, {4000.0, 2.0}};
    fixture.choice.setCalibration(calibration);
    for (const auto& [rate, tick] :
         {std::pair(500.0, 8.0), {1000.0, 8.0}, {2000.0, 4.0}, {4000.0, 2.0}, {8000.0, 2.0}}) {
      QVERIFY(std::abs(*fixture.choice.predictedTick(rate) - tick) < 1e-9);
    }
  }

  void whatCannotBeUsedIsIgnoredWithASentence() {
    Calibration other = slowMachine();
    other.machine = "Abacus, 1 cores";
    const std::string good = jsonOf(FidelityChoice().registry(), slowMachine());
    for (const auto& [bytes, words] :
         {std::pair(std::string("{"), "cannot be used"), std::pair(good.substr(0, good.size() / 2), "cannot be used"),
          std::pair(std::string("{\"version\": 7}"), "version 7"),
          std::pair(jsonOf(FidelityChoice().registry(), other), "another machine (Abacus, 1 cores)")}) {
      keep(bytes);
      Fixture fixture;
      QVERIFY2(fixture.calibrator.problem().contains(QLatin1String(words)), qPrintable(fixture.calibrator.problem()));
      QVERIFY(fixture.choice.calibration().curves.empty());
    }
    WindowDriver driver;
    QVERIFY(driver.text("calibrationText").contains("another machine"));
  }

  // A run that begins by itself stops when the user does something, and waits anew; it does not begin if all settings
  // are known.
  void itBeginsByItselfAndStops() {
    Fixture fixture;
    bool isBusy = true;
    fixture.calibrator.beginWhenIdle([&] { return isBusy; }, 20);
    QTest::qWait(100);
    QVERIFY(!fixture.calibrator.isRunning());
    isBusy = false;
    QTRY_VERIFY(fixture.calibrator.isRunning());
    QWidget widget;
    QTest::keyClick(&widget, Qt::Key_A);
    QVERIFY(!fixture.calibrator.isRunning());
    QTRY_VERIFY(fixture.calibrator.isRunning());
    isBusy = true;
    QTRY_VERIFY(!fixture.calibrator.isRunning());
    fixture.calibrator.start();
    QVERIFY(fixture.calibrator.isRunning());
    QTest::keyClick(&widget, Qt::Key_A);
    QVERIFY(fixture.calibrator.isRunning());  // the user has asked for it
  }

  void itDoesNotBeginWhereAllIsKnown() {
    keep(jsonOf(FidelityChoice().registry(), slowMachine()));
    Fixture fixture;
    fixture.calibrator.beginWhenIdle([] { return false; }, 1);
    QVERIFY(!fixture.calibrator.isWaiting());
    QTest::qWait(50);
    QVERIFY(!fixture.calibrator.isRunning());
  }

  void fitIsChosenAndSaysWhy() {
    {
      WindowDriver driver;
      raisePanel(driver);
      auto& choice = *driver.window().findChild<FidelityChoice*>();
      auto* box = driver.find<QWidget>("property/preset")->findChild<QComboBox*>();
      auto* words = driver.find<QLabel>("fidelityFit");
      QVERIFY(!words->isVisible());
      box->setCurrentIndex(box->findText("Fit"));
      emit box->activated(box->currentIndex());
      QCOMPARE(box->currentText(), QString("Fit"));
      QVERIFY(choice.values() == choice.fit().values);
      QVERIFY(words->isVisible() && words->text().contains("a third of the limit unused"));
      for (const FitShare& share : choice.fit().shares) {
        const bool isOver = std::any_of(choice.fit().settings.begin(), choice.fit().settings.end(),
                                        [&](const auto& s) { return s.isOver && s.setting.budget == share.budget; });
        QVERIFY(isOver || share.used <= kBudgetShare * share.limit * (1.0 + 1e-12));
      }
      driver.edit("nurbs.chord_mm", "0.125");
      QCOMPARE(box->currentText(), QString("Custom"));
      QVERIFY(!words->isVisible());
      choice.use(choice.fit().values);
    }
    WindowDriver next;  // and in the next session
    QCOMPARE(next.find<QWidget>("property/preset")->findChild<QComboBox*>()->currentText(), QString("Fit"));
  }
};

HANDWHEEL_WINDOW_TEST(CalibrationWindowTest)
#include "CalibrationWindowTest.moc"

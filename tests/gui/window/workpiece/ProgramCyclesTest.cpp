// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowDriver.h"
#include "../WindowTestMain.h"
#include "controls/NumberField.h"
#include "controls/program/ProgramEditor.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/target/TargetEdit.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/workpiece/program/ProgramSession.h"

#include <QDialog>
#include <QFileDialog>
#include <QFileInfo>
#include <QToolButton>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// Programs that are written for a target: the dialog, and the messages about them.
class ProgramCyclesTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  // A bowl of 14 mm with a round bottom, for which there is no drill: written, with a warning of the remaining
  // material. Its file is offered the name of the document.
  void aBowlThatIsLeftIsReported() {
    WindowDriver driver;
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    driver.choose("programDockToggle");
    QVERIFY(driver.settle());
    Document& document = driver.window().findChild<DocumentTabs*>()->current()->document;
    const StockCylinder stock = static_cast<WorkpieceDocument&>(document).workpiece().stock;
    const double upper = stock.position + stock.length;
    const auto round = arcThrough({14.0, upper - 10.0}, {14.0 * std::sqrt(0.5), upper - 10.0 - 14.0 * std::sqrt(0.5)},
                                  {0.0, upper - 24.0});
    QVERIFY(bool(round));
    const auto profile = TargetProfile::make({{{0.0, upper - 50.0}, {22.0, upper - 50.0}},
                                              {{22.0, upper - 50.0}, {22.0, upper}},
                                              {{22.0, upper}, {14.0, upper}},
                                              {{14.0, upper}, {14.0, upper - 10.0}},
                                              *round});
    QVERIFY(bool(profile));
    auto target = std::make_shared<const WorkpieceTarget>(WorkpieceTarget{*profile, "bowl"});
    document.commit(QStringLiteral("Import target"), std::make_unique<TargetEdit>(target));
    QVERIFY(driver.settle());
    driver.find<QToolButton>("programMake")->actions().back()->trigger();
    driver.click("numbersAccept");
    QVERIFY(driver.settle());
    QVERIFY(driver.find<ProgramEditor>("programEditor")->toPlainText().contains("G96"));
    const QString text = driver.text("messageText");
    QVERIFY2(text.contains("leaves material") && text.contains("14.0 mm") && text.contains("neither flat nor the cone"),
             qPrintable(text));
    driver.window().findChild<ProgramSession*>()->save({});
    const auto named = [&driver] {
      const auto* dialog = driver.window().findChild<QFileDialog*>("saveProgramDialog");
      return dialog ? QFileInfo(dialog->selectedFiles().value(0)).fileName() : QString();
    };
    QTRY_COMPARE(named(), document.name() + QStringLiteral(".ngc"));
    driver.window().findChild<QFileDialog*>("saveProgramDialog")->reject();
  }

  // The turning tool of the wine glass has a nose of 0.8 mm.
  void theNoseIsThatOfTheExercise() {
    WindowDriver driver;
    driver.choose("exercise/wine-glass");
    QVERIFY(driver.settle());
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    driver.choose("programDockToggle");
    QVERIFY(driver.settle());
    driver.find<QToolButton>("programMake")->actions().back()->trigger();
    QTRY_VERIFY(driver.window().findChild<NumberField*>("cyclesNose"));
    QCOMPARE(driver.find<NumberField>("cyclesNose")->value(), 0.8);
    driver.window().findChild<QDialog*>("cyclesDialog")->reject();
  }
};

HANDWHEEL_WINDOW_TEST(ProgramCyclesTest)
#include "ProgramCyclesTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProgramWindow.h"

#include "../WindowTestMain.h"

#include <QComboBox>

using namespace handwheel;
using namespace handwheel::test;

// The settings of the control in the panel of programs.
class ProgramControlTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  // The new bar is 50 mm thick and 100 mm long. 40 mm of it become 40 mm thick, or 30 mm if the block with /2 is run.
  void readsAsTheControlIsSet() {
    ProgramWindow window;
    QVERIFY(window.begin());
    auto* const dialect = window.driver.find<QComboBox>("programDialect");
    auto* const increments = window.driver.find<QAction>("programIncrements");
    auto* const second = window.driver.find<QAction>("programSkip2");
    QVERIFY(!increments->isEnabled() && !second->isEnabled());
    QVERIFY(window.driver.find<QAction>("programSkip1")->isEnabled());
    dialect->setCurrentIndex(1);
    emit dialect->activated(1);
    QVERIFY(increments->isEnabled() && second->isEnabled());
    const char* const text = "G21 G99\nT0101\nG97 S800 M3\nG0 X54000 Z2000\nG90 X40000 Z-40000 F0.2\n/2 X30000\nM30\n";
    increments->trigger();
    second->trigger();
    QVERIFY(window.run(text));
    window.driver.click("programCut");
    QVERIFY(window.driver.settle());
    const auto removed = [&] {
      const WorkpieceSnapshot& work = window.document().workpiece();
      return work.part ? work.stock.volume() - work.part->profile.volume() : 0.0;
    };
    const double expected = M_PI * (625.0 - 400.0) * 40.0;
    QVERIFY2(std::abs(removed() / expected - 1.0) < 1e-3, qPrintable(QString::number(removed())));
    second->trigger();
    window.driver.click("programRun");
    QVERIFY(window.driver.settle());
    window.driver.click("programCut");
    QVERIFY(window.driver.settle());
    const double more = M_PI * (625.0 - 225.0) * 40.0;
    QVERIFY2(std::abs(removed() / more - 1.0) < 1e-3, qPrintable(QString::number(removed())));
  }
};

HANDWHEEL_WINDOW_TEST(ProgramControlTest)
#include "ProgramControlTest.moc"

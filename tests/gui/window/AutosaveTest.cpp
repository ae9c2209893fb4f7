// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "document/RecoveryLeftovers.h"
#include "window/FileActions.h"

#include <QPushButton>
#include <QStandardPaths>

using namespace handwheel;
using namespace handwheel::test;

// What was not saved when the program ended without asking comes back at the next start.
class AutosaveTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    QDir(QString::fromStdString(recoveryFolder().string())).removeRecursively();
    QSettings().setValue("autosaveSeconds", 5);
  }

  void anUnsavedWorkpieceIsOfferedAndRecovered() {
    QString wanted;
    {
      WindowDriver driver;
      driver.choose("newWorkpiece");
      QVERIFY(driver.settle());
      driver.edit("diameter", "33");
      wanted = driver.text("figures");
      const auto stored = [] {
        const QString root = QString::fromStdString(recoveryFolder().string());
        for (const QString& session : QDir(root).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
          if (!QDir(root + "/" + session).entryList({"*.handwheel"}).isEmpty()) return true;
        }
        return false;
      };
      QVERIFY(QTest::qWaitFor(stored, 30000));
    }  // the window goes without asking, as in a crash: nothing was saved
    WindowDriver second;
    QCOMPARE(second.tabs(), 0);
    second.window().offerLeftovers();
    second.click("messageAction");
    QVERIFY(QTest::qWaitFor([&] { return second.tabs() == 1; }, kPatienceMs));
    QVERIFY(second.settle());
    QCOMPARE(second.text("figures"), wanted);
    QVERIFY(second.window().isWindowModified());
  }
};

HANDWHEEL_WINDOW_TEST(AutosaveTest)
#include "AutosaveTest.moc"

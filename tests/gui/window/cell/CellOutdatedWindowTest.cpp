// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "PlanningWindow.h"

#include <QFileDialog>
#include <QTemporaryDir>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// Paths that do not lead to what they were planned for any more.
class CellOutdatedWindowTest : public QObject {
  Q_OBJECT

 private slots:
  // A target is moved by 10 mm: the path to it misses it, until that is undone or the path is planned again. Who
  // exports it is asked before; a program that is written all the same says it.
  void aTargetMoves() {
    PlanningWindow driver;
    const auto number = [&](const char* field) { return driver.field(field).split(' ').front().toDouble(); };
    driver.edit("joint.joint_2", "20");
    driver.edit("joint.joint_3", "30");
    driver.edit("joint.joint_5", "40");
    driver.choose("storeTarget");
    driver.tree()->setCurrentItem(driver.configurations());
    driver.storeAt("joint.joint_1", "60");
    QVERIFY(driver.settle());
    driver.planPath();  // from the configuration to the target
    const auto remark = [&] {
      return driver.paths()->childCount() > 0 ? driver.paths()->child(0)->text(1) : QString();
    };
    QTRY_VERIFY_WITH_TIMEOUT(remark().contains("free"), kPatienceMs);

    driver.tree()->setCurrentItem(driver.tree()->topLevelItem(2)->child(0));
    const double z = number("target.Target 1.z");
    driver.edit("target.Target 1.z", QString::number(z - 10.0));
    driver.clickItem(driver.paths()->child(0));
    QTRY_VERIFY_WITH_TIMEOUT(remark().contains("plan again") && remark().contains("Target 1"), kPatienceMs);
    driver.click("quickActions/undo");
    QTRY_VERIFY_WITH_TIMEOUT(remark().contains("free"), kPatienceMs);
    driver.click("quickActions/redo");
    QTRY_VERIFY_WITH_TIMEOUT(remark().contains("plan again"), kPatienceMs);

    const auto dialog = [&] { return driver.window().findChild<QFileDialog*>(QStringLiteral("exportProgramDialog")); };
    driver.choose("exportProgram");
    QVERIFY(!dialog());
    QVERIFY(driver.text("messageText").contains("outdated") && driver.text("messageText").contains("Target 1"));
    driver.click("messageOther");  // Written unchanged
    const QTemporaryDir folder;
    QVERIFY(driver.enterFileName("exportProgramDialog", folder.filePath("way.mod")));
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("way.mod was written"), kPatienceMs);
    QFile written(folder.filePath("way.mod"));
    QVERIFY(written.open(QIODevice::ReadOnly));
    QVERIFY(written.readAll().contains("! Outdated: the tool does not come to the target"));

    QTRY_VERIFY(!dialog());
    driver.choose("exportProgram");
    driver.click("messageAction");  // planned again
    QTRY_VERIFY_WITH_TIMEOUT(remark().contains("free"), kPatienceMs);
    auto* const path = driver.paths()->child(0);
    driver.tree()->setCurrentItem(path->child(path->childCount() - 1));
    driver.choose("goToConfiguration");
    driver.tree()->setCurrentItem(driver.configurations());
    QVERIFY(std::abs(number("tool.z") - (z - 10.0)) < 1e-2);
  }

  // A stored configuration is set to the present joint values: the path through it is outdated, until that is undone.
  // If it is renamed, its waypoint has the new name; if it is removed, the path that keeps its joint values is named.
  void aConfigurationIsSetHere() {
    PlanningWindow driver;
    driver.storeAt("joint.joint_1", "60");
    driver.storeAt("joint.joint_1", "-60");
    QVERIFY(driver.settle());
    driver.planPath();
    const auto remark = [&] {
      return driver.paths()->childCount() > 0 ? driver.paths()->child(0)->text(1) : QString();
    };
    QTRY_VERIFY_WITH_TIMEOUT(remark().contains("free"), kPatienceMs);
    const QString name = driver.configurations()->child(0)->text(0);
    driver.tree()->setCurrentItem(driver.configurations());
    driver.edit("joint.joint_1", "50");
    driver.tree()->setCurrentItem(driver.configurations()->child(0));
    driver.choose("setPlaceHere");
    driver.clickItem(driver.paths()->child(0));
    QTRY_VERIFY_WITH_TIMEOUT(remark().contains("plan again") && remark().contains(name), kPatienceMs);
    driver.click("quickActions/undo");
    QTRY_VERIFY_WITH_TIMEOUT(remark().contains("free"), kPatienceMs);

    driver.configurations()->child(0)->setText(0, "home");
    QTRY_VERIFY(driver.paths()->child(0)->child(0)->text(0).contains("home"));
    QTRY_VERIFY_WITH_TIMEOUT(!remark().contains("plan again"), kPatienceMs);
    driver.tree()->setCurrentItem(driver.configurations()->child(0));
    const QString path = driver.paths()->child(0)->text(0);
    driver.choose("removePlan");
    QTRY_VERIFY(driver.text("messageText").contains("home was removed"));
    QVERIFY(driver.text("messageText").contains(path));
  }
};

HANDWHEEL_WINDOW_TEST(CellOutdatedWindowTest)
#include "CellOutdatedWindowTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"

#include <QDockWidget>
#include <QMessageBox>
#include <algorithm>

using namespace handwheel;
using namespace handwheel::test;

// Volumes in the window: made of a mesh, saved, opened again, made a mesh.
class VolumeWindowTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  static bool isEnabled(WindowDriver& driver, const char* name) {
    return driver.window().findChild<QAction*>(QString::fromLatin1(name))->isEnabled();
  }

 private slots:
  void meshToVolumeAndBack() {
    WindowDriver driver;
    QVERIFY(!isEnabled(driver, "copyAs/volume") && !isEnabled(driver, "copyAs/mesh"));
    const QString path = m_folder.filePath(QStringLiteral("hole.stl"));
    writeStl(path, torusWithHole());
    QVERIFY(driver.open(path));
    QVERIFY(isEnabled(driver, "copyAs/volume") && !isEnabled(driver, "copyAs/mesh"));
    driver.choose("copyAs/volume");
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 2);
    QVERIFY(!isEnabled(driver, "copyAs/volume") && isEnabled(driver, "copyAs/mesh"));
    QCOMPARE(driver.find<QDockWidget>("kindDock")->windowTitle(), QStringLiteral("Volume"));
    const auto rows = driver.window().findChildren<QWidget*>(QStringLiteral("property/material"));
    QVERIFY(std::any_of(rows.begin(), rows.end(), [](const QWidget* row) { return row->isVisible(); }));
    // It is in no file yet: closing it asks.
    driver.choose("closeDocument");
    QVERIFY(QTest::qWaitFor([&] { return driver.window().findChild<QMessageBox*>() != nullptr; }, kPatienceMs));
    driver.window().findChild<QMessageBox*>()->reject();
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 2);

    driver.choose("saveFileAs");
    const QString saved = m_folder.filePath(QStringLiteral("hole.handwheel"));
    QVERIFY(driver.enterFileName("saveDialog", saved));
    QVERIFY(driver.settle());
    QVERIFY(QFile::exists(saved));

    driver.choose("copyAs/mesh");
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 3);
    QCOMPARE(driver.count(DefectKind::Hole), 0);
    QVERIFY(driver.open(saved));
    QCOMPARE(driver.find<QDockWidget>("kindDock")->windowTitle(), QStringLiteral("Volume"));
  }

  // A sheet has no inside: it says so, and nothing is opened.
  void whatHasNoInside() {
    WindowDriver driver;
    const QString path = m_folder.filePath(QStringLiteral("flat.stl"));
    writeStl(path, {Corners{Corner{0, 0, 0}, Corner{10, 0, 0}, Corner{0, 10, 0}}});
    QVERIFY(driver.open(path));
    driver.choose("copyAs/volume");
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 1);
  }
};

HANDWHEEL_WINDOW_TEST(VolumeWindowTest)
#include "VolumeWindowTest.moc"

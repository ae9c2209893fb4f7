// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../StlFiles.h"
#include "../WindowDriver.h"
#include "../WindowTestMain.h"
#include "MeshShapes.h"
#include "document/volume/VolumeDocument.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/tools/ToolHost.h"

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTabBar>
#include <algorithm>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// Volumes in the window: made of a mesh, saved, opened again, made a mesh.
class VolumeWindowTest : public QObject {
  Q_OBJECT

 private:
  static constexpr double kRadius = 20.0;  // mm
  QTemporaryDir m_folder;

  static bool isEnabled(WindowDriver& driver, const char* name) {
    return driver.window().findChild<QAction*>(QString::fromLatin1(name))->isEnabled();
  }
  // Accepts the proposal of the dialog.
  static void copyAsVolume(WindowDriver& driver) {
    driver.choose("copyAs/volume");
    QVERIFY(driver.settle());
    driver.find<QPushButton>("propertiesAccept")->click();
  }

  // The ball that new clay is, of coarser voxels: a change of all of it takes seconds instead of minutes with
  // sanitizers.
  void openBall(WindowDriver& driver) {
    const TriangleSoup soup = icosphere(5);
    std::vector<Corners> triangles;
    for (const Triangle& each : soup.triangles) {
      Corners& corners = triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k)
        Eigen::Map<Eigen::Vector3f>(corners[k].data()) = (kRadius * soup.points[each[k]]).cast<float>();
    }
    const QString path = m_folder.filePath(QStringLiteral("ball.stl"));
    writeStl(path, triangles);
    QVERIFY(driver.open(path));
    driver.choose("copyAs/volume");
    QVERIFY(driver.settle());
    // Return takes the number only where the field has the focus; elsewhere it makes the volume.
    QVERIFY(QTest::qWaitForWindowActive(driver.find<QDialog>("voxelizeDialog"), kPatienceMs));
    driver.edit("voxel", QStringLiteral("1"));
    driver.find<QPushButton>("propertiesAccept")->click();
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 2);
  }

 private slots:
  void meshToVolumeAndBack() {
    WindowDriver driver;
    QVERIFY(!isEnabled(driver, "copyAs/volume") && !isEnabled(driver, "copyAs/mesh"));
    const QString path = m_folder.filePath(QStringLiteral("hole.stl"));
    writeStl(path, torusWithHole());
    QVERIFY(driver.open(path));
    QVERIFY(isEnabled(driver, "copyAs/volume") && !isEnabled(driver, "copyAs/mesh"));
    copyAsVolume(driver);
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

  // The dialog says what the voxels take while their size is typed; what needs more than a quarter of the memory is
  // asked once more. Whoever declines gets nothing, and the next dialog proposes what the first did.
  void askedBeforeItIsMade() {
    WindowDriver driver;
    const QString path = m_folder.filePath(QStringLiteral("asked.stl"));
    writeStl(path, torusWithHole());
    QVERIFY(driver.open(path));
    const auto text = [&](const char* id) {
      const QWidget* const row = driver.find<QDialog>("voxelizeDialog")->findChild<QWidget*>(QString("property/") + id);
      QStringList all;
      for (const QLabel* const label : row->findChildren<QLabel*>()) all << label->text();
      return all.join(QLatin1Char('|'));
    };
    driver.choose("copyAs/volume");
    QVERIFY(driver.settle());
    const QString memory = text("memory"), seconds = text("seconds"), reason = text("reason");
    QVERIFY2(memory.contains("MB") && seconds.contains(" s") && reason.contains("256 to the largest extent"),
             qPrintable(memory + reason));
    auto* const line =
        driver.find<QDialog>("voxelizeDialog")->findChild<QWidget*>("property/voxel")->findChild<QLineEdit*>();
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, QStringLiteral("0.00001"));  // not entered
    QVERIFY(text("memory") != memory && text("seconds") != seconds && text("reason") != reason);
    QCOMPARE(line->text().toDouble(), 1e-5);
    driver.find<QPushButton>("propertiesAccept")->click();
    QTRY_VERIFY(driver.window().findChild<QMessageBox*>(QStringLiteral("memoryQuestion")));
    driver.window().findChild<QMessageBox*>(QStringLiteral("memoryQuestion"))->reject();
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 1);
    QTRY_VERIFY(!driver.window().findChild<QDialog*>(QStringLiteral("voxelizeDialog")));
    driver.choose("copyAs/volume");
    QVERIFY(driver.settle());
    QCOMPARE(text("reason"), reason);
    driver.find<QDialog>("voxelizeDialog")->reject();
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 1);
  }

  // A plane of symmetry is of the part: it stays there, and is in no other document. How strong a stroke is, is of the
  // hand.
  void mirrorOfADocument() {
    WindowDriver driver;
    const auto beginClay = [&] {
      driver.choose("newVolume");
      QVERIFY(driver.settle());
      driver.find<QAction>("clayTool")->trigger();
    };
    auto* const host = driver.window().findChild<ToolHost*>();
    const auto setting = [&](const char* id) {
      const Tool* const tool = host->runner().tool();
      for (const Property& each : tool ? tool->settings() : std::vector<Property>())
        if (each.id == id) return each.value;
      return PropertyValue(-1.0);
    };
    beginClay();
    host->choose("clay", "mirror_x", PropertyValue(true));
    host->choose("clay", "strength", PropertyValue(0.3));
    QVERIFY(setting("mirror_x") == PropertyValue(true));
    beginClay();
    QVERIFY(setting("mirror_x") == PropertyValue(false));
    QVERIFY(setting("strength") == PropertyValue(0.3));
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QVERIFY(driver.settle());
    QVERIFY(setting("mirror_x") == PropertyValue(true));
  }

  // The whole volume is changed from the menu: shown first, applied by a key, undone; nothing of it is there before.
  void changedAsAWhole() {
    WindowDriver driver;
    QVERIFY(!isEnabled(driver, "volumeShell"));
    openBall(driver);
    const auto material = [&] {
      const Document& shown = driver.window().findChild<DocumentTabs*>()->current()->document;
      return static_cast<const VolumeDocument&>(shown).volume()->volume.material();
    };
    const auto ball = [](double radius) { return 4.0 / 3.0 * M_PI * radius * radius * radius; };
    const auto isNear = [](double value, double expected) { return std::abs(value / expected - 1.0) < 0.02; };
    QVERIFY(isNear(material(), ball(kRadius)));
    driver.choose("volumeShell");
    driver.edit("wall", QStringLiteral("3"));
    QVERIFY(driver.settle());
    QVERIFY(isNear(material(), ball(kRadius)));
    auto* const view = driver.find<Viewport>("viewport");
    view->setFocus();
    QTest::keyClick(view, Qt::Key_Return);
    QVERIFY(driver.settle());
    QVERIFY(isNear(material(), ball(kRadius) - ball(kRadius - 3.0)));
    driver.find<QAction>("undo")->trigger();
    QVERIFY(driver.settle());
    QVERIFY(isNear(material(), ball(kRadius)));
    // Another entry changes what the tool does; before it is made, Return waits for it.
    driver.choose("volumeOffset");
    driver.edit("distance", QStringLiteral("-5"));
    QTest::keyClick(view, Qt::Key_Return);
    QVERIFY(driver.settle());
    QVERIFY(isNear(material(), ball(kRadius - 5.0)));
  }

  // With another document, chosen by its name.
  void combinedWithADocument() {
    WindowDriver driver;
    const QString path = m_folder.filePath(QStringLiteral("ring.stl"));
    writeStl(path, torusWithHole());
    QVERIFY(driver.open(path));
    copyAsVolume(driver);
    QVERIFY(driver.settle());
    const DocumentTab* const ring = driver.window().findChild<DocumentTabs*>()->current();
    QCOMPARE(ring->document.name(), QStringLiteral("ring"));
    const auto material = [&] {
      return static_cast<const VolumeDocument&>(ring->document).volume()->volume.material();
    };
    const double before = material();
    // The intersection is the same ring.
    driver.choose("volumeBoolean");
    emit driver.find<QWidget>("property/how")->findChild<QComboBox*>()->activated(2);
    QVERIFY(driver.settle());
    auto* const view = driver.find<Viewport>("viewport");
    view->setFocus();
    QTest::keyClick(view, Qt::Key_Return);
    QVERIFY(driver.settle());
    QVERIFY(std::abs(material() / before - 1.0) < 0.02);
    QCOMPARE(ring->document.history()->index(), 1);
  }

  // The dialog predicts a number of triangles, and the mesh is a document that is called as the volume.
  void madeAMesh() {
    WindowDriver driver;
    openBall(driver);
    driver.choose("saveFileAs");
    QVERIFY(driver.enterFileName("saveDialog", m_folder.filePath(QStringLiteral("clay ball.handwheel"))));
    QVERIFY(driver.settle());
    driver.choose("volumeRemesh");
    auto* const dialog = driver.find<QDialog>("remeshDialog");
    QTRY_VERIFY(dialog->isVisible());
    QVERIFY(driver.settle());
    driver.find<QPushButton>("propertiesAccept")->click();
    QTRY_COMPARE_WITH_TIMEOUT(driver.tabs(), 3, kPatienceMs);
    const Document& mesh = driver.window().findChild<DocumentTabs*>()->current()->document;
    QCOMPARE(mesh.kind().id(), std::string("mesh"));
    QCOMPARE(mesh.name(), QStringLiteral("clay ball"));
    QCOMPARE(driver.count(DefectKind::Hole), 0);
    // It is in no file, though the volume is in one.
    QVERIFY(mesh.isModified());
    QVERIFY(driver.window().isWindowModified());
    QVERIFY(mesh.path().isEmpty());
  }

  // A sheet has no inside: it says so, and nothing is opened.
  void whatHasNoInside() {
    WindowDriver driver;
    const QString path = m_folder.filePath(QStringLiteral("flat.stl"));
    writeStl(path, {Corners{Corner{0, 0, 0}, Corner{10, 0, 0}, Corner{0, 10, 0}}});
    QVERIFY(driver.open(path));
    copyAsVolume(driver);
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 1);
  }
};

HANDWHEEL_WINDOW_TEST(VolumeWindowTest)
#include "VolumeWindowTest.moc"

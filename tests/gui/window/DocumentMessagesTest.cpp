// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"

#include <QComboBox>

using namespace handwheel;
using namespace handwheel::test;

// Messages about a document are shown while that document is in view.
class DocumentMessagesTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  // A triangle with a texture coordinate, which is not kept.
  QString texturedFile() {
    const QString path = m_folder.filePath("textured.obj");
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) qFatal("no room for test files");
    file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n");
    return path;
  }
  static bool isSeen(WindowDriver& driver) { return driver.find<QWidget>("messageBar")->isVisible(); }

 private slots:
  void endWithTheirDocument() {
    WindowDriver driver;
    QVERIFY(driver.open(texturedFile()));
    QTRY_VERIFY(isSeen(driver));
    writeStl(m_folder.filePath("plain.stl"), quadTorus(12, 8, {}));
    QVERIFY(driver.open(m_folder.filePath("plain.stl")));
    QVERIFY(!isSeen(driver));
    auto* tabs = driver.find<QTabBar>("documentTabBar");
    tabs->setCurrentIndex(0);
    QVERIFY(isSeen(driver));
    QVERIFY(driver.text("messageText").contains("textured.obj"));
    driver.find<QAction>("closeDocument")->trigger();
    QTRY_COMPARE(driver.tabs(), 1);
    QVERIFY(!isSeen(driver));
    driver.find<QAction>("closeDocument")->trigger();
    QTRY_COMPARE(driver.tabs(), 0);
    QVERIFY(!isSeen(driver));
  }

  // The robot is sound, but its meshes are elsewhere: the message says which folder to put where.
  void aPackageThatIsMissing() {
    const QString path = m_folder.filePath("r.urdf");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        "<robot name='r'><link name='foot'><visual><geometry><mesh filename='package://elsewhere/a.stl'/>"
        "</geometry></visual></link></robot>");
    file.close();
    WindowDriver driver;
    QVERIFY(driver.open(path));
    QTRY_VERIFY(isSeen(driver));
    const QString said = driver.text("messageText");
    QVERIFY2(said.contains("r.urdf is incomplete") && !said.contains("damaged"), qPrintable(said));
    QVERIFY2(said.contains("'elsewhere'") && said.contains(m_folder.path()), qPrintable(said));
  }

  // It says how large the part would be, and leads to the tool that converts it; then it is over.
  void anUnlikelySizeIsDoubted() {
    WindowDriver driver;
    std::vector<Corners> small = quadTorus(12, 8, {});
    for (Corners& triangle : small) {
      for (Corner& corner : triangle) {
        for (float& x : corner) x /= 1000;  // 80 mm in metres
      }
    }
    writeStl(m_folder.filePath("metres.stl"), small);
    QVERIFY(driver.open(m_folder.filePath("metres.stl")));
    QTRY_VERIFY(isSeen(driver));
    const QString said = driver.text("messageText");
    QVERIFY2(said.contains("metres.stl") && said.contains("0.08 × ") && said.contains("unit"), qPrintable(said));
    driver.click("messageAction");
    QVERIFY(driver.find<QAction>("transformTool")->isChecked());
    auto* unit = driver.find<QWidget>("property/unit")->findChild<QComboBox*>();
    unit->setCurrentIndex(unit->findText("m"));
    emit unit->activated(unit->currentIndex());
    QTRY_VERIFY(driver.find<QAbstractButton>("toolAction/commit")->isEnabled());  // the panel makes them anew
    driver.click("toolAction/commit");
    QTRY_VERIFY_WITH_TIMEOUT(driver.window().isWindowModified(), kPatienceMs);
    QVERIFY(driver.settle());
    QVERIFY(!isSeen(driver));
    driver.choose("undo");
    QVERIFY(!driver.window().isWindowModified());
  }

  // One that is not converted stays doubtful, whatever else is changed, until the message is closed.
  void aDoubtOutlastsOtherChanges() {
    WindowDriver driver;
    std::vector<Corners> small = quadTorus(12, 8, {{1, 1}});
    for (Corners& triangle : small) {
      for (Corner& corner : triangle) {
        for (float& x : corner) x *= 1000;  // 80 m
      }
    }
    writeStl(m_folder.filePath("large.stl"), small);
    QVERIFY(driver.open(m_folder.filePath("large.stl")));
    QTRY_VERIFY(isSeen(driver));
    driver.click("repairAllButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 0, kPatienceMs);
    QVERIFY(driver.settle());
    QVERIFY(isSeen(driver));
    driver.click("messageClose");
    QVERIFY(!isSeen(driver));
  }

  // Messages about the first file end once the document has another.
  void whatWasSaidOfAFileEndsWithSavingAs() {
    WindowDriver driver;
    QVERIFY(driver.open(texturedFile()));
    QTRY_VERIFY(isSeen(driver));
    driver.choose("saveFileAs");
    QVERIFY(driver.enterFileName("saveDialog", m_folder.filePath("plain-copy.stl")));
    QVERIFY(driver.settle());
    QTRY_VERIFY(!isSeen(driver));
  }

  // A file that could not be opened has no document: its message stays until it is closed.
  void ofFilesThatDidNotOpen() {
    WindowDriver driver;
    driver.window().openPaths({m_folder.filePath("missing.stl")});
    QTRY_VERIFY(isSeen(driver));
    driver.choose("openShaftSample");
    QVERIFY(driver.settle());
    QVERIFY(isSeen(driver));
    QVERIFY(driver.text("messageText").contains("missing.stl"));
  }
};

HANDWHEEL_WINDOW_TEST(DocumentMessagesTest)
#include "DocumentMessagesTest.moc"

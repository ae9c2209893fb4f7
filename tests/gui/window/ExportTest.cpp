// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindowDriver.h"
#include "WindowTestMain.h"

#include <QTabBar>

using namespace handwheel;
using namespace handwheel::test;

// A save into a format that cannot hold the document is an export: the document keeps its file and its unsaved changes.
class ExportTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  static QString tab(WindowDriver& driver) { return driver.find<QTabBar>("documentTabBar")->tabText(0); }
  bool saveAs(WindowDriver& driver, const QString& name) {
    driver.choose("saveFileAs");
    return driver.enterFileName("saveDialog", m_folder.filePath(name)) && driver.settle() &&
           QFileInfo(m_folder.filePath(name)).size() > 0;
  }

 private slots:
  // The name follows the type that is chosen, and the columns show sizes and dates whole.
  void theSaveDialogFollowsItsType() {
    WindowDriver driver(kSmallWindow);
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    QFile file(m_folder.filePath("a-file-with-a-long-name-and-a-size.handwheel"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(QByteArray(600000, ' ')) == 600000);
    file.close();
    QSettings().setValue("lastFolder", m_folder.path());
    driver.choose("saveFileAs");
    QTRY_VERIFY(driver.window().findChild<QFileDialog*>("saveDialog"));
    auto* const dialog = driver.find<QFileDialog>("saveDialog");
    QTRY_VERIFY(dialog->isVisible());
    const auto* const name = dialog->findChild<QLineEdit*>("fileNameEdit");
    QVERIFY2(name->text().endsWith(".handwheel"), qPrintable(name->text()));
    const QString stem = name->text().chopped(10);
    for (const char* ending : {".step", ".stl", ".handwheel"}) {
      const QStringList filters = dialog->nameFilters();
      const auto only = std::find_if(filters.begin(), filters.end(), [&](const QString& each) {
        return each.count('*') == 1 && each.contains(QLatin1String(ending));
      });
      const auto found =
          only != filters.end() ? only : std::find_if(filters.begin() + 1, filters.end(), [&](auto& each) {
            return each.contains(QString::fromLatin1("(*%1").arg(ending));
          });
      QVERIFY2(found != filters.end(), ending);
      dialog->selectNameFilter(*found);
      emit dialog->filterSelected(*found);
      QCOMPARE(name->text(), stem + QString::fromLatin1(ending));
    }
    auto* const files = dialog->findChild<QTreeView*>("treeView");
    QTRY_VERIFY(files->model()->rowCount(files->rootIndex()) > 0);
    QTest::qWait(100);
    for (int column = 1; column < 4; ++column)
      QVERIFY2(files->columnWidth(column) >=
                   files->sizeHintForIndex(files->model()->index(0, column, files->rootIndex())).width(),
               qPrintable(QString::number(column)));
    dialog->reject();
  }

  // A bar of 30 mm: its file keeps the number, whatever else is written of it.
  void aWorkpieceKeepsItsFile_data() {
    QTest::addColumn<QString>("ending");
    for (const char* each : {"svg", "dxf", "pdf", "step", "stl", "ply", "obj", "off", "3mf"})
      QTest::newRow(each) << QString::fromLatin1(each);
  }
  void aWorkpieceKeepsItsFile() {
    QFETCH(QString, ending);
    WindowDriver driver(kSmallWindow);
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    driver.edit("diameter", "30");
    QTRY_VERIFY(driver.window().isWindowModified());
    const QString untitled = tab(driver);
    QVERIFY2(saveAs(driver, "bar." + ending), qPrintable(driver.text("messageText")));
    QVERIFY(driver.window().isWindowModified());
    QCOMPARE(tab(driver), untitled);
    QVERIFY2(driver.text("messageText").contains("not saved yet"), qPrintable(driver.text("messageText")));
    // The message offers the file that holds all.
    driver.click("messageAction");
    const QString whole = m_folder.filePath(ending + "-bar.handwheel");
    QVERIFY(driver.enterFileName("saveDialog", whole));
    QVERIFY(driver.settle());
    QVERIFY(!driver.window().isWindowModified());
    // From now on Save writes that one.
    driver.edit("diameter", "31");
    QTRY_VERIFY(driver.window().isWindowModified());
    QVERIFY(saveAs(driver, "again." + ending));
    QVERIFY(driver.window().isWindowModified());
    driver.choose("saveFile");
    QVERIFY(driver.settle());
    QVERIFY(!driver.window().isWindowModified());
    driver.click("closeTab");
    QCOMPARE(driver.tabs(), 0);
    QVERIFY(driver.open(whole));
    QCOMPARE(driver.find<QWidget>("property/diameter")->findChild<QLineEdit*>()->text(), QStringLiteral("31"));
  }

  // Voxels alone are all of a ball of clay: its file may be one of them.
  void aVolumeOfVoxelsLivesInTheirFile() {
    WindowDriver driver(kSmallWindow);
    driver.choose("newVolume");
    QVERIFY(driver.settle());
    QVERIFY(saveAs(driver, "ball.vdb"));
    QVERIFY(!driver.window().isWindowModified());
    QCOMPARE(tab(driver), QStringLiteral("ball.vdb"));
  }
};

HANDWHEEL_WINDOW_TEST(ExportTest)
#include "ExportTest.moc"

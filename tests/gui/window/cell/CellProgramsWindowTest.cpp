// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "CellWindow.h"

#include <QFile>
#include <QFileDialog>
#include <QTemporaryDir>
#include <QTreeWidget>

using namespace handwheel;
using namespace handwheel::test;

namespace {

class ProgramsWindow : public CellWindow {
 public:
  ProgramsWindow() {
    if (!settle() || !m_folder.isValid()) qFatal("the cell is not ready");
  }
  // Opens the text as a program, and waits until its path is verified.
  QString stateOf(const QString& name, const QByteArray& text) {
    QFile file(m_folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) qFatal("no file");
    file.close();
    choose("importProgram");
    if (!enterFileName("importProgramDialog", file.fileName())) qFatal("no dialog");
    if (!QTest::qWaitFor([&] { return paths()->childCount() == 1; }, kPatienceMs)) qFatal("not opened");
    find<QTreeWidget>("planTree")->setCurrentItem(paths()->child(0));
    closeMessages();
    choose("verifyPath");
    if (!settle()) qFatal("not verified");
    return paths()->child(0)->text(1);
  }
  void exportTo(const QString& name) {
    closeMessages();
    choose("exportProgram");
    if (!enterFileName("exportProgramDialog", m_folder.filePath(name))) qFatal("no dialog");
  }
  bool isWritten(const QString& name) {
    return QTest::qWaitFor([&] { return says(name + " was written"); }, kPatienceMs);
  }
  QByteArray read(const QString& name) {
    QFile file(m_folder.filePath(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

 private:
  QTreeWidgetItem* paths() { return find<QTreeWidget>("planTree")->topLevelItem(1); }
  QTemporaryDir m_folder;
};

}  // namespace

// Programs of controllers with lines that are not interpreted, and with roundings of one language.
class CellProgramsWindowTest : public QObject {
  Q_OBJECT

 private slots:
  // A line stays in its language. Another one takes the path without it, if the user says so.
  void linesOfALanguage() {
    ProgramsWindow driver;
    const QByteArray end = ",[9E9,9E9,9E9,9E9,9E9,9E9]]\\NoEOffs,v100,fine,tool0;\n";
    const QString state =
        driver.stateOf("seam.mod", "MODULE seam\nPROC main()\nMoveAbsJ [[0,0,0,0,30,0]" + end +
                                       "WaitDI di1,1;\nMoveAbsJ [[10,0,0,0,30,0]" + end + "ENDPROC\nENDMODULE\n");
    QVERIFY2(state.contains("free"), qPrintable(state));
    driver.exportTo("same.mod");
    QVERIFY(driver.isWritten("same.mod"));
    QVERIFY(driver.read("same.mod").contains("WaitDI di1,1;"));
    driver.exportTo("other.src");
    QTRY_VERIFY_WITH_TIMEOUT(driver.says("WaitDI di1,1"), kPatienceMs);
    QVERIFY(driver.read("other.src").isEmpty());
    driver.click("messageAction");
    QVERIFY(driver.isWritten("other.src"));
    QVERIFY(driver.read("other.src").contains("PTP {"));
    QVERIFY(!driver.read("other.src").contains("WaitDI"));
  }

  // CNT is proven, as nothing is near. KRL has no such rounding: the robot may stop instead.
  void roundingsOfALanguage() {
    ProgramsWindow driver;
    const auto pose = [](int number, const char* first) {
      return "P[" + QByteArray::number(number) + "]{\n GP1:\n UF : 0, UT : 1,\n J1 = " + first +
             " deg, J2 = 0 deg, J3 = 0 deg,\n J4 = 0 deg, J5 = -30 deg, J6 = 0 deg\n};\n";
    };
    const QString state = driver.stateOf("bow.ls",
                                         "/PROG BOW\n/MN\n1:J P[1] 10% FINE ;\n2:J P[2] 10% CNT50 ;\n"
                                         "3:J P[3] 10% FINE ;\n/POS\n" +
                                             pose(1, "0") + pose(2, "5") + pose(3, "10") + "/END\n");
    QVERIFY2(state.contains("free"), qPrintable(state));
    driver.exportTo("bow2.ls");
    QVERIFY(driver.isWritten("bow2.ls"));
    QVERIFY(driver.read("bow2.ls").contains("CNT50"));
    driver.exportTo("bow.src");
    QTRY_VERIFY_WITH_TIMEOUT(driver.says("CNT"), kPatienceMs);
    QVERIFY(driver.read("bow.src").isEmpty());
    driver.click("messageAction");
    QVERIFY(driver.isWritten("bow.src"));
    QVERIFY(!driver.read("bow.src").contains("C_PTP"));
  }
};

HANDWHEEL_WINDOW_TEST(CellProgramsWindowTest)
#include "CellProgramsWindowTest.moc"

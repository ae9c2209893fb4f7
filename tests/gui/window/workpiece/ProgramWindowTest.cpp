// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProgramWindow.h"

#include "../WindowTestMain.h"
#include "controls/program/ProgramEditor.h"
#include "document/workpiece/LatheSetupEdit.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/target/TargetEdit.h"
#include "panels/MessageBar.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/workpiece/program/ProgramPanel.h"
#include "window/workpiece/program/ProgramPlayer.h"
#include "window/workpiece/program/ProgramSession.h"

#include <QComboBox>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <QToolButton>
#include <cmath>
#include <memory>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The new bar of the window is 50 × 100 mm. 40 mm of it become 46 mm thick.
constexpr const char* kTurned =
    "G7 G21 G97 S600 M3\n"
    "G0 X46 Z2\n"
    "G1 Z-40 F240\n"
    "G0 X54\n"
    "G0 Z2\n"
    "M2\n";

}  // namespace

namespace {

double volumeOf(const WorkpieceSnapshot& workpiece) {
  return workpiece.part ? workpiece.part->profile.volume() : workpiece.stock.volume();
}

}  // namespace

// Lathe programs in the window: opened, corrected, run, looked at, cut, written and saved.
class ProgramWindowTest : public QObject {
  Q_OBJECT

  std::unique_ptr<ProgramWindow> m_window;

  // Returns the window of the previous test, cleared.
  ProgramWindow& reused() {
    if (!m_window) return fresh();
    m_window->clear();
    return *m_window;
  }
  ProgramWindow& fresh() {
    m_window.reset();
    m_window = std::make_unique<ProgramWindow>();
    return *m_window;
  }

 private slots:
  void init() { QSettings().clear(); }
  void cleanup() {
    if (QTest::currentTestFailed()) m_window.reset();
  }
  void cleanupTestCase() { m_window.reset(); }

  // A run changes nothing; cutting is one step, which undo takes back.
  void openedRunAndCut() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("turned.ngc");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(kTurned) > 0);
    file.close();
    ProgramWindow& window = reused();
    QVERIFY(window.begin());
    window.driver.click("openProgramButton");
    QVERIFY(window.driver.enterFileName("programDialog", path));
    QVERIFY(window.driver.settle());
    QCOMPARE(window.editor().toPlainText(), QString::fromLatin1(kTurned));
    QCOMPARE(window.driver.text("programName"), QStringLiteral("turned.ngc"));
    QVERIFY(!window.driver.find<QPushButton>("programCut")->isEnabled());
    window.driver.click("programRun");
    QVERIFY(window.driver.settle());
    QVERIFY(!window.document().workpiece().part);
    QCOMPARE(window.document().history()->count(), 0);
    QVERIFY2(window.driver.text("programSummary").contains("No collision"),
             qPrintable(window.driver.text("programSummary")));
    const double before = volumeOf(window.document().workpiece());
    window.driver.click("programCut");
    QVERIFY(window.driver.settle());
    QCOMPARE(window.document().history()->count(), 1);
    const double ring = M_PI * (25.0 * 25.0 - 23.0 * 23.0);  // mm²
    const double spacing = window.document().workpiece().part->profile.spacing();
    const double removed = before - volumeOf(window.document().workpiece());
    QVERIFY2(std::abs(removed - 40.0 * ring) < ring * spacing, qPrintable(QString::number(removed)));
    window.driver.click("quickActions/undo");
    QVERIFY(!window.document().workpiece().part);
    QVERIFY(!window.driver.find<QPushButton>("programCut")->isEnabled());  // it was run on another part
  }

  // A run in progress while the part is turned belongs to an old part: it is dropped.
  void aRunOnAnOlderPart() {
    ProgramWindow& window = reused();
    QVERIFY(window.begin());
    window.write(kTurned);
    window.driver.click("programRun");
    WorkpieceSnapshot turned = window.document().workpiece();
    const double upper = turned.stock.length;
    TurningPass pass;
    pass.noseRadius = 0.8;
    pass.path = {{24.8, upper + 2.0}, {24.8, upper - 60.0}};  // to 48 mm: the program finds material
    pass.times = {0.0, 1.0};
    const auto part = withPasses(turned, {pass}, 0.1);
    window.document().commit(QStringLiteral("by hand"), std::make_unique<TurnedPartEdit>(part));
    QVERIFY(window.driver.settle());
    QVERIFY(!window.session().isSimulated() && !window.driver.find<QPushButton>("programCut")->isEnabled());
    QCOMPARE(window.document().workpiece().part, part);
    window.driver.click("programRun");
    QVERIFY(window.driver.settle());
    window.driver.click("programCut");
    QVERIFY(window.driver.settle());
    QVERIFY(window.document().workpiece().part->passes.size() > 1);  // those by hand stay
  }

  // The name of a file is that of its text: one that was opened while another was saved keeps its own.
  void aProgramThatComesWhileAnotherIsSaved() {
    const QTemporaryDir folder;
    const auto fileWith = [&folder](const char* name, const char* text) {
      QFile file(folder.filePath(QString::fromLatin1(name)));
      if (!file.open(QIODevice::WriteOnly) || file.write(text) <= 0) qFatal("no file");
      return file.fileName();
    };
    const QString first = fileWith("first.ngc", "M2\n"), second = fileWith("second.ngc", kTurned);
    ProgramWindow& window = reused();
    QVERIFY(window.begin());
    window.session().read(first);
    QVERIFY(window.driver.settle());
    window.session().read(second);
    window.session().save({});
    window.driver.finishJobs();  // both are done before the window hears of either
    QVERIFY(window.driver.settle());
    QCOMPARE(window.driver.text("programName"), QStringLiteral("second.ngc"));
    QCOMPARE(window.editor().toPlainText(), QString::fromLatin1(kTurned));
  }

  // The result of a run is marked as such; leaving it shows the part as it is.
  void aRunIsMarkedAsSimulated() {
    ProgramWindow& window = reused();
    QVERIFY(window.begin());
    auto* banner = window.driver.find<QWidget>("simulationBanner");
    QVERIFY(!banner->isVisible());
    QVERIFY(window.run(kTurned));
    QVERIFY(banner->isVisible() && window.session().picture().part);
    auto* bar = window.driver.find<MessageBar>("messageBar");
    bar->showMessage({Message::Weight::Info, "It does not cover the banner.", {}, {}, {}, {}});
    const auto rectangleOf = [](const QWidget* each) { return QRect(each->mapToGlobal(QPoint()), each->size()); };
    QTRY_VERIFY(bar->isVisible() && !rectangleOf(bar).intersects(rectangleOf(banner)));
    window.driver.click("messageClose");
    window.driver.click("simulationLeave");
    QVERIFY(window.driver.settle());
    QVERIFY(!banner->isVisible() && !window.session().picture().part);
    QCOMPARE(window.editor().toPlainText(), QString::fromLatin1(kTurned));
    window.driver.click("programRun");
    QVERIFY(window.driver.settle());
    QVERIFY(banner->isVisible());
    window.driver.choose("programDockToggle");
    QTRY_VERIFY(!banner->isVisible());
    window.driver.choose("programDockToggle");
    QTRY_VERIFY(banner->isVisible());
    window.driver.click("simulationCut");
    QVERIFY(window.driver.settle());
    QVERIFY(!banner->isVisible() && window.document().workpiece().part);
  }

  // The dock opens as wide as its rows need, also with many tools and a long name.
  void itsButtonsAreInView() {
    ProgramWindow& window = fresh();
    window.driver.window().resize(kUsualWindow);
    QVERIFY(window.begin());
    auto* const panel = window.driver.find<ProgramPanel>("programPanel");
    for (const std::size_t tools : {std::size_t{0}, std::size_t{12}}) {
      panel->setToolCount(tools);
      panel->setName(QStringLiteral("a-long-name-of-a-program-for-a-stepped-shaft.ngc"));
      for (const char* const name : {"programTools", "programControl", "programCut", "programPost"}) {
        const auto* const button = window.driver.find<QWidget>(name);
        QTRY_VERIFY2(button->visibleRegion().boundingRect() == button->rect(), name);
      }
    }
    m_window.reset();
  }

  // All errors are listed; a click on one puts the cursor there; nothing runs.
  void errorsAreListedAtTheirPlaces() {
    ProgramWindow& window = reused();
    QVERIFY(window.begin());
    window.write("G21\nG68 X1\nG0 X20 Z2 M77\nM2\n");
    QVERIFY(window.driver.settle());
    QCOMPARE(window.findings().count(), 2);
    QVERIFY(window.findings().item(0)->text().contains("G68"));
    QVERIFY(window.findings().item(1)->text().contains("M77"));
    window.clickFinding(1);
    QCOMPARE(window.editor().textCursor().blockNumber() + 1, 3);
    QCOMPARE(window.editor().textCursor().positionInBlock() + 1, 11);
    window.driver.click("programRun");
    QVERIFY(window.driver.settle());
    QCOMPARE(window.editor().textCursor().blockNumber() + 1, 2);
    QVERIFY(!window.driver.find<QPushButton>("programCut")->isEnabled());
    window.write(kTurned);
    QVERIFY(window.driver.settle());
    QVERIFY(!window.findings().isVisible());
  }

  // Lines are stepped, and the tool and the part are those of the line.
  void steppedLineByLine() {
    ProgramWindow& window = reused();
    QVERIFY(window.begin() && window.run(kTurned));
    const auto tip = [&window] {
      const auto& insert = window.session().picture().tool.back();
      return insert.front();
    };
    const double upper = window.document().workpiece().stock.position + window.document().workpiece().stock.length;
    QCOMPARE(window.editor().currentLine(), 5);
    QVERIFY((tip() - Vec3(27.0, 0.0, upper + 2.0)).norm() < 1e-9);
    window.driver.click("programBack");
    window.driver.click("programBack");
    QVERIFY(window.driver.settle());
    QVERIFY((tip() - Vec3(23.0, 0.0, upper - 40.0)).norm() < 1e-9);  // the end of line 3
    window.driver.click("programBack");
    QVERIFY(window.driver.settle());
    QVERIFY((tip() - Vec3(23.0, 0.0, upper + 2.0)).norm() < 1e-9);
    const auto narrowest = [&window] {
      double least = 1e9;
      for (const DisplayPart& part : window.session().picture().part->parts)
        for (const Vec3& p : part.soup->points) {
          const double r = std::hypot(p.x(), p.y());
          if (r > 1.0) least = std::min(least, r);
        }
      return least;
    };
    QVERIFY(std::abs(narrowest() - 25.0) < 0.1);  // the chord of the circles
    window.driver.click("programStep");
    QVERIFY(window.driver.settle());
    QVERIFY(std::abs(narrowest() - 23.0) < 0.1);
    // The cursor selects the position, too.
    window.editor().goTo(2);
    QVERIFY(window.driver.settle());
    QVERIFY((tip() - Vec3(23.0, 0.0, upper + 2.0)).norm() < 1e-9);
    // Played, it comes to the end by itself.
    auto* speed = window.driver.find<QComboBox>("programSpeed");
    speed->setCurrentIndex(speed->count() - 1);
    window.driver.click("programPlay");
    QTRY_VERIFY_WITH_TIMEOUT(!window.driver.find<ProgramPlayer>("programPlayer")->isPlaying(), kPatienceMs);
    QCOMPARE(window.editor().currentLine(), 5);
    QVERIFY(window.driver.settle());
    // Closed, the dock shows nothing in the view any more.
    window.driver.choose("programDockToggle");
    QVERIFY(!window.editor().isVisible());
    QVERIFY(window.editor().toPlainText().startsWith("G7"));
  }

  void collisionsAreListed() {
    ProgramWindow& window = reused();
    QVERIFY(window.begin() && window.run("G7 G21 S600 M3\nG0 X60 Z2\nG0 X40\nG0 Z-30\nG0 X60\nM2\n"));
    QCOMPARE(window.findings().count(), 1);
    QVERIFY(window.findings().item(0)->text().startsWith("Line 4"));
    window.clickFinding(0);
    QVERIFY(window.driver.settle());
    QCOMPARE(window.editor().currentLine(), 4);
    QCOMPARE(window.editor().textCursor().blockNumber() + 1, 4);
  }

  // The chuck of a new bar of 100 mm holds 20 mm of it. In another chuck the run is another one.
  void theChuckOfTheLathe() {
    ProgramWindow& window = reused();
    QVERIFY(window.begin() && window.run("G7 G21 S600 M3\nG0 X46 Z2\nG1 Z-85 F240\nG0 X60\nM2\n"));
    QCOMPARE(window.findings().count(), 1);
    QVERIFY(window.findings().item(0)->text().startsWith("Line 3"));
    LatheSetup lathe = latheOf(window.document().workpiece());
    QCOMPARE(lathe.chuck.grip, 20.0);
    lathe.chuck.grip = 10.0;
    window.document().commit(QStringLiteral("grip"),
                             std::make_unique<LatheSetupEdit>(std::make_shared<const LatheSetup>(lathe)));
    QVERIFY(window.findings().count() == 0 && !window.driver.find<QPushButton>("programCut")->isEnabled());
    window.driver.click("programRun");
    QVERIFY(window.driver.settle());
    QCOMPARE(window.findings().count(), 0);
    QVERIFY(window.driver.find<QPushButton>("programCut")->isEnabled());
  }

  // With the tools of the post, the first of which has a holder that begins 6 mm behind its tip, a plunge of 8 mm is a
  // collision. Cut for good it is recorded, and undo removes only the groove.
  void holdersOfTheToolTable() {
    ProgramWindow& window = reused();
    QVERIFY(window.begin());
    window.driver.click("programTools");
    window.driver.click("toolTablePost");
    const auto* const table = window.driver.find<QTableWidget>("toolTable");
    QCOMPARE(table->horizontalHeaderItem(4)->text(), QStringLiteral("Offset X R"));  // on the radius
    const int rows = table->rowCount();
    QVERIFY(rows > 0);  // without file, paper and disk
    window.driver.click("toolTableAccept");
    QTRY_VERIFY(window.driver.find<QPushButton>("programTools")->text().contains(QString::number(rows)));
    QVERIFY(window.run("G7 G21 T1 M6 G43\nG97 S600 M3\nG0 X54 Z-50\nG1 X34 F60\nG0 X54\nM2\n"));
    QCOMPARE(window.findings().count(), 1);
    QVERIFY2(
        window.findings().item(0)->text().startsWith("Line 4") && window.findings().item(0)->text().contains("meets"),
        qPrintable(window.findings().item(0)->text()));
    // Asked about before anything is struck.
    const WorkpieceDocument& document = window.document();
    window.driver.click("programCut");
    QVERIFY(window.driver.settle());
    QVERIFY2(window.driver.text("messageText").contains("Line 4"), qPrintable(window.driver.text("messageText")));
    QVERIFY(!document.workpiece().part && !document.workpiece().crashes);
    window.driver.click("messageOther");
    QVERIFY(!document.workpiece().part && !document.workpiece().crashes);
    window.driver.click("programCut");
    window.driver.click("messageAction");
    QVERIFY(window.driver.settle());
    QVERIFY(document.workpiece().part && document.workpiece().crashes && document.workpiece().crashes->size() == 1);
    window.document().history()->undo();
    QVERIFY(window.driver.settle());
    QVERIFY(!document.workpiece().part && document.workpiece().crashes->size() == 1);
    window.document().history()->redo();
    QVERIFY(document.workpiece().part && document.workpiece().crashes->size() == 1);
  }

  // The table is part of the document: undone with it, saved and read again.
  void theToolTableIsOfTheDocument() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("bar.handwheel");
    QString shown;
    {
      ProgramWindow& window = reused();
      QVERIFY(window.begin());
      const QString without = window.driver.find<QPushButton>("programTools")->text();
      window.driver.click("programTools");
      window.driver.click("toolTablePost");
      window.driver.click("toolTableAccept");
      auto* tools = window.driver.find<QPushButton>("programTools");
      QTRY_VERIFY(tools->text() != without);
      shown = tools->text();
      QVERIFY(window.document().workpiece().programTools);
      window.document().history()->undo();
      QVERIFY(window.driver.settle());
      QVERIFY(tools->text() == without && !window.document().workpiece().programTools);
      window.document().history()->redo();
      QVERIFY(window.driver.settle());
      QCOMPARE(tools->text(), shown);
      window.driver.choose("saveFile");
      QVERIFY(window.driver.enterFileName("saveDialog", path));
      QVERIFY(window.driver.settle());
    }
    ProgramWindow& window = reused();
    QVERIFY(window.driver.open(path) && window.openDock());
    QTRY_COMPARE(window.driver.find<QPushButton>("programTools")->text(), shown);
  }

  // A program without end is let go of at once.
  void cancelledAtOnce() {
    ProgramWindow& window = reused();
    QVERIFY(window.begin());
    window.write("#1=0\no1 while [#1 LT 4000000]\n#1=[#1+1]\no1 endwhile\nM2\n");
    window.driver.click("programRun");
    auto* cancel = window.driver.find<QPushButton>("programCancel");
    QTRY_VERIFY(cancel->isVisible());
    cancel->click();
    auto* again = window.driver.find<QPushButton>("programRun");
    QTRY_VERIFY(again->isVisible());
    QVERIFY(window.driver.text("programSummary").contains("cancelled"));
  }

  // The target is made: no more than 0.01 mm off, but for a sample at the shoulder.
  void roughedAndFinished() {
    ProgramWindow& window = reused();
    QVERIFY(window.begin());
    const double upper = window.document().workpiece().stock.position + window.document().workpiece().stock.length;
    const auto profile = TargetProfile::make({{{22.0, upper - 50.0}, {22.0, upper - 30.0}},
                                              {{22.0, upper - 30.0}, {18.0, upper - 30.0}},
                                              {{18.0, upper - 30.0}, {18.0, upper}}});
    QVERIFY(bool(profile));
    auto target = std::make_shared<const WorkpieceTarget>(WorkpieceTarget{*profile, "shaft"});
    window.document().commit(QStringLiteral("Import target"), std::make_unique<TargetEdit>(target));
    QVERIFY(window.driver.settle());
    const QList<QAction*> makes = window.driver.find<QToolButton>("programMake")->actions();
    QCOMPARE(makes.size(), 2);
    QCOMPARE(makes.back()->objectName(), QString("roughAndFinish"));
    makes.back()->trigger();
    window.driver.click("numbersAccept");
    QVERIFY(window.driver.settle());
    QVERIFY(window.editor().toPlainText().contains("G96"));
    QCOMPARE(window.findings().count(), 0);
    window.driver.click("programCut");
    QVERIFY(window.driver.settle());
    const TurnedProfile& part = window.document().workpiece().part->profile;
    const std::vector<std::pair<double, double>> expected{{5, 18}, {20, 18}, {29, 18}, {31, 22}, {45, 22}};
    for (const auto& [below, radius] : expected) {
      const auto i = static_cast<std::size_t>(std::lround((part.length() - below) / part.spacing()));
      QVERIFY2(std::abs(part.radius(i) - radius) < 0.01, qPrintable(QString::number(part.radius(i))));
    }
  }

  // Typed text that was not saved is asked about: kept, saved or dropped by the user's choice.
  void unsavedTextIsAskedAbout() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("typed.ngc");
    ProgramWindow& window = fresh();
    QVERIFY(window.begin());
    window.write("G0 X60 Z2\nM2\n");
    window.driver.choose("closeDocument");
    QVERIFY(window.answer(QMessageBox::Cancel));
    QCOMPARE(window.driver.tabs(), 1);
    window.driver.choose("closeDocument");
    QVERIFY(window.answer(QMessageBox::Save));
    QVERIFY(window.driver.enterFileName("saveProgramDialog", path));
    QTRY_COMPARE(window.driver.tabs(), 0);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("G0 X60 Z2\nM2\n"));
  }

  // If there is no workpiece to run it on, opening a program says so, and offers a new bar or one that is open.
  void aProgramWithoutAWorkpiece() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("part.ngc");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("G0 X60 Z2\nM2\n") > 0);
    file.close();
    ProgramWindow& window = fresh();
    QVERIFY(window.driver.open(path));
    QCOMPARE(window.driver.tabs(), 0);
    QTRY_VERIFY(window.driver.text("messageText").contains("part.ngc is a program"));
    QVERIFY(!window.driver.find<QWidget>("messageOther")->isVisible());
    window.driver.click("messageAction");
    QVERIFY(window.driver.settle());
    QCOMPARE(window.driver.tabs(), 1);
    QTRY_VERIFY(window.editor().isVisible());
    QTRY_VERIFY(window.editor().toPlainText().startsWith("G0 X60"));
    // A part of another kind is in front: the bar is offered, too.
    window.write("M2\n");
    window.driver.choose("newExercise");
    QVERIFY(window.driver.settle() && window.driver.open(path));
    QTRY_VERIFY(window.driver.find<QWidget>("messageOther")->isVisible());
    window.driver.click("messageOther");
    QVERIFY(window.driver.settle());
    QCOMPARE(window.driver.tabs(), 2);
    QTRY_VERIFY(window.editor().isVisible() && window.editor().toPlainText().startsWith("G0 X60"));
  }

  // A program that is opened as any file comes to the workpiece on which one works.
  void anOpenedProgramComesToItsDock() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("part.nc");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("%\r\nO1\r\nT0101\r\nG0 X60. Z2.\r\nM30\r\n%\r\n") > 0);
    file.close();
    ProgramWindow& window = fresh();
    window.driver.choose("newWorkpiece");
    QVERIFY(window.driver.settle());
    QVERIFY(window.driver.open(path));
    QCOMPARE(window.driver.tabs(), 1);
    QTRY_VERIFY(window.editor().isVisible());
    QVERIFY(window.editor().toPlainText().startsWith("%\nO1"));
    QCOMPARE(window.driver.find<QComboBox>("programDialect")->currentText(), QStringLiteral("Fanuc, system A"));
    // Saved, its lines end as they did.
    window.editor().moveCursor(QTextCursor::End);
    QTest::keyClicks(&window.editor(), "(end)");
    QTest::keyClick(&window.editor(), Qt::Key_S, Qt::ControlModifier);
    QVERIFY(window.driver.settle());
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().endsWith("M30\r\n%\r\n(end)"));
  }

  // The messages of a run come and go below the text; its buttons stay in position.
  void theButtonsStayInTheirPlace() {
    ProgramWindow& window = fresh();
    QVERIFY(window.begin());
    const auto* run = window.driver.find<QPushButton>("programRun");
    const QPoint before = run->mapTo(run->window(), QPoint());
    for (const char* text : {kTurned, "G7 G21 G97 S600 M3\nG99999\nM2\n"}) {
      QVERIFY(window.run(text));
      QCOMPARE(run->mapTo(run->window(), QPoint()), before);
    }
  }
};

HANDWHEEL_WINDOW_TEST(ProgramWindowTest)
#include "ProgramWindowTest.moc"

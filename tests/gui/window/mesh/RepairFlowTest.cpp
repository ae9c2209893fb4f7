// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../QuickWindow.h"
#include "../StlFiles.h"
#include "../WindowTestMain.h"
#include "../haptics/SoupCorners.h"
#include "MeshShapes.h"

#include <QComboBox>
#include <QMessageBox>
#include <QTimer>
#include <QTreeWidget>

using namespace handwheel;
using namespace handwheel::test;

// The work of a designer: open a scan, look, preview, fill, undo, repair, save.
class RepairFlowTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;
  ClassWindow m_window;

  QString fileWithHoles(const char* name) {
    const QString path = m_folder.filePath(QString::fromLatin1(name));
    const auto triangles = quadTorus(48, 24, {{3, 5}, {20, 11}, {35, 17}});
    Q_ASSERT(openEdges(triangles) == 12);
    writeStl(path, triangles);
    return path;
  }

 private slots:
  void fillUndoRedoRepairSave() {
    QuickWindow driver;
    driver.click("quickActions/openFile");
    QVERIFY(driver.enterFileName("openDialog", fileWithHoles("flow.stl")));
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 1);
    QCOMPARE(driver.count(DefectKind::Hole), 3);
    QCOMPARE(driver.text("stateHeadline"), "3 holes");
    QVERIFY(driver.find<QWidget>("nextStepCard")->isVisible());

    driver.clickDefect(DefectKind::Hole, 1);
    QVERIFY(driver.find<QWidget>("holeSettings")->isVisible());
    QVERIFY(!driver.find<QWidget>("nextStepCard")->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("previewStatus").contains("new triangle"), kPatienceMs);
    QCOMPARE(driver.count(DefectKind::Hole), 3);  // a preview changes nothing

    driver.click("compareMethods");
    auto* table = driver.find<QTreeWidget>("methodTable");
    QTRY_COMPARE_WITH_TIMEOUT(table->topLevelItemCount(), 8, kPatienceMs);
    for (int i = 0; i < 8; ++i) {
      if (table->topLevelItem(i)->text(0) != "Ear clipping") continue;
      QVERIFY(table->topLevelItem(i)->text(1).toInt() > 0);
      table->scrollToItem(table->topLevelItem(i));
      QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualItemRect(table->topLevelItem(i)).center());
      break;
    }
    QCOMPARE(driver.find<QComboBox>("fillMethod")->currentText(), "Ear clipping");
    driver.click("compareMethods");
    QVERIFY(driver.settle());

    driver.click("fillHoleButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 2, kPatienceMs);
    QVERIFY(driver.settle());
    driver.click("quickActions/undo");
    QCOMPARE(driver.count(DefectKind::Hole), 3);
    driver.click("quickActions/redo");
    QCOMPARE(driver.count(DefectKind::Hole), 2);

    driver.click("repairAllButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 0, kPatienceMs);
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("stateHeadline"), "Watertight", kPatienceMs);
    QVERIFY(driver.window().isWindowModified());

    driver.click("nextStep/saveFileAs");
    const QString saved = m_folder.filePath("saved.stl");
    QVERIFY(driver.enterFileName("saveDialog", saved));
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isWindowModified(), kPatienceMs);
    const auto triangles = readStl(saved);
    QVERIFY(triangles.size() >= 2 * 48 * 24);
    QCOMPARE(openEdges(triangles), 0);
    QVERIFY(driver.window().windowTitle().startsWith("saved.stl"));
    QCOMPARE(driver.text("nextStepDetail"), "Saved as saved.stl.");
    QCOMPARE(openEdges(readStl(m_folder.filePath("flow.stl"))), 12);  // the original is as it was
    driver.click("closeTab");
    QCOMPARE(driver.tabs(), 0);
  }

  void aMethodChangesThePreviewAtOnce() {
    QuickWindow driver;
    QVERIFY(driver.open(fileWithHoles("method.stl")));
    driver.clickDefect(DefectKind::Hole, 0);
    auto* methods = driver.find<QComboBox>("fillMethod");
    methods->setCurrentIndex(methods->findText("Ear clipping"));
    // A quad without new vertices takes two triangles.
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("previewStatus"), "2 new triangles", kPatienceMs);
    driver.click("fillHoleButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 2, kPatienceMs);
    QCOMPARE(driver.text("figures"), QString::fromUtf8("2,300 triangles · 2 holes"));  // 2 * (48 * 24 - 3) + 2
  }

  // Card and list say what was there before; once it is saved, the card says that, and what was repaired stays so.
  void whatARepairHasDone() {
    std::vector<Corners> triangles = quadTorus(48, 24, {{3, 5}, {20, 11}, {35, 17}});
    const Corner a{100, 0, 0}, b{101, 0, 0}, c{100, 1, 0};  // both sides of a plate, which nothing mends
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, b});
    const QString path = m_folder.filePath("done.stl");
    writeStl(path, triangles);
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(path));
    driver.click("repairAllButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 0, kPatienceMs);
    QVERIFY(driver.settle());
    QVERIFY2(driver.text("nextStepDetail").startsWith("3 of 3 holes filled."),
             qPrintable(driver.text("nextStepDetail")));
    const auto before = [&](DefectKind kind) {
      return driver.defects().groupIndex(kind).data(DefectModel::BeforeRole).toInt();
    };
    QCOMPARE(before(DefectKind::Hole), 3);
    QCOMPARE(before(DefectKind::Duplicate), -1);
    QVERIFY(driver.window().findChild<QAbstractButton*>("nextStep/undoRepair"));
    driver.click("nextStep/saveFileAs");
    QVERIFY(driver.enterFileName("saveDialog", m_folder.filePath("done2.stl")));
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("nextStepDetail").contains("Saved as done2.stl."), kPatienceMs);
    QTRY_VERIFY(!driver.window().findChild<QAbstractButton*>("nextStep/undoRepair"));
    driver.choose("undo");
    QCOMPARE(before(DefectKind::Hole), -1);
    QVERIFY(driver.settle());
  }

  // A row moves the camera only if its defect is not well visible already.
  void aRowThatIsSeenMovesNothing() {
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(fileWithHoles("seen.stl")));
    driver.clickDefect(DefectKind::Hole, 1);
    auto* view = driver.find<Viewport>("viewport");
    CameraState chosen = view->camera();
    chosen.height *= 1.3;
    view->setCamera(chosen);
    QTRY_VERIFY_WITH_TIMEOUT(view->isPickingReady(), kPatienceMs);
    driver.clickDefect(DefectKind::Hole, 1);
    QCOMPARE(view->camera(), chosen);
    chosen.orientation = Eigen::AngleAxisd(M_PI, chosen.up()) * chosen.orientation;  // from behind
    view->setCamera(chosen);
    driver.clickDefect(DefectKind::Hole, 1);
    QVERIFY(view->camera() != chosen);
    QVERIFY(driver.settle());
  }

  void whatIsKeptOpenStaysOpen() {
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(fileWithHoles("keep.stl")));
    driver.clickDefect(DefectKind::Hole, 0);
    driver.click("keepOpenButton");
    QCOMPARE(driver.count(DefectKind::Hole), 2);
    QCOMPARE(driver.count(DefectKind::KeptOpen), 1);
    driver.click("repairAllButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 0, kPatienceMs);
    QCOMPARE(driver.count(DefectKind::KeptOpen), 1);
    QCOMPARE(driver.text("stateHeadline"), "No holes");
    driver.click("quickActions/saveFile");
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isWindowModified(), kPatienceMs);
    QCOMPARE(openEdges(readStl(m_folder.filePath("keep.stl"))), 4);
    driver.click("closeTab");
  }

  // A mark of the user, as for a hole; a sheet of 4 × 4 squares without one has an outer edge and a hole.
  void anOuterEdgeCanBeMarkedToo() {
    std::vector<Corners> sheet;
    for (int cell = 0; cell < 16; ++cell) {
      const auto x = float(cell % 4), y = float(cell / 4);
      if (cell == 5) continue;
      sheet.push_back({Corner{x, y, 0}, Corner{x + 1, y, 0}, Corner{x + 1, y + 1, 0}});
      sheet.push_back({Corner{x, y, 0}, Corner{x + 1, y + 1, 0}, Corner{x, y + 1, 0}});
    }
    const QString path = m_folder.filePath("sheet.stl");
    writeStl(path, sheet);
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(path));
    QCOMPARE(driver.count(DefectKind::KeptOpen), 1);
    QVERIFY(driver.text("nextStepDetail").contains("1 open sheet."));
    driver.clickDefect(DefectKind::KeptOpen, 0);
    auto* keep = driver.find<QAction>("keepOpen");
    QVERIFY(keep->isEnabled() && !keep->isChecked());
    keep->trigger();
    QVERIFY(keep->isChecked());
    QVERIFY(driver.find<QAction>("undo")->text().contains("Keep open"));
    QVERIFY(!driver.find<QAction>("fillHole")->isEnabled());
    QVERIFY(driver.settle());
  }

  // The camera flies to a hole; pointing into its middle selects it.
  void clickingIntoAHoleSelectsIt() {
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(fileWithHoles("click.stl")));
    driver.click("nextStep/goOneByOne");
    auto* view = driver.find<Viewport>("viewport");
    const CameraState there = view->camera();  // the camera at the end of the flight
    driver.choose("deselect");
    QTRY_VERIFY(!driver.find<QWidget>("holeSettings")->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(view->isPickingReady(), kPatienceMs);
    view->setCamera(there);
    QTest::mouseClick(view, Qt::LeftButton, {}, view->rect().center());
    QTRY_VERIFY(driver.find<QWidget>("holeSettings")->isVisible());
    QVERIFY(driver.settle());
  }

  void aRepairThatWasUndoneIsOfferedAgain() {
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(fileWithHoles("again.stl")));
    driver.click("nextStep/repairAll");
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("nextStepTitle"), "Watertight.", kPatienceMs);
    driver.click("quickActions/undo");
    QCOMPARE(driver.text("nextStepTitle"), "3 holes found.");
    QVERIFY(driver.find<QAbstractButton>("nextStep/repairByVolume"));
    QCOMPARE(driver.text("figures"), QString::fromUtf8("2,298 triangles · 3 holes"));
    driver.click("quickActions/redo");
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("stateHeadline"), "Watertight", kPatienceMs);
    QVERIFY(driver.text("figures").endsWith(QString::fromUtf8(" · Watertight")));
    QVERIFY(driver.find<QAction>("undoRepair")->isEnabled());
    QVERIFY(driver.settle());
  }

  // Beside a closed body there is a sheet, which the card names and can thicken; and the repair can be undone there.
  void theCardAfterARepair() {
    std::vector<Corners> triangles = quadTorus(48, 24, {{3, 5}});
    for (int cell = 0; cell < 100; ++cell) {
      const auto x = float(100 + cell % 10), y = float(cell / 10);
      triangles.push_back({Corner{x, y, 0}, Corner{x + 1, y, 0}, Corner{x + 1, y + 1, 0}});
      triangles.push_back({Corner{x, y, 0}, Corner{x + 1, y + 1, 0}, Corner{x, y + 1, 0}});
    }
    const QString path = m_folder.filePath("beside.stl");
    writeStl(path, triangles);
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(path));
    QCOMPARE(driver.count(DefectKind::Hole), 1);
    QVERIFY(!driver.find<QAction>("undoRepair")->isEnabled());
    driver.click("nextStep/repairAll");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 0, kPatienceMs);
    QVERIFY(driver.settle());
    QCOMPARE(driver.text("nextStepTitle"), "No holes. 1 open sheet among 2 pieces.");
    QTRY_VERIFY(driver.find<QAbstractButton>("nextStep/saveFileAs")->isVisible());
    QVERIFY(driver.find<QAbstractButton>("nextStep/thickenSheet")->isEnabled());
    driver.click("nextStep/undoRepair");
    QVERIFY(driver.settle());
    QCOMPARE(driver.count(DefectKind::Hole), 1);
    QVERIFY(!driver.find<QAction>("undoRepair")->isEnabled());
  }

  // A cube that is inside out has no hole of which it would be known that it was tried.
  void aRepairWithoutHolesIsOfferedAgain() {
    QuickWindow& driver = m_window.cleared();
    const QString path = m_folder.filePath("inside-out.stl");
    writeStl(path, cornersOf(turnedOver(cube(20.0))));
    QVERIFY(driver.open(path));
    QCOMPARE(driver.count(DefectKind::InsideOut), 1);
    driver.click("nextStep/repairAll");
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("nextStepTitle"), "Watertight.", kPatienceMs);
    driver.click("quickActions/undo");
    QVERIFY(driver.settle());
    QCOMPARE(driver.count(DefectKind::InsideOut), 1);
    driver.click("nextStep/repairAll");
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("nextStepTitle"), "Watertight.", kPatienceMs);
  }

  // In the numbers of an STL file, the lower side of the small box lies on the upper side of the large one.
  void afterSavingTheStateIsThatOfTheFile() {
    const QString path = m_folder.filePath("near.obj");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    int first = 1;
    for (const auto& [low, high] : {std::pair<Vec3, Vec3>{{0, 0, 0}, {1000, 1000, 1000}},
                                    std::pair<Vec3, Vec3>{{400, 400, 1000.000001}, {500, 500, 1010}}}) {
      for (int corner = 0; corner < 8; ++corner) {
        const double x = corner & 1 ? high.x() : low.x(), y = corner & 2 ? high.y() : low.y(),
                     z = corner & 4 ? high.z() : low.z();
        file.write(QStringLiteral("v %1 %2 %3\n").arg(x, 0, 'g', 17).arg(y, 0, 'g', 17).arg(z, 0, 'g', 17).toLatin1());
      }
      for (const auto& side : {std::array{1, 3, 4, 2}, std::array{5, 6, 8, 7}, std::array{1, 2, 6, 5},
                               std::array{3, 7, 8, 4}, std::array{1, 5, 7, 3}, std::array{2, 4, 8, 6}}) {
        const auto at = [&](std::size_t i) { return side[i] + first - 1; };
        file.write(QStringLiteral("f %1 %2 %3\nf %1 %3 %4\n").arg(at(0)).arg(at(1)).arg(at(2)).arg(at(3)).toLatin1());
      }
      first += 8;
    }
    file.close();
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(path));
    QVERIFY(driver.settle());
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("stateHeadline"), "Watertight", kPatienceMs);
    driver.choose("saveFileAs");
    QVERIFY(driver.enterFileName("saveDialog", m_folder.filePath("near.stl")));
    QTRY_VERIFY_WITH_TIMEOUT(driver.window().windowTitle().startsWith("near.stl"), kPatienceMs);
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("stateHeadline"), "Self-intersecting", kPatienceMs);
    QVERIFY(driver.settle());
    QCOMPARE(driver.text("nextStepTitle"), "Self-intersecting.");
    QVERIFY(driver.find<QAbstractButton>("nextStep/repairAll")->isEnabled());
  }

  // A button that stands out may be pressed by habit.
  void noButtonThatStandsOutDeletes() {
    std::vector<Corners> triangles = quadTorus(48, 24, {});
    const Corner a{100, 0, 0}, b{101, 0, 0}, c{100, 1, 0}, d{100, 0, 1};
    for (const Corners& flake : {Corners{a, c, b}, Corners{a, b, d}, Corners{a, d, c}, Corners{b, c, d}})
      triangles.push_back(flake);
    const QString path = m_folder.filePath("flake.stl");
    writeStl(path, triangles);
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(path));
    QVERIFY(driver.settle());
    QCOMPARE(driver.count(DefectKind::Debris), 1);
    QVERIFY(driver.find<QAbstractButton>("nextStep/removeDebris")->isEnabled());
    QVERIFY(!driver.find<QAbstractButton>("nextStep/removeDebris")->property("primary").toBool());
  }

  // A tube of 48 sides, each turned by 7.5° from the next, with one open end: its lid bends by a right angle.
  void aPatchThatBendsIsToBeChecked() {
    constexpr int kSides = 48, kRings = 12;
    const auto at = [](int i, int k) {
      const double angle = 2.0 * M_PI * i / kSides;
      return Corner{static_cast<float>(10.0 * std::cos(angle)), static_cast<float>(10.0 * std::sin(angle)), 2.0F * k};
    };
    std::vector<Corners> triangles;
    for (int i = 0; i < kSides; ++i) {
      triangles.push_back({Corner{0, 0, 0}, at(i + 1, 0), at(i, 0)});
      for (int k = 0; k < kRings; ++k) {
        triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
        triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
      }
    }
    const QString path = m_folder.filePath("tube.stl");
    writeStl(path, triangles);
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(path));
    QVERIFY(driver.settle());
    driver.click("repairAllButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("stateHeadline"), "Watertight", kPatienceMs);
    const QString warning = "Check the patch of Hole 1: the patch bends by 90°, its surroundings by at most 8°.";
    QVERIFY2(driver.text("nextStepDetail").contains(warning), qPrintable(driver.text("nextStepDetail")));
    driver.click("quickActions/undo");
    QVERIFY(driver.settle());
    QVERIFY2(!driver.text("nextStepDetail").contains("Check"), qPrintable(driver.text("nextStepDetail")));
  }

  void aDismissedCardStaysAway() {
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(fileWithHoles("card.stl")));
    driver.click("nextStepClose");
    QVERIFY(!driver.find<QWidget>("nextStepCard")->isVisible());
    driver.click("repairAllButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 0, kPatienceMs);
    QVERIFY(driver.settle());
    QVERIFY(!driver.find<QWidget>("nextStepCard")->isVisible());
  }

  void aDamagedFileIsExplainedAndOpenedInPart() {
    const QString path = m_folder.filePath("damaged.stl");
    writeStl(path, quadTorus(48, 24, {}));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadWrite));
    QVERIFY(file.resize(84 + 50 * 1000 + 7));  // cut off in the middle of a facet
    file.close();
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(path));
    QCOMPARE(driver.tabs(), 0);
    QVERIFY(driver.find<QWidget>("messageBar")->isVisible());
    QVERIFY(driver.text("messageText").contains("damaged.stl"));
    driver.click("messageAction");
    QTRY_COMPARE_WITH_TIMEOUT(driver.tabs(), 1, kPatienceMs);
    QVERIFY(driver.text("figures").startsWith("1,000 triangles "));
    QVERIFY(driver.settle());
  }

  void closingAsksAboutChanges() {
    QuickWindow driver;
    QVERIFY(driver.open(fileWithHoles("close.stl")));
    driver.click("repairAllButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 0, kPatienceMs);
    answerPrompt(QMessageBox::Cancel);
    driver.window().close();
    QTRY_VERIFY(QApplication::activeModalWidget());
    QTRY_VERIFY(!QApplication::activeModalWidget());
    QVERIFY(driver.window().isVisible());
    QCOMPARE(driver.tabs(), 1);
    answerPrompt(QMessageBox::Save);
    driver.window().close();
    QTRY_VERIFY_WITH_TIMEOUT(!driver.window().isVisible(), kPatienceMs);
    QCOMPARE(openEdges(readStl(m_folder.filePath("close.stl"))), 0);
  }

 private:
  static void answerPrompt(QMessageBox::StandardButton answer) {
    QTimer::singleShot(200, qApp, [answer] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!box) qFatal("nobody asks");
      QTest::mouseClick(box->button(answer), Qt::LeftButton);
    });
  }
};

HANDWHEEL_WINDOW_TEST(RepairFlowTest)
#include "RepairFlowTest.moc"

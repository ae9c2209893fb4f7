// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../QuickWindow.h"
#include "../StlFiles.h"
#include "../WindowTestMain.h"
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "controls/CommandModel.h"
#include "document/AtomicFile.h"
#include "document/formats/MeshWriter.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"

using namespace handwheel;
using namespace handwheel::test;

// Each kind of defect, mended from the list.
class DefectFixesWindowTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;
  ClassWindow m_window;

  QString file(const char* name, const TriangleSoup& soup) {
    std::vector<Corners> triangles;
    for (const Triangle& t : soup.triangles) {
      Corners corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3f p = soup.points[t[k]].cast<float>();
        corners[k] = {p.x(), p.y(), p.z()};
      }
      triangles.push_back(corners);
    }
    const QString path = m_folder.filePath(QString::fromLatin1(name));
    writeStl(path, triangles);
    return path;
  }

  // Two sheets.
  static TriangleSoup acrossOneAnother() {
    return {{{0.0, 0.0, 0.0},
             {1.0, 0.0, 0.0},
             {1.0, 1.0, 0.0},
             {0.0, 1.0, 0.0},
             {0.5, 0.0, -0.5},
             {0.5, 1.0, -0.5},
             {0.5, 1.0, 0.5},
             {0.5, 0.0, 0.5}},
            {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}};
  }

  static void clickGroup(WindowDriver& driver, DefectKind kind) {
    auto* list = driver.find<QTreeView>("defectList");
    const QModelIndex group = driver.defects().groupIndex(kind);
    list->scrollTo(group);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(group).center());
  }

 private slots:
  void crossingCubes() {
    TriangleSoup soup = cube();
    append(soup, cube(1.0, {0.41, 0.27, 0.33}));
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(file("cubes.stl", soup)));
    const int crossings = driver.count(DefectKind::SelfIntersection);
    QVERIFY(crossings > 0);
    QCOMPARE(driver.text("stateHeadline"), "Self-intersecting");
    QCOMPARE(driver.text("nextStepTitle"), "Self-intersecting.");
    clickGroup(driver, DefectKind::SelfIntersection);
    driver.click("fixDefectButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::SelfIntersection), 0, kPatienceMs);
    QVERIFY(driver.settle());
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("stateHeadline"), "Watertight", kPatienceMs);
    driver.click("quickActions/undo");
    QVERIFY(driver.settle());
    QCOMPARE(driver.count(DefectKind::SelfIntersection), crossings);
    // "Repair all" does it, too, and then has nothing more to do.
    driver.click("repairAllButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::SelfIntersection), 0, kPatienceMs);
    QVERIFY(driver.settle());
    QCOMPARE(driver.text("stateHeadline"), "Watertight");
    QVERIFY(!driver.find<QAbstractButton>("repairAllButton")->isEnabled());
  }

  // The walls inside both are removed, in one step that can be undone; it is not offered for bodies that do not
  // intersect.
  void bodiesThatIntersectAreUnited() {
    TriangleSoup soup = cube();
    append(soup, cube(1.0, {0.41, 0.27, 0.33}));
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(file("two.stl", soup)));
    const Document& shown = driver.window().findChild<DocumentTabs*>()->current()->document;
    const auto volumeOf = [&shown] {
      return test::volume(static_cast<const MeshDocument&>(shown).mesh().compact().soup);
    };
    auto* const unite = driver.find<QAction>("uniteBodies");
    QVERIFY(unite->isEnabled());
    unite->trigger();
    QVERIFY(driver.settle());
    QVERIFY(std::abs(volumeOf() - (2.0 - 0.59 * 0.73 * 0.67)) < 1e-5);
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("stateHeadline"), "Watertight", kPatienceMs);
    QVERIFY(!unite->isEnabled());
    driver.find<QAction>("undo")->trigger();
    QVERIFY(driver.settle());
    QVERIFY(std::abs(volumeOf() - 2.0) < 1e-5);
    QVERIFY(unite->isEnabled());
    // Resolved instead, what both had in common is a body inside: the card says so, and it can still go.
    driver.find<QAction>("resolveIntersections")->trigger();
    QVERIFY(driver.settle());
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("stateHeadline"), "Watertight", kPatienceMs);
    QVERIFY(std::abs(volumeOf() - 2.0) < 1e-5);
    QVERIFY2(driver.text("nextStepDetail").contains("1 body inside another"),
             qPrintable(driver.text("nextStepDetail")));
    QVERIFY(unite->isEnabled());
    // Its effect is shown while the pointer or the focus is on its button.
    QCOMPARE(driver.text("fixPreviewStatus"), QString());
    auto* const button = driver.find<QAbstractButton>("nextStep/uniteBodies");
    QFocusEvent enter(QEvent::FocusIn);
    QCoreApplication::sendEvent(button, &enter);
    QVERIFY(driver.settle());
    QVERIFY2(driver.text("fixPreviewStatus").startsWith("Removes "), qPrintable(driver.text("fixPreviewStatus")));
    QVERIFY(std::abs(volumeOf() - 2.0) < 1e-5);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(button, &leave);
    QVERIFY(driver.settle());
    QCOMPARE(driver.text("fixPreviewStatus"), QString());
    unite->trigger();
    QVERIFY(driver.settle());
    QVERIFY(std::abs(volumeOf() - (2.0 - 0.59 * 0.73 * 0.67)) < 1e-5);
    QVERIFY(!driver.text("nextStepDetail").contains("inside another"));
  }

  // The reversal on opening is already done, and can be undone; neither asks to save.
  void turnedOnOpening() {
    TriangleSoup soup = icosphere(2);
    for (const std::size_t f : {3, 40, 200}) std::swap(soup.triangles[f][1], soup.triangles[f][2]);
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(file("turned.stl", soup)));
    QCOMPARE(driver.count(DefectKind::Flipped), 3);
    QCOMPARE(driver.count(DefectKind::Inconsistent), 0);
    QCOMPARE(driver.text("stateHeadline"), "Watertight");
    driver.click("quickActions/undo");
    QVERIFY(driver.settle());
    QCOMPARE(driver.count(DefectKind::Flipped), 0);
    QCOMPARE(driver.count(DefectKind::Inconsistent), 3);
    QCOMPARE(driver.count(DefectKind::Hole), 0);
    QCOMPARE(driver.text("stateHeadline"), "Inconsistently oriented");
    QVERIFY(!driver.window().isWindowModified());
    QVERIFY(driver.find<QAbstractButton>("repairAllButton")->isEnabled());
    driver.click("quickActions/redo");
    QVERIFY(driver.settle());
    QCOMPARE(driver.count(DefectKind::Flipped), 3);
    QVERIFY(!driver.window().isWindowModified());
    driver.click("quickActions/undo");
    clickGroup(driver, DefectKind::Inconsistent);
    driver.click("fixDefectButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Inconsistent), 0, kPatienceMs);
    QVERIFY(driver.settle());
    QCOMPARE(driver.text("stateHeadline"), "Watertight");
    QVERIFY(driver.window().isWindowModified());
  }

  // Two cubes that touch along an edge, and two that intersect: the card names both defects, with their numbers.
  void theCardNamesSelfIntersectionsBesideOthers() {
    TriangleSoup soup = cube();
    append(soup, cube(1.0, {1, 1, 0}));
    append(soup, cube(1.0, {5.0, 0.0, 0.0}));
    append(soup, cube(1.0, {5.41, 0.27, 0.33}));
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(file("both.stl", soup)));
    const int crossings = driver.count(DefectKind::SelfIntersection);
    QVERIFY(crossings > 1);
    QCOMPARE(driver.count(DefectKind::NonManifoldEdge), 1);
    QCOMPARE(driver.text("nextStepTitle"), "Not manifold.");
    const QString detail = driver.text("nextStepDetail");
    QVERIFY2(detail.contains("1 non-manifold edge"), qPrintable(detail));
    QVERIFY2(detail.contains(QStringLiteral("%1 self-intersections").arg(crossings)), qPrintable(detail));
    clickGroup(driver, DefectKind::NonManifoldEdge);
    driver.click("fixDefectButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::NonManifoldEdge), 0, kPatienceMs);
    QVERIFY(driver.settle());
    QCOMPARE(driver.text("nextStepTitle"), "Self-intersecting.");
    QVERIFY(driver.text("nextStepDetail").contains(QStringLiteral("%1 self-intersections").arg(crossings)));
  }

  void duplicatesThenEdges() {
    TriangleSoup soup = cube();
    append(soup, cube(1.0, {1, 1, 0}));
    soup.triangles.push_back(soup.triangles[0]);
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(file("touching.stl", soup)));
    clickGroup(driver, DefectKind::Duplicate);
    driver.click("fixDefectButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Duplicate), 0, kPatienceMs);
    QVERIFY(driver.settle());
    QCOMPARE(driver.count(DefectKind::NonManifoldEdge), 1);
    clickGroup(driver, DefectKind::NonManifoldEdge);
    driver.click("fixDefectButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::NonManifoldEdge), 0, kPatienceMs);
    QVERIFY(driver.settle());
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("stateHeadline"), "Watertight", kPatienceMs);
  }

  // The row, not the kind; the card says before what will be done, and nothing is done until then.
  void oneRowWithItsPreview() {
    TriangleSoup soup = cube();
    for (const std::size_t t : {std::size_t{3}, std::size_t{8}}) soup.triangles.push_back(soup.triangles[t]);
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(file("twice.stl", soup)));
    clickGroup(driver, DefectKind::Duplicate);
    QVERIFY(driver.settle());
    QVERIFY(driver.text("fixPreviewStatus").startsWith("Removes 2 "));
    driver.find<QTreeView>("defectList")->expand(driver.defects().groupIndex(DefectKind::Duplicate));
    driver.clickDefect(DefectKind::Duplicate, 1);
    QVERIFY(driver.settle());
    QVERIFY(driver.text("fixPreviewStatus").startsWith("Removes 1 "));
    driver.find<QAction>("showPreview")->trigger();
    QCOMPARE(driver.text("fixPreviewStatus"), QString());
    driver.find<QAction>("showPreview")->trigger();
    QVERIFY(driver.settle());
    QVERIFY(driver.text("fixPreviewStatus").startsWith("Removes 1 "));
    QCOMPARE(driver.count(DefectKind::Duplicate), 2);
    driver.click("fixDefectButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Duplicate), 1, kPatienceMs);
    QVERIFY(driver.settle());
  }

  // A hole of 2 mm by 2 mm in a plane; the whole sentence is seen.
  void measuresOfAHole() {
    TriangleSoup soup = cube(2.0);
    std::erase_if(soup.triangles, [&](const Triangle& t) {
      return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return soup.points[v].z() == 2.0; });
    });
    WindowDriver driver;  // with room for the whole text
    QVERIFY(driver.open(file("open.stl", soup)));
    driver.find<QTreeView>("defectList")->expand(driver.defects().groupIndex(DefectKind::Hole));
    driver.clickDefect(DefectKind::Hole, 0);
    QVERIFY(driver.settle());
    QCOMPARE(driver.text("holeMeasures"), QString::fromUtf8("Area 4.00 mm². 0 mm from the best-fitting plane (RMS)."));
    const auto* label = driver.find<QLabel>("holeMeasures");
    QVERIFY(label->isVisible());
    QVERIFY(label->height() >= label->heightForWidth(label->width()));
  }

  // Beside the patch of a hole, the other methods are previewed with the pointer on their button.
  void previewOfABack() {
    QuickWindow& driver = m_window.cleared();
    const auto height = [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0.02 * i * j); };
    QVERIFY(driver.open(file("sheet.stl", grid(9, 9, false, false, height))));
    driver.find<QTreeView>("defectList")->expand(driver.defects().groupIndex(DefectKind::KeptOpen));
    driver.clickDefect(DefectKind::KeptOpen, 0);
    QVERIFY(driver.settle());
    QCOMPARE(driver.text("otherPreviewStatus"), QString());
    auto* button = driver.find<QWidget>("holeSettings")->findChild<QAbstractButton*>("thickenSheetButton");
    QVERIFY(button && button->isVisible());
    QFocusEvent enter(QEvent::FocusIn);
    QCoreApplication::sendEvent(button, &enter);
    QVERIFY(driver.settle());
    QVERIFY(driver.text("otherPreviewStatus").contains("triangle"));
    QCOMPARE(driver.count(DefectKind::KeptOpen), 1);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(button, &leave);
    QCOMPARE(driver.text("otherPreviewStatus"), QString());
  }

  // The card says what its own fix would do, also after the pointer passed over another in the menu.
  void previewBesideASheet() {
    TriangleSoup soup = cube();
    soup.triangles.push_back(soup.triangles[3]);
    append(soup, moved(grid(9, 9, false, false, [](auto i, auto j) { return Vec3(i, j, 0.02 * i * j); }), {9, 0, 0}));
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(file("beside.stl", soup)));
    QVERIFY(driver.find<QAction>("thickenSheet")->isEnabled());
    clickGroup(driver, DefectKind::Duplicate);
    QVERIFY(driver.settle());
    QVERIFY(driver.text("fixPreviewStatus").startsWith("Removes 1 "));
    driver.find<QAction>("thickenSheet")->hover();
    QVERIFY(driver.settle());
    QVERIFY2(driver.text("fixPreviewStatus").startsWith("Removes 1 "), qPrintable(driver.text("fixPreviewStatus")));
  }

  void sheetGetsABack() {
    QuickWindow& driver = m_window.cleared();
    const auto height = [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0.02 * i * j); };
    QVERIFY(driver.open(file("sheet.stl", grid(9, 9, false, false, height))));
    QCOMPARE(driver.count(DefectKind::KeptOpen), 1);
    driver.click("nextStep/thickenSheet");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::KeptOpen), 0, kPatienceMs);
    QVERIFY(driver.settle());
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("stateHeadline"), "Watertight", kPatienceMs);
  }

  // The panel shows the thickness of the body, a hundredth of the diagonal, and takes another; the log says which.
  void thicknessOfASheet() {
    QuickWindow& driver = m_window.cleared();
    const auto flat = [](std::uint32_t i, std::uint32_t j) { return Vec3(30.0 * i, 40.0 * j, 0.0); };
    QVERIFY(driver.open(file("plate.stl", grid(11, 11, false, false, flat))));
    driver.clickDefect(DefectKind::KeptOpen, 0);
    auto* line = driver.find<QWidget>("sheetThickness")->findChild<QLineEdit*>();
    QVERIFY(line->isVisible());
    QVERIFY2(line->text().startsWith("5"), qPrintable(line->text()));
    const auto* action = driver.find<QAction>("thickenSheet");
    QCOMPARE(action->text().remove('&'), QString("Thicken sheets by 5.00 mm"));
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, "2");
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(action->text().remove('&'), QString("Thicken sheets by 2.00 mm"));
    driver.click("thickenSheetButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::KeptOpen), 0, kPatienceMs);
    QVERIFY(driver.settle());
    const auto* log = driver.find<QTreeView>("logView")->model();
    const QString last = log->index(log->rowCount() - 1, 1).data().toString();
    QVERIFY2(last.contains("Thicken sheets by 2.00 mm"), qPrintable(last));
  }

  // If every patch would cross an object in the hole, the card offers to cut.
  void aRodInTheHole() {
    TriangleSoup soup = sphereWithoutCap(3, 0.5);
    append(soup, moved(cylinder(12, 2, 0.1, 2.0, true), {0.03, 0.02, -0.2}));
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(file("rod.stl", soup)));
    driver.clickDefect(DefectKind::Hole, 0);
    driver.click("cutAndCloseButton");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 0, kPatienceMs);
    QVERIFY(driver.settle());
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("stateHeadline"), "Watertight", kPatienceMs);
  }

  // Each shell becomes a document; put together again they are what they were.
  void shellsApartAndTogether() {
    TriangleSoup soup = cube();
    append(soup, cube(1.0, {3, 0, 0}));
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(file("two.stl", soup)));
    driver.choose("splitShells");
    QTRY_COMPARE_WITH_TIMEOUT(driver.tabs(), 3, kPatienceMs);
    QVERIFY(driver.settle());
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("stateHeadline"), "Watertight", kPatienceMs);
    driver.choose("splitShells");
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("one shell"), kPatienceMs);
    QCOMPARE(driver.tabs(), 3);

    driver.choose("addMesh");
    QVERIFY(driver.enterFileName("addMeshDialog", file("one.stl", cube(1.0, {0, 3, 0}))));
    auto* undo = driver.find<QAction>("undo");
    QTRY_VERIFY_WITH_TIMEOUT(undo->isEnabled(), kPatienceMs);
    QVERIFY(driver.settle());
    QVERIFY(undo->text().contains("Add a mesh"));
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("stateHeadline"), "Watertight", kPatienceMs);
  }

  // A triangle with two sides is closed. If nothing helps, every method says so.
  void aPlateWithoutThickness() {
    TriangleSoup soup = cube();
    append(soup, moved(TriangleSoup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}, {3, 0, 0}));
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(file("plate.stl", soup)));
    QCOMPARE(driver.count(DefectKind::Duplicate), 1);
    clickGroup(driver, DefectKind::Duplicate);
    QVERIFY(driver.settle());
    QVERIFY(driver.text("fixPreviewStatus").contains("two sides of a plate"));
    QVERIFY(!driver.find<QAbstractButton>("fixDefectButton")->isEnabled());
    driver.find<QAction>("repairAll")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("Repair all"), kPatienceMs);
    QVERIFY(!driver.text("messageText").contains("stay open"));  // there is no hole
    QVERIFY(driver.settle());
    QCOMPARE(driver.count(DefectKind::Duplicate), 1);
    QVERIFY(driver.text("nextStepDetail").contains("1 duplicate triangle"));
    const auto* const repair = driver.find<QAction>("repairAll");
    QVERIFY(!repair->isEnabled());  // it would do nothing
    QVERIFY(repair->property(kDisabledReason).toString().startsWith("The last repair has tried it"));
  }

  // Two sheets across one another are not cut: each piece would hang at the others. The window says so.
  void whatCannotBeMended() {
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(file("across.stl", acrossOneAnother())));
    const int crossings = driver.count(DefectKind::SelfIntersection);
    QVERIFY(crossings > 0);
    clickGroup(driver, DefectKind::SelfIntersection);
    QVERIFY(driver.settle());
    QVERIFY(driver.text("fixPreviewStatus").contains("no cut would separate"));
    QVERIFY(!driver.text("fixPreviewStatus").contains("Repair all"));  // without a hole it would do no more
    QVERIFY(!driver.find<QAbstractButton>("fixDefectButton")->isEnabled());
    QCOMPARE(driver.count(DefectKind::SelfIntersection), crossings);
    // Nor by "Repair all", whose card says why.
    driver.click("repairAllButton");
    QVERIFY(driver.settle());
    QCOMPARE(driver.count(DefectKind::SelfIntersection), crossings);
    QVERIFY2(driver.text("nextStepDetail").contains("no cut would separate"),
             qPrintable(driver.text("nextStepDetail")));
    QVERIFY(!driver.find<QAbstractButton>("repairAllButton")->isEnabled());
  }

  // The findings of a repair are known again after undo and redo, and after saving in numbers that keep the triangles.
  void whatIsKnownComesBack() {
    TriangleSoup soup = acrossOneAnother();
    TriangleSoup open = cube(1.0, {3.0, 0.0, 0.0});
    open.triangles.pop_back();
    append(soup, open);
    const QString path = m_folder.filePath("across.obj");
    QVERIFY(writeFileAtomically(path.toStdString(), writeObj(soup, NumberType::Float64)));
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(path));
    const int crossings = driver.count(DefectKind::SelfIntersection);
    QVERIFY(crossings > 0 && driver.count(DefectKind::Hole) == 1);
    driver.click("repairAllButton");
    const auto isKnown = [&] {
      return driver.settle() && driver.count(DefectKind::Hole) == 0 &&
             driver.count(DefectKind::SelfIntersection) == crossings &&
             driver.text("nextStepDetail").contains("no cut would separate") &&
             !driver.find<QAbstractButton>("repairAllButton")->isEnabled();
    };
    QTRY_VERIFY_WITH_TIMEOUT(isKnown(), kPatienceMs);
    driver.choose("undo");
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 1, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(driver.find<QAbstractButton>("repairAllButton")->isEnabled(), kPatienceMs);
    driver.choose("redo");
    QTRY_VERIFY_WITH_TIMEOUT(isKnown(), kPatienceMs);
    driver.choose("saveFileAs");
    QVERIFY(driver.enterFileName("saveDialog", m_folder.filePath("rounded.stl")) && driver.settle());
    QVERIFY(!driver.window().isWindowModified());
    QTRY_VERIFY_WITH_TIMEOUT(isKnown(), kPatienceMs);
  }

  // Two solids that overlap, with walls in one plane, become one.
  void wallsInOnePlane() {
    TriangleSoup soup = cube();
    append(soup, cube(1.0, {0.5, 0.25, 0.0}));
    QuickWindow& driver = m_window.cleared();
    QVERIFY(driver.open(file("planes.stl", soup)));
    QVERIFY(driver.count(DefectKind::SelfIntersection) > 0);
    clickGroup(driver, DefectKind::SelfIntersection);
    QVERIFY(driver.settle());
    driver.find<QAbstractButton>("fixDefectButton")->click();
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::SelfIntersection), 0, kPatienceMs);
    QVERIFY(driver.settle());
    QTRY_COMPARE_WITH_TIMEOUT(driver.text("nextStepTitle"), "Watertight.", kPatienceMs);
  }
};

HANDWHEEL_WINDOW_TEST(DefectFixesWindowTest)
#include "DefectFixesWindowTest.moc"

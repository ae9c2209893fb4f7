// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/MeshScript.h"

#include "HoleShapes.h"
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "ScriptWork.h"
#include "TestClass.h"
#include "ToolEvents.h"
#include "tools/mesh/BoundaryLoopText.h"
#include "tools/mesh/DecimateTool.h"
#include "tools/mesh/MakeFaceTool.h"
#include "tools/mesh/ManualMeshChanges.h"
#include "tools/mesh/Placement.h"
#include "tools/mesh/SelectTool.h"
#include "tools/mesh/TransformTool.h"
#include "tools/mesh/boundary/BoundaryTool.h"
#include "tools/mesh/repair/DefectFixes.h"
#include "tools/mesh/repair/HoleFixes.h"
#include "tools/mesh/sculpt/SculptTool.h"

#include <QTest>

using namespace handwheel;
using test::Kind;
using test::Work;

namespace {

std::string problemOf(const TriangleSoup& soup, std::string_view step) {
  const auto document = test::meshDocument(soup);
  const std::string before = test::bytesOf(*document);
  const auto done = applyScriptLine(*document, step);
  if (done) return done->changed ? "changed" : "nothing";
  if (test::bytesOf(*document) != before || document->history()->count() > 0) return "an error, but it changed";
  return done.error().arguments.at(0);
}

}  // namespace

class MeshScriptTest : public QObject {
  Q_OBJECT

 private slots:
  void placing();
  void standardPlacements();
  void deleting();
  void reversing();
  void orienting();
  void filling();
  void bridgesOfAFill();
  void keepingOpen();
  void keepingAnOuterEdgeOpen();
  void repairing();
  void mending();
  void backs();
  void decimating();
  void edges();
  void islands();
  void faces();
  void byNumberToo();
  void units();
  void undoneStepsAreLeftOut();
  void mistakes_data();
  void mistakes();
};

void MeshScriptTest::placing() {
  Work work(test::moved(test::icosphere(2), {100.1, -0.3, 7e3}));
  TransformTool tool(*work.document, work.services());
  tool.setSetting("move_x", -1.0 / 3.0);
  tool.setSetting("turn_y", 0.1);
  tool.setSetting("turn_z", 30.0 * kRadiansPerDegree);
  tool.setSetting("scale", 1.1);
  tool.setSetting("unit", 3.0);
  tool.perform("commit");
  QVERIFY2(work.step().starts_with("place --unit in --scale 1.1 --turn 0,5.72957795130823"), work.step().c_str());
  QVERIFY2(work.step().ends_with(",30 --move -0.3333333333333333,0,0"), work.step().c_str());
  QCOMPARE(work.check(), std::string());
}

// Undone, the turn on opening is a step; so is what mends it.
void MeshScriptTest::orienting() {
  TriangleSoup soup = test::icosphere(2);
  for (const Face f : {3u, 4u, 5u, 90u}) std::swap(soup.triangles[f][1], soup.triangles[f][2]);
  Work work(soup);
  QVERIFY(scriptLinesSince(*work.document).value().empty());
  work.document->history()->undo();
  QCOMPARE(scriptLinesSince(*work.document).value(), std::vector<std::string>{"orient 3-5,90"});
  QCOMPARE(work.check(0), std::string());
  const HistoryPoint asInFile = presentPoint(*work.document);
  QVERIFY(asInFile != HistoryPoint());
  work.services().commit(orientFix({4}));
  QCOMPARE(work.document->defects().inconsistentFaces, (std::vector<Face>{3, 5, 90}));
  work.services().commit(orientFix());
  QVERIFY(work.document->defects().inconsistentFaces.empty());
  QCOMPARE(scriptLinesSince(*work.document).value(), (std::vector<std::string>{"orient 3-5,90", "orient 4", "orient"}));
  QCOMPARE(scriptLinesSince(*work.document, asInFile).value(), (std::vector<std::string>{"orient 4", "orient"}));
  QCOMPARE(work.check(2), std::string());

  Work forward(soup);
  forward.services().commit(deleteChange({7}, "Delete faces"));
  QCOMPARE(scriptLinesSince(*forward.document).value(), std::vector<std::string>{"delete 7"});
  QVERIFY(!scriptLinesSince(*forward.document, asInFile));
  QCOMPARE(forward.check(1), std::string());
}

void MeshScriptTest::standardPlacements() {
  for (const char* alignment : {"flat", "axes", "centre", "corner"}) {
    Work work(test::moved(test::cylinder(24, 3, 2.0, 7.0, true), {3, -2, 11}));
    TransformTool(*work.document, work.services()).perform(alignment);
    QCOMPARE(work.step(), std::string(alignment));
    QCOMPARE(work.check(), std::string());
  }
}

void MeshScriptTest::deleting() {
  Work work(test::icosphere(3));
  MeshSelection selection;
  for (const Face f : {3u, 4u, 5u, 9u, 100u, 101u}) selection.faces.add(f);
  SelectTool tool(*work.document, work.services(), selection);
  tool.perform("delete");
  QCOMPARE(work.step(), std::string("delete 3-5,9,100-101"));
  QCOMPARE(work.check(), std::string());
}

// The shell of the selected triangles is reversed, and what is inside out then is turned outward again.
void MeshScriptTest::reversing() {
  TriangleSoup two = test::cube(1.0);
  test::append(two, test::cube(1.0, {5, 0, 0}));
  Work work(two);
  MeshSelection selection;
  selection.faces.add(14);
  SelectTool tool(*work.document, work.services(), selection);
  tool.perform("reverse");
  QCOMPARE(work.step(), std::string("reverse 14"));
  QCOMPARE(work.document->defects().insideOut.size(), std::size_t{1});
  QVERIFY(!work.document->defects().state({}).oriented);
  QCOMPARE(work.document->defects().insideOut[0].front(), Face{12});
  commitChange(*work.document, insideOutFix());
  QCOMPARE(work.step(1), std::string("reverse"));
  QVERIFY(work.document->defects().state({}).isSound());
  QCOMPARE(work.check(2), std::string());
}

void MeshScriptTest::filling() {
  for (const FillMethod method : {FillMethod::Fair, FillMethod::Refined, FillMethod::Ear, FillMethod::Minimal,
                                  FillMethod::Area, FillMethod::Dihedral, FillMethod::Crease, FillMethod::Flat}) {
    Work work(test::sphereWithHoles(3, 3, 0.3));
    FillOptions options;
    options.method = method;
    options.density = 0.7;
    options.continuity = Continuity::Curvature;
    options.ears.length = 0.1;
    QCOMPARE(work.fill(1, options), FillFailure::None);
    QCOMPARE(work.fill(1), FillFailure::None);
    QCOMPARE(work.fill(0, options), FillFailure::None);
    QCOMPARE(work.check(3), std::string());
  }
}

void MeshScriptTest::bridgesOfAFill() {
  Work work(test::sphereWithoutCap(4, 0.5));
  const auto n = static_cast<std::uint32_t>(work.document->defects().loops.at(0).halfEdges.size());
  FillOptions options;
  options.method = FillMethod::Minimal;
  options.bridges = {{0, n / 2}};
  QCOMPARE(work.fill(0, options), FillFailure::None);
  QVERIFY(QString::fromStdString(work.step()).contains(QString("--bridges 0:%1").arg(n / 2)));
  QCOMPARE(work.check(), std::string());
}

void MeshScriptTest::keepingOpen() {
  Work work(test::sphereWithHoles(3, 3, 0.3));
  const std::vector<BoundaryLoop> loops = work.document->defects().loops;
  work.document->setKeptOpen(loops[0], true);
  work.document->setKeptOpen(loops[2], true);
  work.document->setKeptOpen(loops[0], false);
  QCOMPARE(work.step(2), "no-longer-open v" + std::to_string(work.key(0)));
  QCOMPARE(work.check(3), std::string());
}

// The mark holds, whatever a repair may do with outer edges: without it this shallow bowl gets a lid.
void MeshScriptTest::keepingAnOuterEdgeOpen() {
  TriangleSoup bowl = test::disc(24, 5);
  for (Vec3& p : bowl.points) p.z() = 1e-3 * (p.x() * p.x() + p.y() * p.y());
  for (const bool isMarked : {false, true}) {
    Work work(bowl);
    QVERIFY(work.document->defects().loops.at(0).isSheetBoundary);
    if (isMarked) QVERIFY(applyScriptLine(*work.document, "keep-open 0"));
    QVERIFY(applyScriptLine(*work.document, "repair --open-sheets fill --fill ear"));
    QCOMPARE(work.document->defects().loops.size(), std::size_t(isMarked));
  }
}

void MeshScriptTest::repairing() {
  for (const SheetHandling rims : {SheetHandling::Keep, SheetHandling::Thicken, SheetHandling::Fill}) {
    TriangleSoup soup = test::sphereWithHoles(3, 3, 0.3);
    test::append(soup, test::moved(test::disc(12, 3), {5, 0, 0}));
    test::append(soup, test::cube(1e-3, {2, 0, 0}));
    soup.triangles.push_back(soup.triangles[3]);
    Work work(soup);
    work.document->setKeptOpen(work.document->defects().loops[1], true);
    RepairOptions options;
    options.sheets = rims;
    options.removeDebris = rims == SheetHandling::Thicken;
    options.nearWeld = 1e-4;
    options.maxEdges = 1000;
    options.cutCrossings = true;
    options.replaceFoldedRegions = false;
    work.repairAll(options);
    QCOMPARE(work.check(2), std::string());
  }
}

void MeshScriptTest::mending() {
  TriangleSoup soup = test::cube();
  test::append(soup, test::cube(1.0, {0.41, 0.27, 0.33}));
  test::append(soup, test::cube(1.0, {5, 0, 0}));
  test::append(soup, test::cube(1.0, {6, 1, 0}));  // touches the one before along an edge
  test::append(soup, test::moved(test::kleinBottle(20, 8), {20, 0, 0}));
  test::append(soup, test::moved(test::cube(1e-4), {40, 0, 0}));
  test::append(soup, test::moved(test::cube(1e-4), {41, 0, 0}));
  soup.triangles.push_back(soup.triangles[30]);
  test::addNeedles(soup, 26, 0, {0.5});
  Work work(soup);
  const auto commit = work.services().commit;
  const NumberType numbers = work.document->fileNumbers();
  commit(degenerateFix());
  commit(duplicateFix());
  commit(nonManifoldFix(numbers));
  commit(intersectionFix(numbers, *findSelfIntersections(work.document->mesh())));
  FillOptions options;
  options.numbers = numbers;
  commit(nonOrientableFix(options));
  const auto& parts = work.document->defects().components;
  const auto debris = std::find_if(parts.begin(), parts.end(), [](const Component& part) { return part.debris; });
  QVERIFY(debris != parts.end());
  commit(debrisFix({debris->faces.front()}));
  commit(allDebrisFix());
  QCOMPARE(work.check(7), std::string());

  TriangleSoup loose =
      test::unshared(test::grid(5, 5, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0.0); }));
  for (Vec3& p : loose.points)
    if (&p - loose.points.data() < 24 && p.x() == 1.0) p.x() += 1e-6;
  Work torn(loose);
  torn.services().commit(nearVertexFix(1e-4));
  QCOMPARE(torn.check(), std::string());
}

void MeshScriptTest::backs() {
  Work sheet(test::disc(16, 4));
  FillOptions options;
  options.numbers = sheet.document->fileNumbers();
  sheet.services().commit(thickenFix({sheet.key(0)}, options));
  QCOMPARE(sheet.check(), std::string());

  TriangleSoup soup = test::sphereWithoutCap(3, 0.5);
  test::append(soup, test::moved(test::cylinder(12, 2, 0.1, 2.0, true), {0.03, 0.02, -0.2}));
  Work rod(soup);
  rod.services().commit(cutAndCloseFix(rod.key(0), options));
  QCOMPARE(rod.check(), std::string());
}

void MeshScriptTest::decimating() {
  Work work(test::bumpySphere(4));
  DecimateTool tool(*work.document, work.services());
  tool.setSetting("faces", 700.0);
  tool.setSetting("has_creases", true);
  tool.perform("commit");
  QVERIFY2(work.step().starts_with("decimate --faces 700 --keep-borders --keep-creases 29.79"), work.step().c_str());
  tool.setSetting("goal", 1.0);
  tool.setSetting("error", 0.1);
  tool.setSetting("has_creases", false);
  tool.perform("commit");
  QCOMPARE(work.step(1), std::string("decimate --error 0.1 --keep-borders --no-crossings"));
  QCOMPARE(work.check(2), std::string());
}

void MeshScriptTest::edges() {
  Work work(test::plateWithHole());
  BoundaryTool tool(*work.document, work.services());
  connect(work.document.get(), &Document::changed, [&tool] { tool.documentChanged(); });
  const auto drag = [&tool](const Vec3& from, const Vec3& to, Modifiers modifiers = {}) {
    tool.pointer(test::above(Kind::Press, from.x(), from.y(), modifiers));
    tool.pointer(test::above(Kind::Drag, to.x(), to.y(), modifiers));
    tool.pointer(test::above(Kind::Release, to.x(), to.y(), modifiers));
  };
  drag(Vec3(-2, 0, 0), Vec3(-1.48, 0.3, 0));
  QVERIFY2(work.step().starts_with("pull "), work.step().c_str());
  drag(Vec3(0, -2, 0), Vec3(0, 1.95, 0), test::kShift);
  QVERIFY2(work.step(1).starts_with("bridge "), work.step(1).c_str());
  drag(Vec3(2, 0, 0), Vec3(2, 1, 0));
  QVERIFY2(work.step(2).starts_with("join "), work.step(2).c_str());
  tool.setSetting("wavelength", 12.5);
  tool.setSetting("evenly", false);
  tool.perform("smooth");
  tool.perform("commit");
  QVERIFY2(work.step(3).ends_with(" --wavelength 12.5 --uneven --numbers single"), work.step(3).c_str());
  QCOMPARE(work.check(4), std::string());
}

void MeshScriptTest::islands() {
  for (const char* action : {"islands", "peninsulas"}) {
    const bool isIsland = std::string_view(action) == "islands";
    Work work(isIsland ? test::plateWithIsland() : test::plateWithTongue());
    BoundaryTool tool(*work.document, work.services());
    tool.pointer(test::above(Kind::Press, isIsland ? -4 : 4, 0));
    tool.perform(action);
    tool.perform("commit");
    QVERIFY2(work.step().starts_with("delete "), work.step().c_str());
    QCOMPARE(work.check(), std::string());
  }
}

void MeshScriptTest::faces() {
  Work work(test::plateWithHole());
  MakeFaceTool tool(*work.document, work.services());
  for (const auto& [x, y] : {std::pair(-2, -1), std::pair(-1, -2), std::pair(-2, -2)})
    tool.pointer(test::above(Kind::Press, x, y));
  QVERIFY2(work.step().starts_with("face "), work.step().c_str());
  QCOMPARE(work.check(), std::string());
}

// People count loops as "inspect" does; what is kept of the step is the same.
void MeshScriptTest::byNumberToo() {
  Work work(test::sphereWithHoles(3, 3, 0.3));
  const Vertex key = work.key(2);
  QVERIFY(applyScriptLine(*work.document, "  fill\t2   --fill=ear ").hasValue());
  QCOMPARE(work.step(), "fill v" + std::to_string(key) + " --fill ear --numbers single");
  QVERIFY(applyScriptLine(*work.document, "keep-open 0,1").hasValue());
  QCOMPARE(work.check(3), std::string());
}

void MeshScriptTest::units() {
  Work work(test::cube());
  QVERIFY(applyScriptLine(*work.document, "unit in").value().changed);
  QVERIFY(!applyScriptLine(*work.document, "unit in").value().changed);
  QCOMPARE(work.document->displayUnit(), LengthUnit::Inch);
}

void MeshScriptTest::undoneStepsAreLeftOut() {
  Work work(test::sphereWithHoles(3, 3, 0.3));
  work.fill(0);
  const HistoryPoint one = presentPoint(*work.document);
  work.fill(0);
  const HistoryPoint two = presentPoint(*work.document);
  work.document->history()->undo();
  QCOMPARE(scriptLinesSince(*work.document)->size(), std::size_t(1));
  QVERIFY(scriptLinesSince(*work.document, one)->empty());
  QVERIFY(!scriptLinesSince(*work.document, two));  // it is before that
  QCOMPARE(work.check(), std::string());
  work.document->history()->redo();
  QCOMPARE(work.check(2), std::string());
  work.document->commit("Nameless", inspected(HalfEdgeMesh()));
  QVERIFY(!scriptLinesSince(*work.document));
  work.document->history()->undo();
  QCOMPARE(work.check(2), std::string());
  work.document->history()->undo();
  work.fill(1);
  QVERIFY(scriptLinesSince(*work.document, one));
  QVERIFY(!scriptLinesSince(*work.document, two));  // the second one is another now
}

void MeshScriptTest::mistakes_data() {
  QTest::addColumn<QString>("step");
  QTest::addColumn<QString>("problem");
  const auto row = [](const char* step, const char* problem) { QTest::newRow(step) << step << problem; };
  row("", "it is empty");
  row("fly 3", "there is no step 'fly'");
  row("delete", "a list of triangles is missing");
  row("delete 3,x", "'x' is not the number of a triangle");
  row("delete 9-3", "'9-3' runs backwards");
  row("delete 0-99999999", "there is no triangle 99999999, only 0 to 319");
  row("delete 4294967296", "'4294967296' is not the number of a triangle");
  row("delete 1 2", "'2' is too much");
  row("fill 7", "there is no loop 7, nor any");
  row("fill v3", "there is no loop with the smallest vertex 3");
  row("repair --fill best", "--fill takes fair, refined, ear, minimal, area, dihedral, ridge or flat, not 'best'");
  row("repair --remove-debris yes", "--remove-debris takes no value");
  row("repair --colour red", "repair has no option '--colour'");
  row("repair --open-sheets off", "--open-sheets takes keep, back or fill, not 'off'");
  row("repair --near-weld nan", "--near-weld takes a number from 0 to 1, not 'nan'");
  row("place --scale 0", "--scale takes a number from 1e-09 to 1000000000, not '0'");
  row("place --move 1,2", "--move takes X,Y,Z, each a length from -1000000000 to 1000000000 mm, not '1,2'");
  row("place --move 1,2,inf", "--move takes X,Y,Z, each a length from -1000000000 to 1000000000 mm, not '1,2,inf'");
  row("place --turn 1,2,400", "--turn takes A,B,C, each an angle from -360 to 360 degrees, not '1,2,400'");
  row("place --unit ft", "--unit takes mm, cm, m, in or um, not 'ft'");
  row("place --scale 2 --scale 3", "--scale is given twice");
  row("decimate --method quadric --error 1",
      "--method quadric does not bound the distance: give --faces N alone, or use --method bounded");
  row("decimate --method quadric --faces 4 --no-crossings",
      "--method quadric does not check for self-intersections: omit --no-crossings, or use --method bounded");
  row("smooth-noise --method laplace --borders", "only --method bilateral moves open edges: omit --borders");
  row("smooth-noise --method bending --angle 30", "--angle needs --method bilateral");
  row("smooth-noise --passes 3", "--passes needs --method laplace or bending");
  row("decimate", "give a target: --faces N, --error MM or both");
  row("stroke paint 0:0,0,0 --radius 1", "the brushes are drag, smooth, inflate and flatten");
  row("stroke drag 0:0,0,0 --radius 1", "--by X,Y,Z is missing");
  row("stroke smooth 0 --radius 1", "a place is TRIANGLE:X,Y,Z");
  row("stroke smooth 0:0,0,0 --radius 1 --patch 3 --finest 2", "the patch has not been subdivided that often");
  row("subdivide", "--patch TRIANGLES is missing");
  row("refine", "--patch TRIANGLES is missing");
  row("level-back --patch 3", "the patch has one level only");
  row("unit ft", "the units are mm, cm, m and in");
  row("bridge 1", "two half-edges are required: H,H");
  row("bridge 1,2", "nothing");
  row("face 0,1,2", "nothing");
  row("pull 0 1,1,1", "nothing");  // triangles would turn over
}
void MeshScriptTest::mistakes() {
  QFETCH(QString, step);
  QFETCH(QString, problem);
  QCOMPARE(QString::fromStdString(problemOf(test::icosphere(2), step.toStdString())), problem);
}

HANDWHEEL_TEST(MeshScriptTest)
#include "MeshScriptTest.moc"

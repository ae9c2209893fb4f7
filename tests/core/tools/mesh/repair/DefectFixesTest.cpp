// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/repair/DefectFixes.h"
#include "tools/mesh/repair/HoleFixes.h"

#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/defects/Defects.h"
#include "mesh/repair/SheetThickening.h"
#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"
#include "mesh/structure/PositionKey.h"

#include <QTest>

using namespace handwheel;

namespace {

constexpr NumberType kNumbers = NumberType::Float64;

// Applies a change to a document like a tool, with an undo and a redo.
void make(MeshDocument& document, const MeshChange& change) {
  const HalfEdgeMesh before = document.mesh();
  const std::uint64_t revision = document.revision();
  immediateServices(document).commit(change);
  QCOMPARE(validate(document.mesh()), std::string());
  if (document.revision() == revision) return;  // nothing was changed
  const HalfEdgeMesh after = document.mesh();
  document.history()->undo();
  QVERIFY(test::sameMesh(document.mesh(), before));
  document.history()->redo();
  QVERIFY(test::sameMesh(document.mesh(), after));
}

std::unique_ptr<MeshDocument> open(const TriangleSoup& soup) {
  return test::meshDocument(soup, "/scans/part.stl", kNumbers);
}

std::vector<Vertex> keysOf(const MeshDocument& document) {
  std::vector<Vertex> keys;
  for (const BoundaryLoop& loop : document.defects().loops) keys.push_back(keyOf(document.mesh(), loop));
  return keys;
}

}  // namespace

class DefectFixesTest : public QObject {
  Q_OBJECT

 private slots:
  void withoutArea();
  void duplicates();
  void nearVertices();
  void onlyOnePair();
  void eachPairOfATear();
  void touchingCubes();
  void oneSide();
  void crossings();
  void debris();
  void backOfASheet();
  void thicknessOfABack();
  void saysWhyThereIsNoBack();
  void saysWhichSheetsStayOpen();
  void aRodInTheHole();
  void nothingToMend();
  void saysWhatIsTooMuch();
};

void DefectFixesTest::withoutArea() {
  TriangleSoup soup = test::cube();
  test::addNeedles(soup, 0, 0, {0.5});
  const auto document = open(soup);
  QVERIFY(!document->defects().degenerateFaces.empty());
  make(*document, degenerateFix());
  QVERIFY(document->defects().degenerateFaces.empty());
  QVERIFY(test::countEdges(document->mesh()).sound());
}

void DefectFixesTest::oneSide() {
  for (const TriangleSoup& soup : {test::sphereWithCrossCap(2), test::kleinBottle(20, 8)}) {
    const auto document = open(soup);
    QVERIFY(!document->defects().nonOrientableEdges.empty());
    make(*document, nonOrientableFix({}));
    QVERIFY(document->defects().nonOrientableEdges.empty());
    QVERIFY(test::countEdges(document->mesh()).sound());
    document->history()->undo();
    QVERIFY(!document->defects().nonOrientableEdges.empty());
  }
}

void DefectFixesTest::duplicates() {
  TriangleSoup soup = test::cube();
  soup.triangles.push_back(soup.triangles[3]);
  const auto document = open(soup);
  QCOMPARE(document->defects().duplicateFaces.size(), std::size_t(1));
  make(*document, duplicateFix());
  QVERIFY(document->defects().duplicateFaces.empty());
  QVERIFY(test::countEdges(document->mesh()).sound());
}

// A cube whose lid the file has rounded away from it at two corners.
TriangleSoup looseLid(double shift) {
  TriangleSoup soup = test::unshared(test::cube());
  int moved = 0;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    bool isLid = true;
    for (const std::uint32_t v : soup.triangles[t]) isLid = isLid && soup.points[v].z() == 1.0;
    for (const std::uint32_t v : soup.triangles[t]) {
      Vec3& p = soup.points[v];
      if (!isLid || p.y() != 0.0) continue;
      p.y() -= shift;
      ++moved;
    }
  }
  Q_ASSERT(moved > 0);
  return soup;
}

void DefectFixesTest::nearVertices() {
  const auto document = open(looseLid(1e-9));
  QCOMPARE(document->defects().nearVertices.size(), std::size_t(2));
  make(*document, nearVertexFix(tolerance::kNearWeld));
  QVERIFY(document->defects().nearVertices.empty());
  QVERIFY(test::countEdges(document->mesh()).sound());
}

void DefectFixesTest::onlyOnePair() {
  const auto document = open(looseLid(1e-9));
  const auto pairs = document->defects().nearVertices;
  make(*document, nearVertexFix(tolerance::kNearWeld, {pairs[1]}));
  QCOMPARE(document->defects().nearVertices.size(), std::size_t(1));
  QVERIFY(document->mesh().position(pairs[0].first) != document->mesh().position(pairs[0].second));
}

// A tear closes at two pairs only: the row of each closes an edge, together with its neighbour.
void DefectFixesTest::eachPairOfATear() {
  const TriangleSoup sheet =
      test::grid(5, 5, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0); });
  TriangleSoup torn = sheet;
  test::append(torn, test::moved(sheet, {4.0 + 1e-6, 0, 0}));
  for (std::size_t row = 0; row < 5; ++row) {
    const auto document = open(torn);
    const auto pairs = document->defects().nearVertices;
    QCOMPARE(pairs.size(), std::size_t(5));
    const std::size_t border = test::countBorder(document->mesh());
    make(*document, nearVertexFix(tolerance::kNearWeld, {pairs[row]}));
    QCOMPARE(test::countBorder(document->mesh()), border - 2);
    QCOMPARE(document->defects().nearVertices.size(), std::size_t(3));
  }
}

// Along an edge: four triangles meet there in the file.
void DefectFixesTest::touchingCubes() {
  TriangleSoup soup = test::cube();
  test::append(soup, test::cube(1.0, {1, 1, 0}));
  const auto document = open(soup);
  QCOMPARE(document->defects().nonManifoldEdges.size(), std::size_t(1));
  make(*document, nonManifoldFix(kNumbers));
  QVERIFY(test::countEdges(document->mesh()).sound());
  QCOMPARE(findSelfIntersections(document->mesh())->size(), std::size_t(0));
}

void DefectFixesTest::crossings() {
  TriangleSoup soup = test::cube();
  test::append(soup, test::cube(1.0, {0.41, 0.27, 0.33}));
  const auto document = open(soup);
  make(*document, intersectionFix(kNumbers, *findSelfIntersections(document->mesh())));
  QCOMPARE(findSelfIntersections(document->mesh())->size(), std::size_t(0));
  QVERIFY(test::countEdges(document->mesh()).sound());
}

void DefectFixesTest::debris() {
  TriangleSoup soup = test::icosphere(3);
  const std::size_t faces = soup.triangles.size();
  for (double x : {2.0, 3.0}) test::append(soup, test::cube(1e-3, {x, 0, 0}));
  const auto document = open(soup);
  make(*document, debrisFix({static_cast<Face>(faces)}));
  QCOMPARE(document->mesh().liveFaceCount(), faces + 12);
  for (Face f = 0; f < faces; ++f) QVERIFY(document->mesh().isLive(f));
}

// A flat square of side 1: the back lies behind it by the thousandth of its diagonal that backs have, so that is the
// volume.
void DefectFixesTest::backOfASheet() {
  const auto document = open(
      test::grid(5, 5, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i / 4.0, j / 4.0, 0.0); }));
  make(*document, thickenFix(keysOf(*document), {}));
  QVERIFY(test::countEdges(document->mesh()).sound());
  QVERIFY(document->defects().loops.empty());
  const double volume = test::volume(document->mesh().compact().soup), thickness = 1e-3 * M_SQRT2;
  QVERIFY(std::abs(volume - thickness) < 1e-6 * thickness);
}

void DefectFixesTest::thicknessOfABack() {
  const auto document = open(
      test::grid(9, 9, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i / 8.0, j / 8.0, 0.0); }));
  const double thickness = 0.02;
  const MeshChange change = thickenFix(keysOf(*document), {}, thickness);
  QVERIFY(QString::fromStdString(change.step).contains(" --thickness 0.02"));
  make(*document, change);
  const Vec3 size = boundsOf(document->mesh()).sizes();
  QVERIFY(std::abs(size.z() - thickness) < 1e-12);
  QVERIFY(std::abs(change.sheets->thickness.least - size.z()) < 1e-12);
  QVERIFY(std::abs(change.sheets->thickness.largest - size.z()) < 1e-12);
  const double volume = test::volume(document->mesh().compact().soup);
  QVERIFY(std::abs(volume - thickness) < 1e-6 * thickness);
}

// The one reason that is true.
void DefectFixesTest::saysWhyThereIsNoBack() {
  const auto document = open(test::disc(12, 4));
  FillOptions options;
  options.keptCorners = {positionKey(document->mesh().position(keysOf(*document).at(0)))};
  const MeshChange kept = thickenFix(keysOf(*document), options);
  make(*document, kept);
  QCOMPARE(reasonOf(kept), "a boundary of the sheet is marked to stay open, and a thin body has none");
  QCOMPARE(document->defects().loops.size(), std::size_t(1));
  make(*document, thickenFix(keysOf(*document), {}));
  QVERIFY(document->defects().loops.empty());

  FillOptions single;
  single.numbers = NumberType::Float32;
  const auto far = open(test::moved(test::disc(12, 4), {1e5, 1e5, 1e5}));
  const MeshChange thin = thickenFix(keysOf(*far), single, 1e-3);
  make(*far, thin);
  QCOMPARE(reasonOf(thin), "the numbers of the file cannot show such a thickness");
  QCOMPARE(far->defects().loops.size(), std::size_t(1));
}

// One of two sheets has a corner that must stay open.
void DefectFixesTest::saysWhichSheetsStayOpen() {
  TriangleSoup soup = test::disc(12, 4);
  test::append(soup, test::moved(soup, {9, 0, 0}));
  const auto document = open(soup);
  FillOptions options;
  options.keptCorners = {positionKey(document->mesh().position(keysOf(*document).at(0)))};
  const MeshChange change = thickenFix(keysOf(*document), options);
  make(*document, change);
  QCOMPARE(document->defects().loops.size(), std::size_t(1));
  QCOMPARE(change.sheets->thickened, std::size_t(1));
  QCOMPARE(change.sheets->left, (std::map<FillFailure, std::size_t>{{FillFailure::SheetKeptOpen, 1}}));
}

void DefectFixesTest::aRodInTheHole() {
  TriangleSoup soup = test::sphereWithoutCap(3, 0.5);
  test::append(soup, test::moved(test::cylinder(12, 2, 0.1, 2.0, true), {0.03, 0.02, -0.2}));
  const auto document = open(soup);
  QCOMPARE(document->defects().loops.size(), std::size_t(1));
  FillOptions options;
  options.numbers = kNumbers;
  make(*document, cutAndCloseFix(keysOf(*document)[0], options));
  QVERIFY(document->defects().loops.empty());
  QCOMPARE(findSelfIntersections(document->mesh())->size(), std::size_t(0));
}

void DefectFixesTest::nothingToMend() {
  const auto document = open(test::cube());
  const std::uint64_t revision = document->revision();
  for (const MeshChange& change :
       {degenerateFix(), duplicateFix(), nearVertexFix(tolerance::kNearWeld), nonManifoldFix(kNumbers),
        intersectionFix(kNumbers, {}), intersectionFix(kNumbers, {{0, 4'000'000'000}}), debrisFix({}),
        thickenFix({}, {}), cutAndCloseFix(0, {})}) {
    make(*document, change);
    QCOMPARE(document->revision(), revision);
  }
}

void DefectFixesTest::saysWhatIsTooMuch() {
  TriangleSoup soup = test::twoConesSharingAnEdge(200);
  test::append(soup, test::moved(test::sphereWithCrossCap(3), {9, 0, 0}));
  test::append(soup, test::moved(test::icosphere(3), {9.5, 0, 0}));
  const HalfEdgeMesh before = buildMesh(soup).mesh;
  const auto crossings = *findSelfIntersections(before);
  QVERIFY(!crossings.empty());
  for (const MeshChange& change :
       {nonManifoldFix(kNumbers), nonOrientableFix({}), intersectionFix(kNumbers, crossings)}) {
    QCOMPARE(reasonOf(change), change.reason);
    HalfEdgeMesh mesh = before;
    WorkBudget little(1'000);
    change.apply(mesh, Progress().within(little));
    QVERIFY(little.counted() < 10'000);
    QCOMPARE(reasonOf(change), "it would take too long for a mesh of this size");
    change.apply(mesh, Progress());
    QCOMPARE(reasonOf(change), change.reason);
  }
}

HANDWHEEL_TEST(DefectFixesTest)
#include "DefectFixesTest.moc"

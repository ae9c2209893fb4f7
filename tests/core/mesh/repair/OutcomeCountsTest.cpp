// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/OutcomeCounts.h"

#include "HoleShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;

namespace {

// A torus whose triangles can be taken out and put back. The faces that stay keep their numbers.
class CutTorus {
 public:
  CutTorus() : m_mesh(buildMesh(test::torus(24, 12)).mesh) {}

  const HalfEdgeMesh& mesh() const { return m_mesh; }

  void open(std::uint32_t firstI, std::uint32_t endI, std::uint32_t firstJ, std::uint32_t endJ) {
    forEach(firstI, endI, firstJ, endJ, [&](Face f) {
      m_corners[f] = m_mesh.triangle(f);
      m_mesh.removeFace(f);
    });
    relink(m_mesh);
  }

  void close(std::uint32_t firstI, std::uint32_t endI, std::uint32_t firstJ, std::uint32_t endJ) {
    forEach(firstI, endI, firstJ, endJ, [&](Face f) { m_mesh.addFace(m_corners.at(f)); });
    relink(m_mesh);
  }

 private:
  template <class Change>
  static void forEach(std::uint32_t firstI, std::uint32_t endI, std::uint32_t firstJ, std::uint32_t endJ,
                      Change change) {
    for (std::uint32_t i = firstI; i < endI; ++i)
      for (std::uint32_t j = firstJ; j < endJ; ++j)
        for (const std::size_t t : test::torusCell(i, j)) change(static_cast<Face>(t));
  }

  HalfEdgeMesh m_mesh;
  std::map<Face, Triangle> m_corners;
};

std::size_t loopsOf(const HalfEdgeMesh& mesh) {
  return findBoundaryLoops(mesh).size();
}

}  // namespace

// Counts of loops are not numbers before minus numbers after.
class OutcomeCountsTest : public QObject {
  Q_OBJECT

 private slots:
  void oneClosesAndOneSplits();
  void joinedIsNotClosed();
  void newOpenings();
  void goneWithItsFaces();
  void aRepairThatSplits();
  void whatASheetsBoundaryTookIn();
};

void OutcomeCountsTest::oneClosesAndOneSplits() {
  CutTorus torus;
  torus.open(2, 9, 2, 5);
  torus.open(15, 16, 7, 8);
  const HalfEdgeMesh before = torus.mesh();
  torus.close(15, 16, 7, 8);
  torus.close(5, 6, 2, 5);  // a bridge
  QCOMPARE(validate(torus.mesh()), std::string());
  QCOMPARE(loopsOf(before), std::size_t{2});
  QCOMPARE(loopsOf(torus.mesh()), std::size_t{2});
  const LoopCounts counts = countClosed(before, torus.mesh());
  QCOMPARE(counts,
           (LoopCounts{.holes = {.all = 2, .closed = 1}, .sheetBoundaries = {}, .newOpenings = 0, .pieces = {}}));
}

void OutcomeCountsTest::joinedIsNotClosed() {
  CutTorus torus;
  torus.open(2, 5, 2, 5);
  torus.open(6, 9, 2, 5);
  const HalfEdgeMesh before = torus.mesh();
  torus.open(5, 6, 2, 5);
  QCOMPARE(loopsOf(before), std::size_t{2});
  QCOMPARE(loopsOf(torus.mesh()), std::size_t{1});
  const LoopCounts counts = countClosed(before, torus.mesh());
  QCOMPARE(counts.holes.all, std::size_t{2});
  QCOMPARE(counts.holes.closed + counts.holes.removed, std::size_t{0});
  QCOMPARE(counts.newOpenings, std::size_t{0});
}

void OutcomeCountsTest::newOpenings() {
  CutTorus torus;
  torus.open(2, 5, 2, 5);
  const HalfEdgeMesh before = torus.mesh();
  torus.close(2, 5, 2, 5);
  torus.open(12, 13, 2, 3);
  torus.open(18, 19, 2, 3);
  const LoopCounts counts = countClosed(before, torus.mesh());
  QCOMPARE(counts.holes, (OutcomeCounts{.all = 1, .closed = 1}));
  QCOMPARE(counts.newOpenings, std::size_t{2});
}

void OutcomeCountsTest::goneWithItsFaces() {
  TriangleSoup soup = test::torus(24, 12);
  const std::size_t sheet = soup.triangles.size();
  test::append(soup, test::moved(test::disc(12, 3), {9, 0, 0}));
  const HalfEdgeMesh before = buildMesh(soup).mesh;
  HalfEdgeMesh after = before;
  for (Face f = static_cast<Face>(sheet); f < before.faceSlots(); ++f) after.removeFace(f);
  const LoopCounts counts = countClosed(before, after);
  QCOMPARE(counts.holes, OutcomeCounts());
  QCOMPARE(counts.sheetBoundaries, (OutcomeCounts{.all = 1, .removed = 1}));
}

// Stitching closes one hole and splits the other, which has too many edges to be filled.
void OutcomeCountsTest::aRepairThatSplits() {
  HalfEdgeMesh mesh = buildMesh(test::torusWithSlits(1e-5)).mesh;
  QCOMPARE(loopsOf(mesh), std::size_t{2});
  RepairOptions options;
  options.maxEdges = 10;
  const RepairReport report = repair(mesh, options);
  QCOMPARE(validate(mesh), std::string());
  QCOMPARE(loopsOf(mesh), std::size_t{2});  // with 12 edges each
  QCOMPARE(
      countOutcomes(report),
      (LoopCounts{.holes = {.all = 2, .closed = 1, .kept = 1}, .sheetBoundaries = {}, .newOpenings = 0, .pieces = {}}));
  QCOMPARE(report.openLoops.size(), std::size_t{2});
  std::set<Vertex> keys;
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh)) keys.insert(keyOf(mesh, loop));
  for (const OpenLoop& loop : report.openLoops) {
    QVERIFY(keys.erase(loop.key) == 1);
    QVERIFY(loop.outcome == LoopOutcome::KeptOpen);
    QVERIFY(loop.reason == FillFailure::TooLong);
  }
  // Without that limit both pieces are filled, and they are one hole that was filled.
  HalfEdgeMesh closed = buildMesh(test::torusWithSlits(1e-5)).mesh;
  QCOMPARE(countOutcomes(repair(closed, {})).holes, (OutcomeCounts{.all = 2, .closed = 2}));
  QCOMPARE(loopsOf(closed), std::size_t{0});
}

// Nobody asked for these to be kept open.
void OutcomeCountsTest::whatASheetsBoundaryTookIn() {
  RepairReport report;
  report.loops.resize(4);
  const std::pair<LoopOutcome, FillFailure> results[] = {{LoopOutcome::Filled, FillFailure::None},
                                                         {LoopOutcome::KeptOpen, FillFailure::WasSheetBoundary},
                                                         {LoopOutcome::KeptOpen, FillFailure::KeptOpen},
                                                         {LoopOutcome::KeptOpen, FillFailure::SheetBoundary}};
  for (int i = 0; i < 4; ++i) {
    LoopResult& loop = report.loops[static_cast<std::size_t>(i)];
    loop.id = i;
    loop.outcome = results[i].first;
    loop.reason = results[i].second;
    loop.isSheetBoundary = loop.reason == FillFailure::SheetBoundary;
  }
  const LoopCounts counts = countOutcomes(report);
  QCOMPARE(counts.holes, (OutcomeCounts{.all = 3, .closed = 1, .kept = 1, .joined = 1}));
  QCOMPARE(counts.sheetBoundaries, (OutcomeCounts{.all = 1, .kept = 1}));
}

HANDWHEEL_TEST(OutcomeCountsTest)
#include "OutcomeCountsTest.moc"

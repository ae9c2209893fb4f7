// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CreasedShapes.h"
#include "ExtremeRows.h"
#include "MeshChecks.h"
#include "TestClass.h"
#include "mesh/holes/HoleDecomposition.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/holes/PatchStatistics.h"
#include "mesh/structure/MeshValidator.h"

using namespace handwheel;

// Every method to fill a hole, and the cutting of long loops into pieces, on every extreme mesh.
class FillingExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void patches_data() { test::everyMesh(50'000); }
  void patches();
  void leastOfAll_data() { placeRows(); }
  void leastOfAll();
  void curvatureOfBalls_data() { placeRows(); }
  void curvatureOfBalls();
  void creasesOfCubes_data() { placeRows(); }
  void creasesOfCubes();
  void sizeChangesNoPatch_data();
  void sizeChangesNoPatch();
  void bridges_data() { test::everyMesh(50'000); }
  void bridges();
  void longLoops_data() { placeRows(); }
  void longLoops();

 private:
  static void placeRows();
};

namespace {

constexpr std::size_t kMostLoops = 4;          // largest number of loops of a mesh
constexpr std::size_t kMostFacesByPair = 500;  // all pairs of faces are looked at

FillOptions only(FillMethod method, Continuity continuity = Continuity::Tangent) {
  FillOptions options;
  options.method = method;
  options.continuity = continuity;
  options.tryOthers = false;
  return options;
}

std::vector<FillOptions> everyMethod() {
  return {only(FillMethod::Ear),     only(FillMethod::Minimal),
          only(FillMethod::Area),    only(FillMethod::Dihedral),
          only(FillMethod::Refined), only(FillMethod::Fair, Continuity::Position),
          only(FillMethod::Fair),    only(FillMethod::Fair, Continuity::Curvature),
          only(FillMethod::Crease),  only(FillMethod::Crease, Continuity::Curvature),
          only(FillMethod::Flat)};
}

// Returns true if the patch is a disc over the loop: each of its edges once, in the opposite direction, all others
// twice, as many triangles as Euler's formula gives.
bool isDisc(const Patch& patch) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : patch.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (!edges.emplace(t[k], t[(k + 1) % 3]).second) return false;
  const auto n = static_cast<std::uint32_t>(patch.loopSize);
  for (std::uint32_t i = 0; i < n; ++i)
    if (!edges.contains({(i + 1) % n, i}) || edges.contains({i, (i + 1) % n})) return false;
  std::size_t open = 0;
  for (const auto& [a, b] : edges) open += !edges.contains({b, a});
  return open == n && patch.triangles.size() == n - 2 + 2 * (patch.points.size() - n);
}

HalfEdgeMesh holedBall(double scale, double offset) {
  return buildMesh(test::moved(test::sphereWithHoles(4, 3, 0.3), Vec3(offset, -offset, offset), scale)).mesh;
}

}  // namespace

void FillingExtremesTest::placeRows() {
  QTest::addColumn<double>("scale");
  QTest::addColumn<double>("offset");
  for (const double scale : test::kScales) QTest::addRow("%g mm", scale) << scale << 0.0;
  for (const double offset : test::kOffsets) QTest::addRow("10 mm, %g mm away", offset) << 10.0 << offset;
}

// A patch is a disc of finite points that leaves a valid mesh with nothing more wrong; else there is a reason.
void FillingExtremesTest::patches() {
  QFETCH(test::ExtremeMesh, extreme);
  const HalfEdgeMesh mesh = buildMesh(extreme.soup()).mesh;
  std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  const HoleFiller filler(mesh);
  const test::Edges before = test::countEdges(mesh);
  const bool isSmall = mesh.faceSlots() <= kMostFacesByPair;
  const std::size_t crossings = isSmall ? test::meetingPairs(mesh) : 0;
  for (std::size_t i = 0; i < std::min(loops.size(), kMostLoops); ++i) {
    for (const FillOptions& options : everyMethod()) {
      const FillAttempt attempt = filler.propose(loops[i], options);
      if (attempt.failure != FillFailure::None) {
        QVERIFY(!extreme.name.starts_with("holed sphere"));
        QVERIFY(attempt.failure != FillFailure::Cancelled);
        continue;
      }
      for (const Vec3& p : attempt.patch.points) QVERIFY(p.allFinite());
      QVERIFY(isDisc(attempt.patch));
      HalfEdgeMesh filled = mesh;
      insertPatch(filled, loops[i], attempt.patch);
      QCOMPARE(QString::fromStdString(validate(filled)), QString());
      const test::Edges after = test::countEdges(filled);
      QVERIFY(after.border < before.border || loops[i].borderEdges == 0);
      // Over a seam, which other faces share in the file, a patch makes a third face.
      QVERIFY(after.nonManifold <= before.nonManifold + loops[i].halfEdges.size() - loops[i].borderEdges);
      if (isSmall) QVERIFY(test::meetingPairs(filled) <= crossings);
    }
  }
}

// No triangulation of the same points has less area than that of least area, or a smaller largest bend than that of
// least bend.
void FillingExtremesTest::leastOfAll() {
  QFETCH(double, scale);
  QFETCH(double, offset);
  const HalfEdgeMesh mesh = holedBall(scale, offset);
  const HoleFiller filler(mesh);
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  QVERIFY(!loops.empty());
  for (const BoundaryLoop& loop : loops) {
    const auto statistics = [&](FillMethod method) {
      const FillAttempt attempt = filler.propose(loop, only(method));
      if (attempt.failure != FillFailure::None) qFatal("not filled");
      return statisticsOf(mesh, loop, attempt.patch);
    };
    const PatchStatistics area = statistics(FillMethod::Area), dihedral = statistics(FillMethod::Dihedral);
    const double rounding = test::rounding(test::boxOf(mesh), 256.0) / scale;
    for (const PatchStatistics& other :
         {area, dihedral, statistics(FillMethod::Ear), statistics(FillMethod::Minimal)}) {
      QVERIFY(area.area <= other.area * (1.0 + 1e-9) + rounding * scale * scale);
      QVERIFY(dihedral.largestBend <= other.largestBend + 1e-7 + 100.0 * rounding);
    }
  }
}

// A patch that continues the curvature of a ball is the ball.
void FillingExtremesTest::curvatureOfBalls() {
  QFETCH(double, scale);
  QFETCH(double, offset);
  const HalfEdgeMesh mesh = holedBall(scale, offset);
  const HoleFiller filler(mesh);
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  QVERIFY(!loops.empty());
  for (const FillMethod method : {FillMethod::Fair, FillMethod::Crease}) {
    for (const BoundaryLoop& loop : loops) {
      const FillAttempt attempt = filler.propose(loop, only(method, Continuity::Curvature));
      QVERIFY(attempt.failure == FillFailure::None);
      QVERIFY(attempt.patch.points.size() > attempt.patch.loopSize);
      for (const Vec3& p : attempt.patch.points) {
        const double radius = (p - Vec3(offset, -offset, offset)).norm() / scale;
        QVERIFY2(std::abs(radius - 1.0) < 2e-3, qPrintable(QString::number(radius)));
      }
    }
  }
}

// The hole across a cube's edge gets its two flat sides and its straight edge back.
void FillingExtremesTest::creasesOfCubes() {
  QFETCH(double, scale);
  QFETCH(double, offset);
  const Vec3 shift(offset, -offset, offset);
  const TriangleSoup cut = test::withHole(test::roughCube(24, 0), Vec3(1.02, 1.01, 0.1), 0.3);
  const HalfEdgeMesh mesh = buildMesh(test::moved(cut, shift, scale)).mesh;
  const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
  const FillAttempt attempt = HoleFiller(mesh).propose(loop, only(FillMethod::Crease));
  QVERIFY(attempt.failure == FillFailure::None);
  QCOMPARE(int(attempt.patch.method), int(FillMethod::Crease));
  const double error = 1e-9 + test::rounding(test::boxOf(mesh), 256.0) / scale;
  std::size_t onEdge = 0;
  for (const Vec3& p : attempt.patch.points) {
    const Vec3 unit = (p - shift) / scale;
    QVERIFY(test::distanceToCube(unit) < error);
    onEdge += (unit.head<2>() - Eigen::Vector2d::Ones()).norm() < error;
  }
  QVERIFY(onEdge >= 6);
}

void FillingExtremesTest::sizeChangesNoPatch_data() {
  QTest::addColumn<double>("scale");
  for (int power : {-20, -10, 10, 20}) QTest::addRow("2^%d", power) << std::exp2(power);
}

// Scaling by a power of two is exact, so it must scale each patch to the bit.
void FillingExtremesTest::sizeChangesNoPatch() {
  QFETCH(double, scale);
  for (const TriangleSoup& soup :
       {test::sphereWithHoles(4, 2, 0.35), test::withHole(test::roughCube(16, 3), Vec3(1, 1, 0), 0.3)}) {
    const HalfEdgeMesh plain = buildMesh(soup).mesh, scaled = buildMesh(test::moved(soup, Vec3::Zero(), scale)).mesh;
    const std::vector<BoundaryLoop> loops = findBoundaryLoops(plain), others = findBoundaryLoops(scaled);
    QCOMPARE(loops.size(), others.size());
    const HoleFiller filler(plain), other(scaled);
    for (std::size_t i = 0; i < loops.size(); ++i) {
      for (const FillOptions& options : everyMethod()) {
        const FillAttempt a = filler.propose(loops[i], options), b = other.propose(others[i], options);
        QCOMPARE(int(a.failure), int(b.failure));
        QVERIFY(a.patch.triangles == b.patch.triangles);
        QCOMPARE(a.patch.points.size(), b.patch.points.size());
        for (std::size_t k = 0; k < a.patch.points.size(); ++k)
          QVERIFY(Vec3(scale * a.patch.points[k]) == b.patch.points[k]);
      }
    }
  }
}

// The proposed bridges cut the loop into pieces; each bridge is an edge of two of them.
void FillingExtremesTest::bridges() {
  constexpr std::size_t kPieceEdges = 8;
  QFETCH(test::ExtremeMesh, extreme);
  const HalfEdgeMesh mesh = buildMesh(extreme.soup()).mesh;
  const HoleFiller filler(mesh);
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  for (std::size_t i = 0; i < std::min(loops.size(), kMostLoops); ++i) {
    const std::size_t n = loops[i].halfEdges.size();
    const std::vector<HoleBridge> bridges = filler.proposeHoleBridges(loops[i], kPieceEdges);
    if (n <= kPieceEdges) QVERIFY(bridges.empty());
    const auto pieces = splitHole(n, bridges);
    QVERIFY(pieces);
    QCOMPARE(pieces->size(), bridges.size() + 1);
    std::size_t edges = 0;
    for (const HolePiece& piece : *pieces) edges += piece.size();
    QCOMPARE(edges, n + 2 * bridges.size());
    if (extreme.name.starts_with("holed sphere")) {
      QVERIFY(!bridges.empty());
      for (const HolePiece& piece : *pieces) QVERIFY(piece.size() <= kPieceEdges);
      FillOptions options = only(FillMethod::Minimal);
      options.pieceEdges = kPieceEdges;
      const FillAttempt attempt = filler.propose(loops[i], options);
      QVERIFY(attempt.failure == FillFailure::None && isDisc(attempt.patch));
      QVERIFY(attempt.patch.bridges == bridges);
    }
  }
}

// Both ends of a tube, loops of 3,000 edges, are cut into pieces and closed by flat lids: the tube's volume is that of
// a prism over a regular polygon.
void FillingExtremesTest::longLoops() {
  constexpr std::uint32_t kEdges = 3000;
  QFETCH(double, scale);
  QFETCH(double, offset);
  const Vec3 shift(offset, -offset, offset);
  const HalfEdgeMesh mesh = buildMesh(test::moved(test::cylinder(kEdges, 1, 1.0, 2.0, false), shift, scale)).mesh;
  HoleFiller filler(mesh);
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  QCOMPARE(loops.size(), std::size_t{2});
  for (const BoundaryLoop& loop : loops) {
    QCOMPARE(loop.halfEdges.size(), std::size_t{kEdges});
    const FillAttempt attempt = filler.propose(loop, only(FillMethod::Minimal));
    QVERIFY(attempt.failure == FillFailure::None);
    QVERIFY(!attempt.patch.bridges.empty());
    filler.accept(loop, attempt.patch);
  }
  QCOMPARE(validate(filler.mesh()), std::string());
  const TriangleSoup closed = test::moved(filler.mesh().compact().soup, -shift);
  QVERIFY(test::countEdges(filler.mesh()).sound());
  const double prism = 2.0 * 0.5 * kEdges * std::sin(2.0 * M_PI / kEdges) * scale * scale * scale;
  const double error = 1e-9 + test::rounding(test::boxOf(mesh), 256.0) / scale;
  QVERIFY(std::abs(test::volume(closed) / prism - 1.0) < error);
}

HANDWHEEL_TEST(FillingExtremesTest)
#include "FillingExtremesTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/HoleDecomposition.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>
#include <numeric>

using namespace handwheel;

namespace {

struct LoopDecompositionCase {
  explicit LoopDecompositionCase(const TriangleSoup& soup, std::size_t atLeast = 3)
      : mesh(buildMesh(soup).mesh), obstacles(mesh) {
    for (const BoundaryLoop& l : findBoundaryLoops(mesh)) {
      if (l.halfEdges.size() < atLeast) continue;
      loop = l;
      break;
    }
    hole = holeContext(mesh, loop);
  }
  double length(const HoleBridge& s) const { return (hole.points[s.a] - hole.points[s.b]).norm(); }

  HalfEdgeMesh mesh;
  Obstacles obstacles;
  BoundaryLoop loop;
  HoleContext hole;
};

// A flat sheet z = 0 around a closed outline of points, which runs counter-clockwise: the outline is the hole.
template <class Point>
TriangleSoup sheetAround(std::uint32_t n, double width, Point outline) {
  return test::grid(2, n, false, true, [&](std::uint32_t i, std::uint32_t j) {
    const Eigen::Vector2d p = outline(j), along = outline((j + 1) % n) - outline((j + n - 1) % n);
    const Eigen::Vector2d outward = width * Eigen::Vector2d(along.y(), -along.x()).normalized();
    return Vec3(p.x() + i * outward.x(), p.y() + i * outward.y(), 0.0);
  });
}

// Returns true if the point is in the polygon (crossing number).
bool isInside(const std::vector<Vec3>& polygon, const Vec3& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec3 &a = polygon[i], &b = polygon[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  return inside;
}

std::size_t longest(const std::vector<HolePiece>& pieces) {
  std::size_t n = 0;
  for (const HolePiece& p : pieces) n = std::max(n, p.size());
  return n;
}

}  // namespace

class HoleDecompositionTest : public QObject {
  Q_OBJECT

 private slots:
  void cutsAlongAnyBridges();
  void refusesWhatIsNoCut();
  void shortLoopsStayWhole();
  void roundHolesFallIntoEvenPieces();
  void slotsAreZipped_data();
  void slotsAreZipped();
  void bridgesStayInTheHole();
  void bridgesGoRoundThePart();
  void noBridgeAlongAnEdge();
  void piecesMakeOnePatch();
  void bridgesOfTheUserHold();
  void cancels();
};

// Every bridge makes one piece more, and each piece's polygon has n - 2 triangles, as the whole has.
void HoleDecompositionTest::cutsAlongAnyBridges() {
  QVERIFY(rc::check("random cuts", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const std::size_t n = 4 + random() % 200;
    std::vector<HoleBridge> bridges;
    for (int i = 0; i < 40; ++i) {
      std::vector<HoleBridge> more = bridges;
      more.push_back({static_cast<std::uint32_t>(random() % n), static_cast<std::uint32_t>(random() % n)});
      if (splitHole(n, more)) bridges = more;
    }
    const std::vector<HolePiece> pieces = splitHole(n, bridges).value();
    RC_ASSERT(pieces.size() == bridges.size() + 1);
    std::size_t triangles = 0;
    for (const HolePiece& p : pieces) {
      RC_ASSERT(p.size() >= 3u);
      RC_ASSERT(std::is_sorted(p.begin(), p.end()));
      triangles += p.size() - 2;
    }
    RC_ASSERT(triangles == n - 2);
  }));
}

void HoleDecompositionTest::refusesWhatIsNoCut() {
  QVERIFY(splitHole(6, {{0, 2}, {5, 2}}).has_value());
  QVERIFY(!splitHole(6, {{1, 1}}));          // one point
  QVERIFY(!splitHole(6, {{1, 2}}));          // an edge
  QVERIFY(!splitHole(6, {{5, 0}}));          // the last edge
  QVERIFY(!splitHole(6, {{1, 6}}));          // no such point
  QVERIFY(!splitHole(6, {{0, 3}, {3, 0}}));  // twice
  QVERIFY(!splitHole(6, {{0, 3}, {1, 4}}));  // crossing
  QVERIFY(!splitHole(3, {{0, 2}}));
}

void HoleDecompositionTest::shortLoopsStayWhole() {
  const LoopDecompositionCase c(test::cylinder(300, 2, 1, 1, false));
  QVERIFY(proposeHoleBridges(c.hole, c.obstacles, 300).empty());
  QVERIFY(!proposeHoleBridges(c.hole, c.obstacles, 299).empty());
}

void HoleDecompositionTest::roundHolesFallIntoEvenPieces() {
  for (std::size_t most : {300, 100, 5, 0}) {
    const LoopDecompositionCase c(test::cylinder(2554, 2, 10.0, 1.0, false));
    const std::vector<HoleBridge> bridges = proposeHoleBridges(c.hole, c.obstacles, most);
    const std::vector<HolePiece> pieces = splitHole(c.hole.loopSize, bridges).value();
    QVERIFY(longest(pieces) <= std::max<std::size_t>(most, 4));
    for (const HolePiece& p : pieces) QVERIFY(4 * p.size() >= most || most <= 5);
    for (const HoleBridge& s : bridges) QVERIFY(c.length(s) <= 20.0 + 1e-9);
  }
}

void HoleDecompositionTest::slotsAreZipped_data() {
  QTest::addColumn<bool>("isRing");
  QTest::newRow("straight") << false;
  QTest::newRow("nearly a ring") << true;
}

// A slot of 1000 edges a side and a fiftieth as wide as its edges are long in all: every bridge goes straight across.
void HoleDecompositionTest::slotsAreZipped() {
  QFETCH(bool, isRing);
  const std::uint32_t n = 2000;
  const double width = 0.02;
  const LoopDecompositionCase c(sheetAround(n, isRing ? 0.003 : 0.01,
                                            [&](std::uint32_t j) {
                                              const bool isBack = j >= n / 2;
                                              const double along = (isBack ? n - 1 - j : j) / (n / 2 - 1.0);
                                              if (!isRing) return Eigen::Vector2d(along, isBack ? width : 0.0);
                                              const double r = isBack ? 1.0 : 1.0 + width, u = 6.0 * along;
                                              return Eigen::Vector2d(r * std::cos(u), r * std::sin(u));
                                            }),
                                n);
  QVERIFY(c.loop.halfEdges.size() == n);
  const std::vector<HoleBridge> bridges = proposeHoleBridges(c.hole, c.obstacles, 200);
  QVERIFY(longest(splitHole(n, bridges).value()) <= 200);
  for (const HoleBridge& s : bridges) QVERIFY(c.length(s) < 1.1 * width);
}

// The end of a tube with a star's outline, where nothing but the outline itself says where the hole is.
void HoleDecompositionTest::bridgesStayInTheHole() {
  const std::uint32_t n = 900;
  const LoopDecompositionCase c(test::grid(n, 2, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2.0 * M_PI * i / n, r = 1.0 + 0.6 * std::cos(9.0 * u);
    return Vec3(r * std::cos(u), r * std::sin(u), j);
  }));
  const std::vector<HoleBridge> bridges = proposeHoleBridges(c.hole, c.obstacles, 60);
  QVERIFY(longest(splitHole(n, bridges).value()) <= 60);
  const std::vector<Vec3> outline = c.hole.loop();
  for (const HoleBridge& s : bridges) {
    for (double w : {0.01, 0.25, 0.5, 0.75, 0.99})
      QVERIFY(isInside(outline, (1.0 - w) * outline[s.a] + w * outline[s.b]));
  }
}

// A pole stands in the middle of a round hole, where bridges would meet it first.
void HoleDecompositionTest::bridgesGoRoundThePart() {
  TriangleSoup soup = test::annulus(800, 2, 1.0, 2.0);
  test::append(soup, test::moved(test::cylinder(24, 4, 0.2, 4.0, true), Vec3(0, 0, -2.0)));
  const LoopDecompositionCase c(soup);
  QCOMPARE(c.hole.loopSize, std::size_t{800});
  const std::vector<HoleBridge> bridges = proposeHoleBridges(c.hole, c.obstacles, 150);
  QVERIFY(!bridges.empty());
  for (const HoleBridge& s : bridges) {
    const Vec3 &a = c.hole.points[s.a], &b = c.hole.points[s.b];
    const double w = std::clamp(-a.dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    QVERIFY((a + w * (b - a)).norm() > 0.19);
  }
}

// A roof of four triangles, whose six points are its outline: the ridge would be the shortest bridge by far, and is an
// edge already.
void HoleDecompositionTest::noBridgeAlongAnEdge() {
  const LoopDecompositionCase c(test::grid(
      3, 2, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(2.0 * i, j, i == 1 ? 2.0 : 0.0); }));
  QCOMPARE(c.hole.loopSize, std::size_t{6});
  const auto known = c.obstacles.edgesAmong(c.hole.loop());
  QCOMPARE(known.size(), std::size_t{9});  // edges of the outline, and three inside
  const std::vector<HoleBridge> bridges = proposeHoleBridges(c.hole, c.obstacles, 4);
  QVERIFY(!bridges.empty());
  for (const HoleBridge& s : bridges) {
    const std::pair<std::uint32_t, std::uint32_t> edge = std::minmax(s.a, s.b);
    QVERIFY(std::find(known.begin(), known.end(), edge) == known.end());
  }
}

void HoleDecompositionTest::piecesMakeOnePatch() {
  TriangleSoup crown = test::cylinder(1000, 2, 1.0, 1.0, false);  // far from flat: a flat loop needs no pieces
  for (Vec3& p : crown.points) p.z() += 0.4 * std::cos(2.0 * std::atan2(p.y(), p.x()));
  const LoopDecompositionCase tube(test::cylinder(1000, 2, 1.0, 1.0, false)), wavy(crown);
  for (FillMethod method : {FillMethod::Fair, FillMethod::Refined, FillMethod::Minimal}) {
    const LoopDecompositionCase& c = method == FillMethod::Minimal ? tube : wavy;
    HoleFiller filler(c.mesh);
    FillOptions options;
    options.method = method;
    options.tryOthers = false;
    options.pieceEdges = 60;
    options.continuity = Continuity::Position;
    const FillAttempt attempt = filler.propose(c.loop, options);
    QVERIFY(attempt.failure == FillFailure::None);
    QVERIFY(attempt.patch.method == method);
    QVERIFY(attempt.patch.bridges == filler.proposeHoleBridges(c.loop, 60));
    QVERIFY(!attempt.patch.bridges.empty());
    if (method == FillMethod::Minimal)  // flat, over the whole of the regular polygon
      QVERIFY(std::abs(test::area({attempt.patch.points, attempt.patch.triangles}) -
                       500.0 * std::sin(2.0 * M_PI / 1000.0)) < 1e-9);
    filler.accept(c.loop, attempt.patch);
    QCOMPARE(validate(filler.mesh()), std::string());
  }
}

void HoleDecompositionTest::bridgesOfTheUserHold() {
  const LoopDecompositionCase c(test::cylinder(40, 2, 1.0, 1.0, false));
  const HoleFiller filler(c.mesh);
  FillOptions options;
  options.tryOthers = false;
  options.bridges = {{3, 30}, {30, 35}, {4, 20}};
  for (FillMethod method : {FillMethod::Ear, FillMethod::Minimal}) {
    options.method = method;
    const FillAttempt attempt = filler.propose(c.loop, options);
    QVERIFY(attempt.failure == FillFailure::None);
    QVERIFY(attempt.patch.bridges == options.bridges);
    for (const HoleBridge& s : options.bridges) {
      const auto has = [](const Triangle& t, std::uint32_t v) { return std::find(t.begin(), t.end(), v) != t.end(); };
      QCOMPARE(std::count_if(attempt.patch.triangles.begin(), attempt.patch.triangles.end(),
                             [&](const Triangle& t) { return has(t, s.a) && has(t, s.b); }),
               std::ptrdiff_t{2});
    }
  }
}

void HoleDecompositionTest::cancels() {
  const LoopDecompositionCase c(test::cylinder(2000, 2, 1.0, 1.0, false));
  JobState job;
  job.cancelled = true;
  QVERIFY(proposeHoleBridges(c.hole, c.obstacles, 50, Progress(job)).empty());
}

HANDWHEEL_TEST(HoleDecompositionTest)
#include "HoleDecompositionTest.moc"

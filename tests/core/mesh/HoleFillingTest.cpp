// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/HoleFilling.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "base/Tolerance.h"
#include "mesh/MeshBuilder.h"
#include "mesh/MeshValidator.h"

#include <QTest>

using namespace handwheel;

namespace {

constexpr FillMethod kMethods[] = {FillMethod::Fair, FillMethod::Refined, FillMethod::Ear, FillMethod::Minimal};

FillOptions only(FillMethod method) {
  FillOptions options;
  options.method = method;
  options.tryOthers = false;
  return options;
}

TriangleSoup soupOf(const Patch& patch) { return {patch.points, patch.triangles}; }

// Pairs of faces that meet, all against all.
std::size_t meetingPairs(const HalfEdgeMesh& mesh) {
  const TriangleSoup s = mesh.compact().soup;
  const auto corners = [&](std::size_t i) {
    const Triangle& t = s.triangles[i];
    return TrianglePoints{s.points[t[0]], s.points[t[1]], s.points[t[2]]};
  };
  std::size_t n = 0;
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    const TrianglePoints a = corners(i);
    const Box box = Box(a[0]).extend(a[1]).extend(a[2]);
    for (std::size_t j = 0; j < i; ++j) {
      const TrianglePoints b = corners(j);
      if (box.intersects(Box(b[0]).extend(b[1]).extend(b[2]))) n += trianglesMeet(a, b);
    }
  }
  return n;
}

using Polygon = std::vector<std::pair<double, double>>;
const Polygon kEll = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
const Polygon kComb = {{0, 0}, {7, 0}, {7, 4}, {6, 4}, {6, 1}, {5, 1}, {5, 4}, {3, 4},
                       {3, 1}, {2, 1}, {2, 4}, {1, 4}, {1, 1}, {0, 1}};

Polygon star(int points) {
  Polygon p;
  for (int i = 0; i < 2 * points; ++i) {
    const double r = i % 2 ? 0.3 : 1.0, u = M_PI * i / points;
    p.emplace_back(r * std::cos(u), r * std::sin(u));
  }
  return p;
}

double shoelace(const Polygon& p) {
  double twice = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto& [x, y] = p[i];
    const auto& [u, v] = p[(i + 1) % p.size()];
    twice += x * v - u * y;
  }
  return 0.5 * twice;
}

// The wall of a tube with this outline, from z = 0 to 1: a planar hole at either end.
TriangleSoup tube(const Polygon& p) {
  const auto n = static_cast<std::uint32_t>(p.size());
  return test::grid(n, 2, true, false, [&](std::uint32_t i, std::uint32_t j) { return Vec3(p[i].first, p[i].second, j); });
}

// A flat sheet between the outline and the outline three times as large, facing +z.
TriangleSoup collar(const Polygon& p) {
  const auto n = static_cast<std::uint32_t>(p.size());
  return test::grid(2, n, false, true, [&](std::uint32_t i, std::uint32_t j) {
    const double scale = i ? 3.0 : 1.0;
    return Vec3(scale * p[j].first, scale * p[j].second, 0);
  });
}

Eigen::Matrix3d tilt() {
  return (Eigen::AngleAxisd(0.7, Vec3::UnitX()) * Eigen::AngleAxisd(-1.1, Vec3::UnitY())).toRotationMatrix();
}

// A unit sphere without its cap around +z; alpha is the angle from the axis to the border.
TriangleSoup sphereWithoutCap(int levels = 4) { return test::withHole(test::icosphere(levels), Vec3::UnitZ(), 0.4); }

// A thin tetrahedron that stands on its tip.
TriangleSoup needleOn(const Vec3& tip, double height) {
  TriangleSoup s = test::tetrahedron();
  const double w = 0.1 * height;
  s.points = {tip, tip + Vec3(w, 0, height), tip + Vec3(0, w, height), tip + Vec3(-w, -w, height)};
  return s;
}

}  // namespace

class HoleFillingTest : public QObject {
  Q_OBJECT

 private slots:
  void planarPolygons_data();
  void planarPolygons();
  void flatSheets();
  void missingTriangle();
  void usesTheDiagonalThatIsFree();
  void fairContinuesTheSphere();
  void refinedKeepsToTheOpening();
  void anySizeAndPlace_data();
  void anySizeAndPlace();
  void largeRing();
  void poleThroughTheHole();
  void obstacleBeforeTheBulge();
  void patchesRespectEachOther();
  void roundsNewVertices();
  void touchesNoVertex();
  void pinchedLoops();
  void tooShortAndCancelled();
};

void HoleFillingTest::planarPolygons_data() {
  QTest::addColumn<Polygon>("polygon");
  QTest::newRow("triangle") << Polygon{{0, 0}, {1, 0}, {0, 1}};
  QTest::newRow("square") << Polygon{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  QTest::newRow("points in a row") << Polygon{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  QTest::newRow("L") << kEll;
  QTest::newRow("comb") << kComb;
  QTest::newRow("star") << star(9);
}

// A patch of the loop's points alone lies in the plane, so its area is the polygon's exactly when nothing overlaps.
void HoleFillingTest::planarPolygons() {
  QFETCH(Polygon, polygon);
  for (const Eigen::Matrix3d& turn : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), tilt()}) {
    TriangleSoup soup = tube(polygon);
    for (Vec3& p : soup.points) p = turn * p;
    const HalfEdgeMesh mesh = buildMesh(soup).mesh;
    for (FillMethod method : {FillMethod::Ear, FillMethod::Minimal, FillMethod::Refined}) {
      HoleFiller filler(mesh);
      for (const BoundaryLoop& loop : findBoundaryLoops(mesh)) {
        FillAttempt attempt = filler.propose(loop, only(method));
        // Best-first ear cutting may get stuck; then another method has to do.
        if (method == FillMethod::Ear && attempt.failure == FillFailure::NoPatch) attempt = filler.propose(loop, {method});
        QVERIFY2(attempt.failure == FillFailure::None, qPrintable(QString("method %1").arg(int(method))));
        QVERIFY(attempt.patch.method == method || method == FillMethod::Ear);
        if (attempt.patch.method != FillMethod::Fair)
          QVERIFY(std::abs(test::area(soupOf(attempt.patch)) - shoelace(polygon)) < 1e-12 * shoelace(polygon));
        if (attempt.patch.points.size() == polygon.size())
          QCOMPARE(attempt.patch.triangles.size(), polygon.size() - 2);
        filler.accept(loop, attempt.patch);
      }
      QCOMPARE(validate(filler.mesh()), std::string());
      QVERIFY(test::countEdges(filler.mesh()).sound());
      QCOMPARE(test::eulerCharacteristic(filler.mesh()), 2l);
      QCOMPARE(test::countBorder(filler.mesh()), std::size_t{0});
      QVERIFY(std::abs(test::volume(filler.mesh().compact().soup) - shoelace(polygon)) < 1e-12 * shoelace(polygon));
    }
  }
}

// In a flat sheet a patch that continues the tangents is flat too.
void HoleFillingTest::flatSheets() {
  for (const Polygon& polygon : {star(7), star(12), Polygon{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}) {
    const HalfEdgeMesh mesh = buildMesh(collar(polygon)).mesh;
    HoleFiller filler(mesh);
    const BoundaryLoop hole = findBoundaryLoops(mesh)[0];
    for (FillMethod method : kMethods) {
      const FillAttempt attempt = filler.propose(hole, only(method));
      QVERIFY(attempt.failure == FillFailure::None);
      QVERIFY(std::abs(test::area(soupOf(attempt.patch)) - shoelace(polygon)) < 1e-9);
      for (const Vec3& p : attempt.patch.points) QVERIFY(std::abs(p.z()) < 1e-9);
    }
  }
}

void HoleFillingTest::missingTriangle() {
  for (FillMethod method : kMethods) {
    TriangleSoup soup = test::icosphere(1);
    soup.triangles.erase(soup.triangles.begin() + 7);
    const HalfEdgeMesh mesh = buildMesh(soup).mesh;
    HoleFiller filler(mesh);
    const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
    const FillAttempt attempt = filler.propose(loop, only(method));
    QVERIFY(attempt.failure == FillFailure::None);
    filler.accept(loop, attempt.patch);
    QVERIFY(test::countEdges(filler.mesh()).sound());
    QCOMPARE(validate(filler.mesh()), std::string());
  }
}

// Two faces of a tetrahedron: their common edge is one diagonal of the hole, so the patch must take the other.
void HoleFillingTest::usesTheDiagonalThatIsFree() {
  TriangleSoup soup = test::tetrahedron();
  soup.triangles.resize(2);
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
  for (FillMethod method : {FillMethod::Ear, FillMethod::Minimal, FillMethod::Fair}) {
    HoleFiller filler(mesh);
    FillOptions options;
    options.method = method;
    const FillAttempt attempt = filler.propose(loop, options);
    QVERIFY(attempt.failure == FillFailure::None);
    filler.accept(loop, attempt.patch);
    QVERIFY(test::countEdges(filler.mesh()).sound());
    QCOMPARE(meetingPairs(filler.mesh()), std::size_t{0});
  }
}

// Over a cap of angle a the biharmonic surface with the sphere's position and slope at the border (Botsch et al. 2008) is
// z = c + d r²; its top is cos a + sin² a / (2 cos a), off the sphere by a⁴/8 + O(a⁶). Twice that is allowed, plus what
// edges of length h lose against the sphere they cut, h² / 8, once at the ring (tangents) and once in the patch.
void HoleFillingTest::fairContinuesTheSphere() {
  const HalfEdgeMesh mesh = buildMesh(sphereWithoutCap()).mesh;
  HoleFiller filler(mesh);
  const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
  double a = 0.0, h = 0.0;
  for (std::size_t i = 0; i < loop.halfEdges.size(); ++i) a = std::max(a, std::acos(loopPoints(mesh, loop)[i].z()));
  for (HalfEdge e : loop.halfEdges) h = std::max(h, (mesh.position(mesh.to(e)) - mesh.position(mesh.from(e))).norm());
  const double allowed = 2.0 * std::pow(a, 4) / 8.0 + 2.0 * h * h / 8.0;
  QVERIFY(allowed < 0.3 * (1.0 - std::cos(a)));  // far better than a flat lid

  const FillAttempt attempt = filler.propose(loop, only(FillMethod::Fair));
  QVERIFY(attempt.failure == FillFailure::None);
  QVERIFY(attempt.patch.points.size() > attempt.patch.loopSize);
  for (const Vec3& p : attempt.patch.points) QVERIFY(std::abs(p.norm() - 1.0) < allowed);
  filler.accept(loop, attempt.patch);
  QCOMPARE(validate(filler.mesh()), std::string());
  QVERIFY(test::countEdges(filler.mesh()).sound());
  QCOMPARE(test::eulerCharacteristic(filler.mesh()), 2l);
  QCOMPARE(meetingPairs(filler.mesh()), std::size_t{0});
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) QVERIFY(test::sameBits(mesh.position(v), filler.mesh().position(v)));
}

void HoleFillingTest::refinedKeepsToTheOpening() {
  const HalfEdgeMesh mesh = buildMesh(sphereWithoutCap()).mesh;
  HoleFiller filler(mesh);
  const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
  for (FillMethod method : {FillMethod::Refined, FillMethod::Ear, FillMethod::Minimal}) {
    const FillAttempt attempt = filler.propose(loop, only(method));
    QVERIFY(attempt.failure == FillFailure::None);
    // New points are means of old ones, so they stay in the loop's box.
    for (const Vec3& p : attempt.patch.points) QVERIFY(loop.box.contains(p));
  }
}

void HoleFillingTest::anySizeAndPlace_data() {
  QTest::addColumn<double>("scale");
  QTest::addColumn<double>("shift");
  QTest::newRow("as it is") << 1.0 << 0.0;
  QTest::newRow("tiny") << 1e-6 << 0.0;
  QTest::newRow("huge") << 1e6 << 0.0;
  QTest::newRow("far off") << 1.0 << 1e6;
  QTest::newRow("tiny and off") << 1e-6 << 1.0;
}

void HoleFillingTest::anySizeAndPlace() {
  QFETCH(double, scale);
  QFETCH(double, shift);
  const Vec3 centre = shift * Vec3(1, -1, 1);
  TriangleSoup soup = sphereWithoutCap(3);
  for (Vec3& p : soup.points) p = tilt() * p;
  const HalfEdgeMesh mesh = buildMesh(test::moved(soup, centre, scale)).mesh;
  const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
  for (FillMethod method : kMethods) {
    HoleFiller filler(mesh);
    const FillAttempt attempt = filler.propose(loop, only(method));
    QVERIFY2(attempt.failure == FillFailure::None, qPrintable(QString("method %1").arg(int(method))));
    filler.accept(loop, attempt.patch);
    QCOMPARE(validate(filler.mesh()), std::string());
    QVERIFY(test::countEdges(filler.mesh()).sound());
    QCOMPARE(meetingPairs(filler.mesh()), std::size_t{0});
    for (const Vec3& p : attempt.patch.points) {
      const double radius = (p - centre).norm() / scale;
      // A lid at the border's height is about 0.1 below the sphere.
      QVERIFY(radius < 1.03 && radius > (method == FillMethod::Fair ? 0.97 : 0.85));
    }
  }
}

// Far beyond what a cubic algorithm could do (90 s at 2554 edges); the program's time limit would show it.
void HoleFillingTest::largeRing() {
  const std::uint32_t n = 4000;
  const HalfEdgeMesh mesh = buildMesh(test::cylinder(n, 4, 1.0, 0.01, false)).mesh;
  HoleFiller filler(mesh);
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh)) {
    const FillAttempt attempt = filler.propose(loop, {});
    QVERIFY(attempt.failure == FillFailure::None);
    QVERIFY(attempt.patch.points.size() <= n * (1 + tolerance::kPatchVerticesPerEdge));
    filler.accept(loop, attempt.patch);
  }
  QCOMPARE(validate(filler.mesh()), std::string());
  QVERIFY(test::countEdges(filler.mesh()).sound());
}

// The pole is five times as long as the hole is wide, so no disc over the hole avoids it without leaving the opening.
void HoleFillingTest::poleThroughTheHole() {
  TriangleSoup soup = test::annulus(24, 3, 1.0, 3.0);
  const TriangleSoup pole = test::cylinder(8, 10, 0.1, 20.0, true);
  test::append(soup, test::moved(pole, Vec3(0.05, 0.02, -10.0)));
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  HoleFiller filler(mesh);
  BoundaryLoop hole;
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh))
    if (loop.box.sizes().norm() < 4.0) hole = loop;
  QCOMPARE(hole.halfEdges.size(), std::size_t{24});
  for (FillMethod method : kMethods) {
    FillOptions options;
    options.method = method;
    QVERIFY(filler.propose(hole, options).failure == FillFailure::SelfIntersecting);
    options.tryOthers = false;
    const FillFailure failure = filler.propose(hole, options).failure;
    QVERIFY(failure == FillFailure::SelfIntersecting || failure == FillFailure::NoPatch);
  }
}

// Where the fair patch would pass hangs a little solid; a flat lid goes below it.
void HoleFillingTest::obstacleBeforeTheBulge() {
  TriangleSoup soup = sphereWithoutCap(3);
  test::append(soup, test::cube(0.1, Vec3(-0.05, -0.05, 0.95)));
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
  HoleFiller filler(mesh);
  QVERIFY(filler.propose(loop, only(FillMethod::Fair)).failure == FillFailure::SelfIntersecting);
  const FillAttempt attempt = filler.propose(loop, {});
  QVERIFY(attempt.failure == FillFailure::None);
  QVERIFY(attempt.patch.method != FillMethod::Fair);
  filler.accept(loop, attempt.patch);
  QVERIFY(test::countEdges(filler.mesh()).sound());
  QCOMPARE(meetingPairs(filler.mesh()), std::size_t{0});
}

// Two spheres whose caps would overlap face each other without them.
void HoleFillingTest::patchesRespectEachOther() {
  TriangleSoup soup = sphereWithoutCap(3);
  TriangleSoup other = sphereWithoutCap(3);
  for (Vec3& p : other.points) p = Vec3(p.x(), -p.y(), 1.97 - p.z());
  test::append(soup, other);
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QCOMPARE(meetingPairs(mesh), std::size_t{0});
  HoleFiller filler(mesh);
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  QCOMPARE(loops.size(), std::size_t{2});
  for (const BoundaryLoop& loop : loops) {
    const FillAttempt attempt = filler.propose(loop, {});
    QVERIFY(attempt.failure == FillFailure::None);
    filler.accept(loop, attempt.patch);
  }
  QVERIFY(test::countEdges(filler.mesh()).sound());
  QCOMPARE(meetingPairs(filler.mesh()), std::size_t{0});
}

void HoleFillingTest::roundsNewVertices() {
  const HalfEdgeMesh mesh = buildMesh(sphereWithoutCap(3)).mesh;
  FillOptions options;
  options.numbers = NumberType::Float32;
  const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
  const Patch patch = HoleFiller(mesh).propose(loop, options).patch;
  QVERIFY(patch.points.size() > patch.loopSize);
  for (std::size_t i = 0; i < patch.points.size(); ++i) {
    if (i < patch.loopSize) {
      QVERIFY(test::sameBits(patch.points[i], loopPoints(mesh, loop)[i]));
      continue;
    }
    for (double x : patch.points[i]) {
      volatile float single = static_cast<float>(x);
      QVERIFY(static_cast<double>(single) == x && !(x == 0.0 && std::signbit(x)));
    }
  }
}

// First it is learnt where the patch will have a vertex; then a needle's tip is put exactly there, outside. The part would
// hang together at one point if the patch came through it.
void HoleFillingTest::touchesNoVertex() {
  const TriangleSoup sphere = sphereWithoutCap(3);
  const HalfEdgeMesh alone = buildMesh(sphere).mesh;
  const Patch first = HoleFiller(alone).propose(findBoundaryLoops(alone).at(0), {}).patch;
  QVERIFY(first.points.size() > first.loopSize);
  for (std::size_t i = first.loopSize; i < first.points.size(); i += 5) {
    TriangleSoup soup = sphere;
    test::append(soup, needleOn(first.points[i], 0.3));
    const HalfEdgeMesh mesh = buildMesh(soup).mesh;
    const FillAttempt attempt = HoleFiller(mesh).propose(findBoundaryLoops(mesh).at(0), {});
    QVERIFY(attempt.failure == FillFailure::None);
    const std::set<test::Place> taken = test::places(soup);
    for (std::size_t k = attempt.patch.loopSize; k < attempt.patch.points.size(); ++k)
      QVERIFY2(!taken.contains(test::place(attempt.patch.points[k])), "a new vertex lies on one of the part");
  }
}

// Two missing triangles that touch at a vertex: one border that passes it twice, two loops.
void HoleFillingTest::pinchedLoops() {
  TriangleSoup soup = test::icosphere(2);
  std::vector<std::size_t> around;  // the triangles at vertex 20, which has six
  for (std::size_t i = 0; i < soup.triangles.size(); ++i)
    if (std::count(soup.triangles[i].begin(), soup.triangles[i].end(), 20u)) around.push_back(i);
  QCOMPARE(around.size(), std::size_t{6});
  const auto shared = [&](std::size_t i, std::size_t j) {
    return std::count_if(soup.triangles[i].begin(), soup.triangles[i].end(), [&](std::uint32_t v) {
      return std::count(soup.triangles[j].begin(), soup.triangles[j].end(), v) > 0;
    });
  };
  std::size_t across = 0;
  for (std::size_t i : around)
    if (shared(around[0], i) == 1) across = i;
  soup.triangles.erase(soup.triangles.begin() + std::ptrdiff_t(std::max(around[0], across)));
  soup.triangles.erase(soup.triangles.begin() + std::ptrdiff_t(std::min(around[0], across)));

  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  QCOMPARE(loops.size(), std::size_t{2});
  HoleFiller filler(mesh);
  for (const BoundaryLoop& loop : loops) {
    const FillAttempt attempt = filler.propose(loop, {});
    QVERIFY(attempt.failure == FillFailure::None);
    filler.accept(loop, attempt.patch);
    QCOMPARE(validate(filler.mesh()), std::string());
  }
  QCOMPARE(test::eulerCharacteristic(filler.mesh()), 2l);
  QCOMPARE(test::countBorder(filler.mesh()), std::size_t{0});
  QVERIFY(test::countEdges(filler.mesh()).sound());
}

void HoleFillingTest::tooShortAndCancelled() {
  const HalfEdgeMesh mesh = buildMesh(sphereWithoutCap(3)).mesh;
  const HoleFiller filler(mesh);
  BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
  JobState job;
  job.cancelled = true;
  QVERIFY(filler.propose(loop, {}, Progress(job)).failure == FillFailure::Cancelled);
  loop.halfEdges.resize(2);
  QVERIFY(filler.propose(loop, {}).failure == FillFailure::NoPatch);
  QVERIFY(test::sameMesh(filler.mesh(), mesh));
}

QTEST_GUILESS_MAIN(HoleFillingTest)
#include "HoleFillingTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/BoundarySmoothing.h"

#include "HoleShapes.h"
#include "MeshChecks.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class BoundarySmoothingTest : public QObject {
  Q_OBJECT

 private slots:
  void teethGo();
  void aCircleStays();
  void spacingOnly();
  void pinchesAndSeamsStay();
  void smallestLoop();
  void facesKeepTheirSides();
  void scalesAndOffsets();
  void roundsToTheNumbersOfTheFile();
  void staleMoves();
};

namespace {

// Returns the squared distances of the loop's points from the middles of their neighbours.
double roughness(const std::vector<Vec3>& p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i)
    sum += (p[(i + 1) % p.size()] - 2.0 * p[i] + p[(i + p.size() - 1) % p.size()]).squaredNorm();
  return sum;
}

struct Smoothed {
  HalfEdgeMesh before, after;
  BoundaryLoop loop;
  SmoothedBoundary border;

  explicit Smoothed(const TriangleSoup& soup, const SmoothingOptions& options = {}, std::size_t which = 0)
      : before(buildMesh(soup).mesh), after(before), loop(findBoundaryLoops(before).at(which)) {
    border = smoothBoundary(FaceLocator(before, std::make_shared<FaceHierarchy>(before)), loop, options);
    if (!moveVertices(after, border.moves)) qFatal("it moves other vertices");
  }

  // Returns the first violation of a general condition; empty: none.
  std::string problem() const {
    if (const std::string broken = validate(after); !broken.empty()) return broken;
    if (test::meetingPairs(after) > test::meetingPairs(before)) return "faces cross";
    std::set<Vertex> own;
    for (const HalfEdge h : loop.halfEdges) own.insert(before.from(h));
    for (Vertex v = 0; v < before.vertexSlots(); ++v)
      if (!own.contains(v) && !test::sameBits(before.position(v), after.position(v))) return "another vertex moved";
    for (Face f = 0; f < before.faceSlots(); ++f) {
      if (before.triangle(f) != after.triangle(f)) return "a face changed";
      const Vec3 was = unitNormal(before.points(f)), is = unitNormal(after.points(f));
      if (!was.isZero(0.0) && !(was.dot(is) > 0.0)) return "a face turned over";
    }
    return {};
  }
};

// A disc whose rim goes in and out by this share from point to point.
TriangleSoup toothedDisc(std::uint32_t n, double tooth) {
  TriangleSoup s = test::disc(n, 6);
  for (Vec3& p : s.points)
    if (p.norm() > 0.99) p *= 1.0 + tooth * (std::lround(n * std::atan2(p.y(), p.x()) / (2.0 * M_PI)) % 2 ? -1 : 1);
  return s;
}

}  // namespace

void BoundarySmoothingTest::teethGo() {
  const Smoothed s(toothedDisc(60, 0.05));
  QCOMPARE(s.problem(), std::string());
  QCOMPARE(s.loop.halfEdges.size(), std::size_t(60));
  // A zigzag keeps under a hundredth of its height; a smooth circle of 60 points has little more than nothing.
  const double circle = 60 * std::pow(2.0 - 2.0 * std::cos(2.0 * M_PI / 60), 2);
  const double left = roughness(loopPoints(s.after, s.loop)) - circle, was = roughness(loopPoints(s.before, s.loop));
  QVERIFY2(left < 1e-3 * was, qPrintable(QString("%1 of %2").arg(left).arg(was)));
  for (const Vec3& p : loopPoints(s.after, s.loop)) QVERIFY(std::abs(p.norm() - 1.0) < 0.005);
}

void BoundarySmoothingTest::aCircleStays() {
  for (const std::uint32_t n : {24u, 60u, 400u}) {
    const Smoothed s(test::disc(n, 4));
    QCOMPARE(s.problem(), std::string());
    for (const VertexMove& m : s.border.moves) QVERIFY((m.to - m.from).norm() < 0.02);
  }
}

// Points that crowd on one side spread; the circle stays one.
void BoundarySmoothingTest::spacingOnly() {
  TriangleSoup soup = test::disc(48, 2);
  for (Vec3& p : soup.points) {
    const double u = std::atan2(p.y(), p.x()) + 0.05 * std::sin(8.0 * std::atan2(p.y(), p.x()));
    if (p.norm() > 0.9) p = Vec3(std::cos(u), std::sin(u), 0.0);
  }
  const auto unevenness = [](const std::vector<Vec3>& p) {
    double least = 1e300, most = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double d = (p[(i + 1) % p.size()] - p[i]).norm();
      least = std::min(least, d);
      most = std::max(most, d);
    }
    return most / least;
  };
  const Smoothed even(soup, {0.0, true});
  QVERIFY(unevenness(loopPoints(even.before, even.loop)) > 1.5);
  QVERIFY(unevenness(loopPoints(even.after, even.loop)) < 1.01);
  for (const Vec3& p : loopPoints(even.after, even.loop)) QVERIFY(std::abs(p.norm() - 1.0) < 1e-3);
  const Smoothed nothing(soup, {0.0, false});
  QVERIFY(test::sameMesh(nothing.before, nothing.after));
}

void BoundarySmoothingTest::pinchesAndSeamsStay() {
  for (std::size_t which = 0; which < 3; ++which) {
    const Smoothed s(test::plateWithPinchedHole(), {}, which);
    QCOMPARE(s.problem(), std::string());
    std::size_t atPinch = 0;
    for (Vertex v = 0; v < s.after.vertexSlots(); ++v) atPinch += s.after.position(v) == Vec3::Zero();
    QCOMPARE(atPinch, std::size_t(2));
    QVERIFY(!s.border.moves.empty());
  }
}

void BoundarySmoothingTest::smallestLoop() {
  TriangleSoup soup = test::icosphere(2);
  soup.triangles.pop_back();
  const Smoothed s(soup);
  QCOMPARE(s.loop.halfEdges.size(), std::size_t(3));
  QCOMPARE(s.problem(), std::string());
  for (const VertexMove& m : s.border.moves) QVERIFY((m.to - m.from).norm() < 0.1 * s.loop.length);
}

void BoundarySmoothingTest::facesKeepTheirSides() {
  QVERIFY(rc::check([] {
    const auto seed = *rc::gen::arbitrary<unsigned>();
    std::mt19937 random(seed);
    TriangleSoup soup = *rc::gen::element(test::sphereWithHoles(3, 3, 0.4), test::plateWithTongue(),
                                          test::moebiusStrip(24, 3), test::cylinder(16, 5, 1.0, 3.0, false));
    std::uniform_real_distribution<double> noise(-0.05, 0.05);
    for (Vec3& p : soup.points) p += Vec3(noise(random), noise(random), noise(random));
    const double wavelength = *rc::gen::element(0.0, 4.0, 8.0, 40.0);
    const std::size_t loops = findBoundaryLoops(buildMesh(soup).mesh).size();
    const Smoothed s(soup, {wavelength, *rc::gen::arbitrary<bool>()}, random() % loops);
    RC_ASSERT(s.problem() == "");
  }));
}

void BoundarySmoothingTest::scalesAndOffsets() {
  const Smoothed plain(toothedDisc(60, 0.05));
  for (const double scale : {1e-6, 1e-3, 1e3, 1e6}) {
    const Smoothed s(test::moved(toothedDisc(60, 0.05), Vec3::Zero(), scale));
    QCOMPARE(s.problem(), std::string());
    for (Vertex v = 0; v < s.after.vertexSlots(); ++v)
      QVERIFY((s.after.position(v) / scale - plain.after.position(v)).norm() < 1e-9);
  }
  const Smoothed far(test::moved(toothedDisc(60, 0.05), Vec3::Constant(1e7)));
  QCOMPARE(far.problem(), std::string());
  for (Vertex v = 0; v < far.after.vertexSlots(); ++v)
    QVERIFY((far.after.position(v) - Vec3::Constant(1e7) - plain.after.position(v)).norm() < 1e-6);
}

void BoundarySmoothingTest::roundsToTheNumbersOfTheFile() {
  SmoothingOptions options;
  options.numbers = NumberType::Float32;
  const Smoothed exact(toothedDisc(24, 0.1)), single(toothedDisc(24, 0.1), options);
  QVERIFY(single.border.moves.size() > 12);
  QCOMPARE(single.border.moves.size(), exact.border.moves.size());
  QCOMPARE(single.problem(), std::string());
  for (std::size_t i = 0; i < single.border.moves.size(); ++i) {
    const Vec3& to = single.border.moves[i].to;
    QCOMPARE(to, Vec3(to.cast<float>().cast<double>()));
    QVERIFY((to - exact.border.moves[i].to).norm() < 1e-6);
  }
}

void BoundarySmoothingTest::staleMoves() {
  Smoothed s(toothedDisc(24, 0.05));
  const HalfEdgeMesh moved = s.after;
  QVERIFY(!moveVertices(s.after, s.border.moves));
  QVERIFY(test::sameMesh(s.after, moved));
  QVERIFY(!moveVertices(s.after, {{static_cast<Vertex>(s.after.vertexSlots()), Vec3::Zero(), Vec3::Zero()}}));
}

HANDWHEEL_TEST(BoundarySmoothingTest)
#include "BoundarySmoothingTest.moc"

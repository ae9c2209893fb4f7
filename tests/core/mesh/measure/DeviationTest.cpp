// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/measure/Deviation.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/search/SurfaceDistance.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshErrors.h"

#include <rapidcheck.h>

#include <QTest>
#include <numeric>

using namespace handwheel;

class DeviationTest : public QObject {
  Q_OBJECT

 private slots:
  void concentricSpheres();
  void shiftedPlanes();
  void tiltedPlane();
  void verticesAloneAreWeighedByArea();
  void againstAllTriangles();
  void signAgainstSolidAngle();
  void signAtSharpEdges();
  void oneTriangle();
  void nothingToMeasure();
  void facesWithoutArea();
  void farFromTheOrigin();
  void tooLarge();
  void cancelled();
  void theSameEveryTime();
};

namespace {

HalfEdgeMesh deviationMeshOf(const TriangleSoup& soup) {
  return buildMesh(soup).mesh;
}

Deviation measured(const TriangleSoup& a, const TriangleSoup& b, const DeviationOptions& options = {}) {
  const auto result = deviation(deviationMeshOf(a), deviationMeshOf(b), options);
  if (!result) qFatal("no deviation");
  return *result;
}

TriangleSoup sheet(std::uint32_t n, double from, double to, const std::function<double(double, double)>& height) {
  return test::grid(n + 1, n + 1, false, false, [&](std::uint32_t i, std::uint32_t j) {
    const double x = from + (to - from) * i / n, y = from + (to - from) * j / n;
    return Vec3(x, y, height(x, y));
  });
}

// The distance of the nearest plane of a face from the origin.
double innerRadius(const TriangleSoup& s) {
  double least = 1e300;
  for (const Triangle& t : s.triangles) {
    const Vec3 &a = s.points[t[0]], normal = (s.points[t[1]] - a).cross(s.points[t[2]] - a).normalized();
    least = std::min(least, std::abs(a.dot(normal)));
  }
  return least;
}

double toSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double length = (b - a).squaredNorm();
  const double t = length > 0.0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
  return (a + t * (b - a) - p).norm();
}

// By the foot on the plane where it falls within all three edges, else by the edges.
double toTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  const double edges = std::min({toSegment(p, a, b), toSegment(p, b, c), toSegment(p, c, a)});
  if (!(n.norm() > 0.0)) return edges;
  const auto within = [&](const Vec3& u, const Vec3& v) { return (v - u).cross(p - u).dot(n) >= 0.0; };
  if (!within(a, b) || !within(b, c) || !within(c, a)) return edges;
  return std::min(edges, std::abs((p - a).dot(n.normalized())));
}

double toSoup(const Vec3& p, const TriangleSoup& s) {
  double least = 1e300;
  for (const Triangle& t : s.triangles)
    least = std::min(least, toTriangle(p, s.points[t[0]], s.points[t[1]], s.points[t[2]]));
  return least;
}

// Van Oosterom and Strackee, "The solid angle of a plane triangle" (1983): 1 inside, 0 outside.
double windingNumber(const Vec3& p, const TriangleSoup& s) {
  double sum = 0.0;
  for (const Triangle& t : s.triangles) {
    const Vec3 a = s.points[t[0]] - p, b = s.points[t[1]] - p, c = s.points[t[2]] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (4.0 * M_PI);
}

Vec3 randomPoint(double reach) {
  const auto coordinate = [&] { return reach * (*rc::gen::inRange(-10000, 10001)) / 10000.0; };
  return {coordinate(), coordinate(), coordinate()};
}

}  // namespace

// The smaller one's corners are the nearest of the larger one's. Between corners both lie within their inner and outer
// radii.
void DeviationTest::concentricSpheres() {
  const TriangleSoup inner = test::icosphere(4), outer = test::moved(inner, Vec3::Zero(), 1.1);
  const double least = 1.1 * innerRadius(inner) - 1.0, most = 1.1 - innerRadius(inner);
  const Deviation d = measured(outer, inner);
  for (double distance : d.ofMesh.atVertex) QVERIFY(std::abs(distance - 0.1) < 1e-12);
  QCOMPARE(d.ofMesh.vertices, outer.points.size());
  QCOMPARE(d.ofMesh.samples, DeviationOptions().samples);
  QVERIFY(least > 0.09 && most < 0.11);
  for (double value : {d.ofMesh.mean, d.ofMesh.meanAbsolute, d.ofMesh.rms, d.ofMesh.highest.distance,
                       d.ofMesh.lowest.distance, d.ofMesh.percentiles[0], d.ofMesh.percentiles[3]})
    QVERIFY(value >= least - 1e-12 && value <= most + 1e-12);
  // From inside the sign is the other one.
  for (double value : {d.ofScan.mean, -d.ofScan.rms, d.ofScan.highest.distance, d.ofScan.lowest.distance})
    QVERIFY(value <= -least + 1e-12 && value >= -most - 1e-12);
  QVERIFY(std::abs(d.ofMesh.area - 1.21 * d.ofScan.area) < 1e-9);
  QCOMPARE(d.hausdorff(), std::max(d.ofMesh.highest.distance, -d.ofScan.lowest.distance));
  const DeviationExtremum& farthest = d.ofMesh.farthest();
  QVERIFY(std::abs((farthest.position - farthest.nearest).norm() - farthest.distance) < 1e-15);
}

void DeviationTest::shiftedPlanes() {
  const auto low = sheet(7, -1, 1, [](double, double) { return 0.0; });
  const auto high = sheet(5, -1, 1, [](double, double) { return 0.25; });
  const Deviation d = measured(high, low);
  for (double value : {d.ofMesh.mean, d.ofMesh.meanAbsolute, d.ofMesh.rms, d.ofMesh.percentiles[0],
                       d.ofMesh.percentiles[3], d.ofMesh.lowest.distance, d.ofMesh.highest.distance, d.hausdorff()})
    QVERIFY(std::abs(value - 0.25) < 1e-12);
  QVERIFY(std::abs(d.ofScan.mean + 0.25) < 1e-12);
  QVERIFY(std::abs(d.ofMesh.area - 4.0) < 1e-12);
  QCOMPARE(d.ofMesh.histogram.size(), std::size_t{50});
  QVERIFY(std::abs(std::accumulate(d.ofMesh.histogram.begin(), d.ofMesh.histogram.end(), 0.0) - 1.0) < 1e-9);
}

// Distances spread evenly from 0 to 0.2.
void DeviationTest::tiltedPlane() {
  const auto ground = sheet(9, -20, 20, [](double, double) { return 0.0; });
  const auto ramp = sheet(13, -5, 5, [](double x, double) { return 0.1 + 0.02 * x; });
  const SurfaceDeviation d = measured(ramp, ground, {.samples = 100'000, .bins = 10}).ofMesh;
  QVERIFY(std::abs(d.mean - 0.1) < 1e-4);
  QVERIFY(std::abs(d.rms - std::sqrt(0.01 + 0.01 / 3.0)) < 1e-4);
  for (std::size_t i = 0; i < kDeviationPercentiles.size(); ++i)
    QVERIFY(std::abs(d.percentiles[i] - 0.002 * kDeviationPercentiles[i]) < 5e-4);
  for (double share : d.histogram) QVERIFY(std::abs(share - 0.1) < 2e-3);
  QVERIFY(std::abs(d.lowest.distance) < 1e-12 && std::abs(d.highest.distance - 0.2) < 1e-12);
  QVERIFY(std::abs(d.highest.position.x() - 5.0) < 1e-12);
}

// Nine tenths of the points crowd in the lowest tenth of the ramp.
void DeviationTest::verticesAloneAreWeighedByArea() {
  const auto ground = sheet(3, -20, 20, [](double, double) { return 0.0; });
  const TriangleSoup ramp = test::grid(101, 2, false, false, [](std::uint32_t i, std::uint32_t j) {
    const double x = i <= 90 ? i / 900.0 : 0.1 + 0.09 * (i - 90);
    return Vec3(x, j, x);
  });
  const SurfaceDeviation d = measured(ramp, ground, {.samples = 0}).ofMesh;
  QCOMPARE(d.samples, std::size_t{0});
  QVERIFY(std::abs(d.mean - 0.5) < 0.01);
  QVERIFY(std::abs(d.rms - std::sqrt(1.0 / 3.0)) < 0.01);
  QVERIFY(std::abs(d.percentiles[1] - 0.9) < 0.1);
}

void DeviationTest::againstAllTriangles() {
  QVERIFY(rc::check("every vertex has the least distance of all triangles", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto steps = *rc::gen::inRange<std::uint32_t>(2, 30);
    const TriangleSoup a = test::randomSoup(random, *rc::gen::inRange<std::size_t>(1, 30), steps);
    const TriangleSoup b = test::randomSoup(random, *rc::gen::inRange<std::size_t>(1, 60), steps);
    TriangleSoup solid = b;  // the triangles with an area, or all if none has one
    std::erase_if(solid.triangles, [&](const Triangle& t) {
      return isDegenerate({b.points[t[0]], b.points[t[1]], b.points[t[2]]});
    });
    const HalfEdgeMesh mesh = deviationMeshOf(a);
    const auto result = deviation(mesh, deviationMeshOf(b), {.samples = 50, .bins = 3});
    RC_ASSERT(bool(result));
    double largest = 0.0;
    for (Vertex v = 0; v < mesh.vertexSlots(); ++v) {
      const double distance = std::abs(result->ofMesh.atVertex[v]);
      if (std::isnan(distance)) continue;
      RC_ASSERT(std::abs(distance - toSoup(mesh.position(v), solid.triangles.empty() ? b : solid)) < 1e-9);
      largest = std::max(largest, distance);
    }
    RC_ASSERT(std::abs(result->ofMesh.farthest().distance) >= largest);
    RC_ASSERT(result->ofMesh.vertices > 0u);
  }));
}

void DeviationTest::signAgainstSolidAngle() {
  const TriangleSoup shapes[] = {test::bumpySphere(2), test::torus(20, 10), test::cube(), test::tetrahedron()};
  for (const TriangleSoup& shape : shapes) {
    const SurfaceDistance surface(deviationMeshOf(shape));
    QVERIFY(rc::check("below zero where the surface winds around the point", [&] {
      const Vec3 p = randomPoint(1.5);
      const auto nearest = surface.from(p);
      RC_ASSERT(bool(nearest));
      RC_ASSERT(std::abs(std::abs(nearest->distance) - toSoup(p, shape)) < 1e-12);
      if (std::abs(nearest->distance) > 1e-9) RC_ASSERT((nearest->distance < 0.0) == (windingNumber(p, shape) > 0.5));
    }));
  }
}

// Nearest to a needle-sharp corner, the normal of one face alone would tell the wrong side.
void DeviationTest::signAtSharpEdges() {
  TriangleSoup spike = test::tetrahedron();
  spike.points[3] = Vec3(0.01, 0.02, 10.0);
  const SurfaceDistance surface(deviationMeshOf(spike));
  for (const Vec3& d : test::directions(200)) {
    const Vec3 p = spike.points[3] + 0.5 * d;
    QCOMPARE(surface.from(p)->distance<0.0, windingNumber(p, spike)> 0.5);
  }
}

void DeviationTest::oneTriangle() {
  const TriangleSoup a{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}};
  const Deviation same = measured(a, a);
  QVERIFY(same.hausdorff() < 1e-15);
  QVERIFY(same.ofMesh.rms < 1e-15);
  const Deviation apart = measured(a, test::moved(a, Vec3(0, 0, -3)));
  QVERIFY(std::abs(apart.ofMesh.mean - 3.0) < 1e-10);  // 200,000 roundings
  QCOMPARE(apart.ofMesh.vertices, std::size_t{3});
}

void DeviationTest::nothingToMeasure() {
  const HalfEdgeMesh none, one = deviationMeshOf(test::cube());
  for (const auto& result : {deviation(none, one), deviation(one, none), deviation(none, none)}) {
    QVERIFY(!result);
    QCOMPARE(result.error().code, MeshError::NoTriangles);
  }
}

void DeviationTest::facesWithoutArea() {
  const TriangleSoup plain = test::cube();
  TriangleSoup needles = plain;
  test::addNeedles(needles, 3, 1, {0.25, 0.5});
  needles.points.emplace_back(9.0, 9.0, 9.0);
  needles.triangles.push_back({0, 0, static_cast<std::uint32_t>(needles.points.size() - 1)});
  const Deviation d = measured(needles, plain);
  QVERIFY(d.hausdorff() < 1e-12);
  QVERIFY(std::isnan(d.ofMesh.atVertex[deviationMeshOf(needles).triangle(14)[2]]) ||
          d.ofMesh.vertices < needles.points.size());
  // Degenerate triangles are measured if there are no others: a segment and a point.
  const TriangleSoup segment{{Vec3(0, 0, 0), Vec3(4, 0, 0)}, {{0, 1, 1}}}, point{{Vec3(1, 2, 0)}, {{0, 0, 0}}};
  const Deviation flat = measured(segment, point);
  QCOMPARE(flat.ofMesh.samples, std::size_t{0});
  QVERIFY(std::abs(flat.hausdorff() - std::sqrt(13.0)) < 1e-12);
  QVERIFY(std::abs(std::abs(flat.ofScan.mean) - 2.0) < 1e-12);
  QVERIFY(std::abs(flat.ofMesh.meanAbsolute - 0.5 * (std::sqrt(5.0) + std::sqrt(13.0))) < 1e-12);
}

void DeviationTest::farFromTheOrigin() {
  const Vec3 far(3e7, -2e7, 1e7);
  const TriangleSoup a = test::bumpySphere(3), b = test::icosphere(3);
  const Deviation near = measured(a, b), away = measured(test::moved(a, far), test::moved(b, far));
  constexpr double kRounding = 1e-7;  // some ulps of 3e7
  QVERIFY(std::abs(near.ofMesh.mean - away.ofMesh.mean) < kRounding);
  QVERIFY(std::abs(near.ofMesh.rms - away.ofMesh.rms) < kRounding);
  QVERIFY(std::abs(near.hausdorff() - away.hausdorff()) < kRounding);
  for (std::size_t v = 0; v < near.ofMesh.atVertex.size(); ++v)
    QVERIFY(std::abs(near.ofMesh.atVertex[v] - away.ofMesh.atVertex[v]) < kRounding);
}

void DeviationTest::tooLarge() {
  const HalfEdgeMesh large = deviationMeshOf(test::moved(test::cube(), Vec3::Zero(), 1e70)),
                     small = deviationMeshOf(test::cube());
  QCOMPARE(deviation(large, small).error().code, ErrorCode::ValueOutOfRange);
  QCOMPARE(deviation(small, large).error().code, ErrorCode::ValueOutOfRange);
  QVERIFY(bool(deviation(deviationMeshOf(test::moved(test::cube(), Vec3::Zero(), 1e59)), small)));
}

void DeviationTest::cancelled() {
  JobState job;
  job.cancelled = true;
  const HalfEdgeMesh mesh = deviationMeshOf(test::cube());
  QCOMPARE(deviation(mesh, mesh, {}, Progress(job)).error().code, ErrorCode::Cancelled);
  job.cancelled = false;
  QVERIFY(bool(deviation(mesh, mesh, {}, Progress(job))));
  QVERIFY(job.fraction > 0.9);
}

void DeviationTest::theSameEveryTime() {
  const TriangleSoup a = test::bumpySphere(3), b = test::icosphere(2);
  const Deviation first = measured(a, b), second = measured(a, b);
  QCOMPARE(first.ofMesh.rms, second.ofMesh.rms);
  QCOMPARE(first.ofMesh.atVertex, second.ofMesh.atVertex);
  QCOMPARE(first.ofScan.percentiles, second.ofScan.percentiles);
  QVERIFY(first.ofMesh.highest.position == second.ofMesh.highest.position);
}

HANDWHEEL_TEST(DeviationTest)
#include "DeviationTest.moc"

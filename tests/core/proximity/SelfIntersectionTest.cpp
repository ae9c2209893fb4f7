// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Surfaces.h"
#include "proximity/SelfIntersection.h"
#include "proximity/TriangleIntersection.h"

#include <rapidcheck.h>
#include <tbb/task_arena.h>

#include <QTest>
#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include "TestClass.h"  // after TBB

using namespace handwheel;
using test::Surface;

namespace {

std::vector<TrianglePair> bruteForce(const Surface& s) {
  const auto takesPart = [&](std::size_t i) {
    const auto t = s.corners(i);
    return t[0].allFinite() && t[1].allFinite() && t[2].allFinite() && !isDegenerate(t);
  };
  std::vector<TrianglePair> pairs;
  for (std::uint32_t i = 0; i < s.triangles.size(); ++i)
    for (std::uint32_t j = i + 1; j < s.triangles.size(); ++j)
      if (takesPart(i) && takesPart(j) && trianglesMeet(s.corners(i), s.corners(j))) pairs.emplace_back(i, j);
  return pairs;
}

std::vector<TrianglePair> found(const Surface& s) {
  return selfIntersections(s.points, s.triangles).value();
}

// Its tip is the first point, at the origin, and its rim as high above it as said.
Surface cone(std::uint32_t n, double height) {
  Surface s;
  s.points.push_back(Vec3::Zero());
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2.0 * M_PI * i / n;
    s.points.push_back(Vec3(std::cos(angle), std::sin(angle), height));
    s.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  return s;
}

}  // namespace

class SelfIntersectionTest : public QObject {
  Q_OBJECT

 private slots:
  void nothing();
  void sphereHasNone();
  void spheresThatPenetrate();
  void spheresApart();
  void doubledSphere();
  void foldedStrip();
  void soupsAgainstBruteForce();
  void strayAndUnusableTriangles();
  void sameForAnyNumberOfThreads();
  void keepsToTheLimit();
  void fansCostNoMoreThanTheirTriangles();
  void crossingFans();
  void sliversAgainstBruteForce();
  void cancels();
  void reportsProgress();
};

void SelfIntersectionTest::nothing() {
  QVERIFY(found({}).empty());
  QVERIFY(found({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}}).empty());
}

// A radial function over the sphere is embedded.
void SelfIntersectionTest::sphereHasNone() {
  QVERIFY(found(test::sphere(40)).empty());
  QVERIFY(found(test::sphere(40, Vec3(1e7, -1e7, 1e7), 3.0, 0.1)).empty());
  QVERIFY(found(test::sphere(40, Vec3::Zero(), 1e-6, 0.1)).empty());
}

void SelfIntersectionTest::spheresThatPenetrate() {
  Surface s = test::sphere(12);
  const auto first = static_cast<std::uint32_t>(s.triangles.size());
  s.append(test::sphere(12, Vec3(0.71, 0.32, 0.13)));
  const auto pairs = found(s);
  // The curve of intersection crosses triangles of both all along; none meets one of its own sphere.
  QVERIFY(pairs.size() > 40);
  for (const auto& [i, j] : pairs) QVERIFY(i < first && j >= first);
  QCOMPARE(pairs, bruteForce(s));
}

void SelfIntersectionTest::spheresApart() {
  Surface s = test::sphere(12);
  s.append(test::sphere(12, Vec3::Zero(), 0.5));
  s.append(test::sphere(12, Vec3(3, 0, 0)));
  QVERIFY(found(s).empty());
}

// Each triangle meets its double, and its double's neighbours no more than its own.
void SelfIntersectionTest::doubledSphere() {
  Surface s = test::sphere(10, Vec3::Zero(), 1.0, 0.1);
  const auto n = static_cast<std::uint32_t>(s.triangles.size());
  s.append(s);
  std::vector<TrianglePair> expected;
  for (std::uint32_t i = 0; i < n; ++i) expected.emplace_back(i, i + n);
  QCOMPARE(found(s), expected);
}

// Two triangles over an edge, the second laid back onto the first or not.
void SelfIntersectionTest::foldedStrip() {
  Surface s{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)}, {{0, 1, 2}, {1, 0, 3}}};
  QCOMPARE(found(s), (std::vector<TrianglePair>{{0, 1}}));
  s.points[3] = Vec3(1, 1, 0.001);
  QVERIFY(found(s).empty());
  s.points[3] = Vec3(1, -1, 0);
  QVERIFY(found(s).empty());
}

void SelfIntersectionTest::soupsAgainstBruteForce() {
  QVERIFY(rc::check([] {
    const auto count = *rc::gen::inRange<std::size_t>(0, 200);
    const double size = *rc::gen::element(0.02, 0.1, 0.5);
    const int steps = *rc::gen::element(0, 4, 32);
    const Vec3 shift = *rc::gen::element(Vec3(0, 0, 0), Vec3(1e7, 1e7, 1e7));
    const double scale = *rc::gen::element(1.0, 1e-6, 1e7);
    const Surface s = test::moved(test::soup(count, size, steps, *rc::gen::arbitrary<std::uint32_t>()), scale, shift);
    RC_ASSERT(found(s) == bruteForce(s));
  }));
}

void SelfIntersectionTest::strayAndUnusableTriangles() {
  Surface s = test::soup(300, 0.1, 16, 7);
  s.points[5].x() = std::numeric_limits<double>::quiet_NaN();
  s.points[50].y() = std::numeric_limits<double>::infinity();
  s.points[100] = Vec3(1e30, -1e30, 1e30);
  s.points[200] = Vec3(1e200, 0, 0);
  QCOMPARE(found(s), bruteForce(s));
}

void SelfIntersectionTest::sameForAnyNumberOfThreads() {
  const Surface s = test::soup(20000, 0.02, 0, 3);
  const auto pairs = found(s);
  QVERIFY(!pairs.empty());
  QVERIFY(std::is_sorted(pairs.begin(), pairs.end()));
  tbb::task_arena alone(1);
  alone.execute([&] { QCOMPARE(found(s), pairs); });
}

void SelfIntersectionTest::keepsToTheLimit() {
  const Surface s = test::soup(3000, 0.2, 0, 5);
  const auto all = found(s);
  const std::size_t limit = all.size() / 3;
  const auto some = selfIntersections(s.points, s.triangles, {}, limit).value();
  QCOMPARE(some.size(), limit);
  QVERIFY(std::includes(all.begin(), all.end(), some.begin(), some.end()));
  tbb::task_arena alone(1);
  alone.execute([&] { QCOMPARE(selfIntersections(s.points, s.triangles, {}, limit).value(), some); });
  QCOMPARE(selfIntersections(s.points, s.triangles, {}, all.size()).value(), all);
  QVERIFY(selfIntersections(s.points, s.triangles, {}, 0).value().empty());
}

// A cone of n triangles, whose boxes all meet at its tip: 200 times as many cost no more than that many times the
// effort, with the logarithm, where each pair would be 40,000 times as much.
void SelfIntersectionTest::fansCostNoMoreThanTheirTriangles() {
  const auto effortFor = [](std::uint32_t n) {
    WorkBudget effort(1'000'000'000);
    const Surface s = cone(n, 1.0);
    const auto pairs = selfIntersections(s.points, s.triangles, Progress().within(effort));
    return pairs && pairs->empty() ? static_cast<double>(effort.spent()) : -1.0;
  };
  const double few = effortFor(250), many = effortFor(50'000);
  QVERIFY(few > 0.0 && many > 0.0);
  QVERIFY2(many < 400.0 * few, qPrintable(QString("%1 steps, and %2").arg(few).arg(many)));
}

// Two cones with one tip, the second slanted: it crosses the first along two lines.
void SelfIntersectionTest::crossingFans() {
  Surface s = cone(150, 1.0);
  const Surface slanted = cone(170, 0.5);
  const auto n = static_cast<std::uint32_t>(s.points.size());
  for (std::size_t i = 1; i < slanted.points.size(); ++i) s.points.push_back(slanted.points[i] + Vec3(0.5, 0.07, 0.3));
  for (const Triangle& t : slanted.triangles) s.triangles.push_back({0, t[1] + n - 1, t[2] + n - 1});
  const auto pairs = found(s);
  QVERIFY(!pairs.empty());
  QCOMPARE(pairs, bruteForce(s));
}

void SelfIntersectionTest::sliversAgainstBruteForce() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0), near(-1e-3, 1e-3);
  Surface s;
  for (std::uint32_t i = 0; i < 2500; ++i) {  // fewer are not cut
    const Vec3 from(anywhere(random), anywhere(random), anywhere(random));
    const Vec3 to(anywhere(random), anywhere(random), anywhere(random));
    s.points.insert(s.points.end(), {from, to, to + Vec3(near(random), near(random), near(random))});
    s.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  // Neighbours along a long edge, and others across them.
  for (std::uint32_t i = 0; i < 100; ++i) s.triangles.push_back({3 * i, 3 * i + 2, 3 * i + 4});
  const auto pairs = found(s);
  QVERIFY(!pairs.empty());
  QCOMPARE(pairs, bruteForce(s));
  QCOMPARE(selfIntersections(s.points, s.triangles, {}, pairs.size() / 2)->size(), pairs.size() / 2);
}

void SelfIntersectionTest::cancels() {
  // Every pair of boxes overlaps: minutes of work.
  const Surface s = test::soup(60000, 1.0, 0, 9);
  JobState before;
  before.cancelled = true;
  QVERIFY(!selfIntersections(s.points, s.triangles, Progress(before)));

  JobState during;
  std::thread canceller([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    during.cancelled = true;
  });
  const auto pairs =
      selfIntersections(s.points, s.triangles, Progress(during), std::numeric_limits<std::size_t>::max());
  canceller.join();
  QVERIFY(!pairs);
}

void SelfIntersectionTest::reportsProgress() {
  const Surface s = test::sphere(30);
  JobState job;
  QVERIFY(selfIntersections(s.points, s.triangles, Progress(job).part(0.25, 0.75)));
  QCOMPARE(job.fraction.load(), 0.75);
}

HANDWHEEL_TEST(SelfIntersectionTest)
#include "SelfIntersectionTest.moc"

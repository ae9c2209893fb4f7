// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "proximity/TriangleIntersection.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <rapidcheck.h>

#include <QTest>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

using namespace handwheel;

namespace {

using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;

Exact::Triangle_3 exact(const TrianglePoints& t) {
  const auto point = [](const Vec3& p) { return Exact::Point_3(p.x(), p.y(), p.z()); };
  return {point(t[0]), point(t[1]), point(t[2])};
}

// The definition itself: the intersection, constructed in rational numbers, is more than what the corners share.
bool meetByDefinition(const TrianglePoints& a, const TrianglePoints& b) {
  const auto common = CGAL::intersection(exact(a), exact(b));
  if (!common) return false;
  std::vector<Exact::Point_3> shared;
  for (const Vec3& p : a)
    if (std::find(b.begin(), b.end(), p) != b.end()) shared.emplace_back(p.x(), p.y(), p.z());
  if (const auto* point = boost::get<Exact::Point_3>(&*common)) return shared.size() != 1 || *point != shared[0];
  if (const auto* segment = boost::get<Exact::Segment_3>(&*common)) {
    if (shared.size() != 2) return true;
    const Exact::Segment_3 edge(shared[0], shared[1]);
    return *segment != edge && *segment != edge.opposite();
  }
  return true;
}

TrianglePoints turned(const TrianglePoints& t, int rotation, bool reversed) {
  const auto at = [&](int i) { return t[(i + rotation) % 3]; };
  return reversed ? TrianglePoints{at(0), at(2), at(1)} : TrianglePoints{at(0), at(1), at(2)};
}

TrianglePoints moved(const TrianglePoints& t, double scale, const Vec3& shift) {
  return {t[0] * scale + shift, t[1] * scale + shift, t[2] * scale + shift};
}

// In all orders of the corners and of the triangles.
std::vector<bool> allAnswers(const TrianglePoints& a, const TrianglePoints& b) {
  std::vector<bool> answers;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      answers.push_back(trianglesMeet(turned(a, i / 2, i % 2), turned(b, j / 2, j % 2)));
      answers.push_back(trianglesMeet(turned(b, j / 2, j % 2), turned(a, i / 2, i % 2)));
    }
  return answers;
}

rc::Gen<TrianglePoints> gridTriangle(int steps) {
  return rc::gen::map(rc::gen::container<std::array<int, 9>>(rc::gen::inRange(0, steps)), [](std::array<int, 9> v) {
    return TrianglePoints{Vec3(v[0], v[1], v[2]), Vec3(v[3], v[4], v[5]), Vec3(v[6], v[7], v[8])};
  });
}

// In [0, 1), with all 53 bits.
rc::Gen<double> coordinate() {
  return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()),
                      [](std::uint64_t bits) { return std::ldexp(static_cast<double>(bits >> 11), -53); });
}

const TrianglePoints kFloor{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

}  // namespace

class TriangleIntersectionTest : public QObject {
  Q_OBJECT

 private slots:
  // Contacts are rare events: many small cases.
  void initTestCase() { qputenv("RC_PARAMS", qgetenv("RC_PARAMS") + " max_success=3000"); }
  void known_data();
  void known();
  void oneUlp_data();
  void oneUlp();
  void agreesWithRationalConstruction();
  void agreesOnNearlyFlatPairs();
  void sharedCornersAgreeWithRationalConstruction();
  void invariantUnderOrder();
  void manyThreads();
  void degenerate_data();
  void degenerate();
  void degenerateAgreesWithRationals();
};

void TriangleIntersectionTest::known_data() {
  QTest::addColumn<QList<double>>("corners");
  QTest::addColumn<bool>("meet");
  const auto row = [](const char* name, const QList<double>& corners, bool meet) {
    QTest::newRow(name) << corners << meet;
  };
  // The other triangle is (0,0,0) (4,0,0) (0,4,0).
  row("far away", {9, 9, 9, 10, 9, 9, 9, 10, 9}, false);
  row("parallel above", {0, 0, 1, 4, 0, 1, 0, 4, 1}, false);
  row("boxes overlap, beyond the long edge", {4, 4, -1, 3, 3, 1, 4, 3, 1}, false);
  row("pierces the inside", {1, 1, -1, 1, 1, 1, 9, 9, 1}, true);
  row("pierced by an edge of the floor", {2, -1, -1, 2, -1, 1, 2, 1, 0}, true);
  row("corner touches the inside", {1, 1, 0, 1, 1, 1, 2, 1, 1}, true);
  row("corner touches an edge", {2, 0, 0, 2, 0, 1, 3, -1, 1}, true);
  row("edges cross", {2, -1, 0, 2, 1, 1, 2, -1, 1}, false);
  row("edges cross in one point", {2, -1, -1, 2, 1, 1, 2, -3, 1}, true);
  row("edge lies in the inside", {1, 1, 0, 2, 1, 0, 1, 1, 3}, true);
  row("coplanar apart, boxes overlap", {3, 3, 0, 4, 3, 0, 3, 4, 0}, false);
  row("coplanar overlap", {1, 1, 0, 5, 1, 0, 1, 5, 0}, true);
  row("coplanar inside", {1, 1, 0, 2, 1, 0, 1, 2, 0}, true);
  row("coplanar around", {-9, -9, 0, 99, -9, 0, -9, 99, 0}, true);
  row("coplanar, a corner on an edge", {2, 0, 0, 1, -3, 0, 3, -3, 0}, true);
  row("coplanar, collinear edges overlap", {1, 0, 0, 3, 0, 0, 2, -3, 0}, true);
  row("coplanar, collinear edges apart", {5, 0, 0, 7, 0, 0, 6, -3, 0}, false);
  row("coplanar T-junction sharing a corner", {0, 0, 0, 2, 0, 0, 1, -3, 0}, true);
  row("T-junction out of the plane", {0, 0, 0, 2, 0, 0, 1, 0, 3}, true);
  row("shares a corner only", {0, 0, 0, -1, 0, 1, 0, -1, 1}, false);
  row("shares a corner, coplanar, apart", {0, 0, 0, -4, 0, 0, 0, -4, 0}, false);
  row("shares a corner, coplanar, overlaps", {0, 0, 0, 2, 1, 0, 1, 2, 0}, true);
  row("shares a corner, coplanar, runs along an edge", {0, 0, 0, 9, 0, 0, 5, -5, 0}, true);
  row("shares a corner and pierces", {0, 0, 0, 1, 1, 1, 1, 1, -1}, true);
  row("shares a corner, plane pierced beyond the edge", {0, 0, 0, 4, 4, 1, 4, 4, -1}, true);
  row("shares a corner, opposite edge passes outside", {0, 0, 0, -1, -1, 1, -1, -1, -1}, false);
  row("shares a corner, the other edge touches", {0, 0, 0, 1, 1, 0, 1, 1, 5}, true);
  row("shares an edge, open", {0, 0, 0, 4, 0, 0, 0, 0, 4}, false);
  row("shares an edge, flat and unfolded", {0, 0, 0, 4, 0, 0, 1, -4, 0}, false);
  row("shares an edge, folded flat", {0, 0, 0, 4, 0, 0, 1, 1, 0}, true);
  row("shares an edge, folded flat beyond", {0, 0, 0, 4, 0, 0, 9, 9, 0}, true);
  row("shares an edge, almost folded flat", {0, 0, 0, 4, 0, 0, 1, 1, 1e-300}, false);
  row("doubled", {0, 0, 0, 4, 0, 0, 0, 4, 0}, true);
  row("doubled, reversed", {0, 0, 0, 0, 4, 0, 4, 0, 0}, true);
  row("negative zero is zero", {-0.0, 0, -0.0, -1, 0, 1, 0, -1, 1}, false);
}

void TriangleIntersectionTest::known() {
  QFETCH(QList<double>, corners);
  QFETCH(bool, meet);
  const auto at = [&](int i) { return Vec3(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]); };
  const TrianglePoints other{at(0), at(1), at(2)};
  // Whole numbers stay exact under these, so the answer stays the same.
  const std::vector<std::pair<double, Vec3>> motions = {{1, Vec3::Zero()},
                                                        {1, Vec3(1e7, -1e7, 1e7)},
                                                        {0x1p-20, Vec3::Zero()},
                                                        {0x1p-20, Vec3(8, 8, 8)},
                                                        {0x1p400, Vec3::Zero()}};
  for (const auto& [scale, shift] : motions) {
    if (qstrcmp(QTest::currentDataTag(), "shares an edge, almost folded flat") == 0 && !shift.isZero()) continue;
    for (const bool answer : allAnswers(moved(kFloor, scale, shift), moved(other, scale, shift)))
      QCOMPARE(answer, meet);
  }
  QCOMPARE(meetByDefinition(kFloor, other), meet);
}

void TriangleIntersectionTest::oneUlp_data() {
  QTest::addColumn<double>("below");
  QTest::addColumn<double>("scale");
  for (const double scale : {1.0, 1e-6, 1e7, 1.0 / 3.0}) {
    QTest::addRow("double, scale %g", scale) << std::nextafter(scale, 0.0) << scale;
    const auto single = static_cast<float>(scale);
    QTest::addRow("float, scale %g", scale) << double(std::nextafter(single, 0.0f)) << double(single);
  }
}

// A corner one ulp above a plane, on it, and below it.
void TriangleIntersectionTest::oneUlp() {
  QFETCH(double, below);
  QFETCH(double, scale);
  const double s = scale;
  const TrianglePoints plane{Vec3(-s, -s, s), Vec3(9 * s, -s, s), Vec3(-s, 9 * s, s)};
  const auto tipAt = [&](double z) { return TrianglePoints{Vec3(s, s, z), Vec3(s, 2 * s, -s), Vec3(2 * s, s, -s)}; };
  QVERIFY(!trianglesMeet(plane, tipAt(below)));
  QVERIFY(trianglesMeet(plane, tipAt(s)));
  // Tilted, so that no coordinate is alone responsible: on the plane x + y + z = 3 s, when that is exact.
  const double unit = s - below;
  const TrianglePoints tilted{Vec3(64 * unit, 0, 0), Vec3(0, 64 * unit, 0), Vec3(0, 0, 64 * unit)};
  const auto tip = [&](double x) {
    return TrianglePoints{Vec3(x, 16 * unit, 16 * unit), Vec3(0, 0, 0), Vec3(unit, unit, 0)};
  };
  QVERIFY(trianglesMeet(tilted, tip(32 * unit)));
  QVERIFY(!trianglesMeet(tilted, tip(std::nextafter(32 * unit, 0.0))));
}

void TriangleIntersectionTest::agreesWithRationalConstruction() {
  QVERIFY(rc::check([] {
    const int steps = *rc::gen::element(2, 3, 4, 8);
    const TrianglePoints a = *gridTriangle(steps);
    const TrianglePoints b = *gridTriangle(steps);
    RC_PRE(!isDegenerate(a) && !isDegenerate(b));
    const double scale = *rc::gen::element(1.0, 0x1p-20, 3e-7, 1e7 / 3.0);
    const Vec3 shift = *rc::gen::element(Vec3(0, 0, 0), Vec3(1e7, 1e7, -1e7));
    const TrianglePoints p = moved(a, scale, shift);
    const TrianglePoints q = moved(b, scale, shift);
    RC_PRE(!isDegenerate(p) && !isDegenerate(q));
    RC_ASSERT(trianglesMeet(p, q) == meetByDefinition(p, q));
  }));
}

// Corners within some ulps of one slanted plane: the floating-point filter must not decide wrongly.
void TriangleIntersectionTest::agreesOnNearlyFlatPairs() {
  QVERIFY(rc::check([] {
    const auto corner = [] {
      const double x = *coordinate(), y = *coordinate();
      const int ulps = *rc::gen::inRange(-2, 3);
      return Vec3(x, y, x / 3.0 + y / 7.0 + ulps * 0x1p-53);
    };
    const TrianglePoints a{corner(), corner(), corner()};
    TrianglePoints b{corner(), corner(), corner()};
    const int shared = *rc::gen::inRange(0, 3);
    for (int i = 0; i < shared; ++i) b[i] = a[i];
    RC_PRE(!isDegenerate(a) && !isDegenerate(b));
    RC_ASSERT(trianglesMeet(a, b) == meetByDefinition(a, b));
  }));
}

void TriangleIntersectionTest::sharedCornersAgreeWithRationalConstruction() {
  QVERIFY(rc::check([] {
    const int steps = *rc::gen::element(2, 3, 6);
    const TrianglePoints a = *gridTriangle(steps);
    TrianglePoints b = *gridTriangle(steps);
    const int shared = *rc::gen::inRange(1, 3);
    for (int i = 0; i < shared; ++i) b[i] = a[(i + 1) % 3];
    RC_PRE(!isDegenerate(a) && !isDegenerate(b));
    RC_ASSERT(trianglesMeet(a, b) == meetByDefinition(a, b));
  }));
}

void TriangleIntersectionTest::invariantUnderOrder() {
  QVERIFY(rc::check([] {
    const TrianglePoints a = *gridTriangle(5);
    const TrianglePoints b = *gridTriangle(5);
    RC_PRE(!isDegenerate(a) && !isDegenerate(b));
    const std::vector<bool> answers = allAnswers(a, b);
    RC_ASSERT(std::all_of(answers.begin(), answers.end(), [&](bool v) { return v == answers[0]; }));
  }));
}

// The exact numbers behind the predicates must not be shared between threads.
void TriangleIntersectionTest::manyThreads() {
  const TrianglePoints a{Vec3(0, 0, 0), Vec3(1, 0, 0.5), Vec3(0, 1, 0.5)};
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&] {
      for (int i = 1; i < 5000; ++i) {
        const double x = i / 16384.0;
        const TrianglePoints on{Vec3(x, x, x), Vec3(x, x, 9), Vec3(1, 1, 9)};
        const TrianglePoints above{Vec3(x, x, std::nextafter(x, 9.0)), Vec3(x, x, 9), Vec3(1, 1, 9)};
        wrong += !trianglesMeet(a, on) + trianglesMeet(a, above);
      }
    });
  for (std::thread& t : threads) t.join();
  QCOMPARE(wrong.load(), 0);
}

void TriangleIntersectionTest::degenerate_data() {
  QTest::addColumn<QList<double>>("corners");
  QTest::addColumn<bool>("expected");
  QTest::newRow("has area") << QList<double>{0, 0, 0, 1, 0, 0, 0, 1, 0} << false;
  QTest::newRow("two corners equal") << QList<double>{1, 2, 3, 1, 2, 3, 4, 5, 7} << true;
  QTest::newRow("all corners equal") << QList<double>{1, 2, 3, 1, 2, 3, 1, 2, 3} << true;
  QTest::newRow("on one line") << QList<double>{1, 2, 3, 2, 4, 6, 5, 10, 15} << true;
  QTest::newRow("needle of 1e-200") << QList<double>{0, 0, 0, 1, 0, 0, 2, 1e-200, 0} << false;
  QTest::newRow("tiny") << QList<double>{0, 0, 0, 1e-200, 0, 0, 0, 1e-200, 0} << false;
  QTest::newRow("huge, on one line") << QList<double>{0, 0, 0, 1e200, 1e200, 0, 2e200, 2e200, 0} << true;
  // 0.1, 0.2, 0.3 as doubles are not in proportion: 0.3 - 2 * 0.1 is not 0.1.
  QTest::newRow("decimals that only look collinear") << QList<double>{0, 0, 0, 0.1, 1, 0, 0.3, 3, 0} << false;
}

void TriangleIntersectionTest::degenerate() {
  QFETCH(QList<double>, corners);
  QFETCH(bool, expected);
  const auto at = [&](int i) { return Vec3(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]); };
  for (int i = 0; i < 6; ++i) QCOMPARE(isDegenerate(turned({at(0), at(1), at(2)}, i / 2, i % 2)), expected);
}

void TriangleIntersectionTest::degenerateAgreesWithRationals() {
  QVERIFY(rc::check([] {
    const Vec3 a(*coordinate(), *coordinate(), *coordinate());
    const Vec3 b(*coordinate(), *coordinate(), *coordinate());
    const double t = *rc::gen::element(0.5, 2.0, 1.0 / 3.0, 1e-9);
    const TrianglePoints needle{a, b, a + t * (b - a)};
    RC_ASSERT(isDegenerate(needle) == exact(needle).is_degenerate());
  }));
}

HANDWHEEL_TEST(TriangleIntersectionTest)
#include "TriangleIntersectionTest.moc"

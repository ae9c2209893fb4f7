// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/Fairing.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"

#include <rapidcheck.h>

#include <QTest>
#include <limits>
#include <random>

using namespace handwheel;

namespace {

constexpr std::uint32_t kFairedSide = 12;
constexpr Continuity kAll[] = {Continuity::Position, Continuity::Tangent, Continuity::Curvature};

// A grid of points in the plane, moved about in it.
TriangleSoup plane(std::mt19937& random) {
  const auto shake = [&] { return 0.6 * (random() / 4294967296.0 - 0.5); };
  return test::grid(kFairedSide, kFairedSide, false, false,
                    [&](auto i, auto j) { return Vec3(i + shake(), j + shake(), 0.0); });
}

// All but the points nearer than this many lines to the edge.
std::vector<bool> inner(std::uint32_t lines) {
  std::vector<bool> isFree;
  for (std::uint32_t i = 0; i < kFairedSide; ++i) {
    for (std::uint32_t j = 0; j < kFairedSide; ++j)
      isFree.push_back(std::min({i, j, kFairedSide - 1 - i, kFairedSide - 1 - j}) >= lines);
  }
  return isFree;
}

}  // namespace

class FairingTest : public QObject {
  Q_OBJECT

 private slots:
  void planesStayPlanes();
  void onlyFreePointsMove();
  void orderTellsWhichPolynomialsStay();
  void smootherIsNearerToABall();
  void sizePositionAndTurnDoNotMatter();
  void borderHasNoTangent();
  void refusesWhatHasNoSurface();
};

// Dented, a piece of a plane becomes flat again: every energy of a plane is 0. With one line of fixed points (no
// tangents) as well as with more.
void FairingTest::planesStayPlanes() {
  QVERIFY(rc::check("planes", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto continuity = *rc::gen::element(Continuity::Position, Continuity::Tangent, Continuity::Curvature);
    for (std::uint32_t lines : {1u, 2u, 3u}) {
      if (continuity == Continuity::Curvature && lines == 1) continue;  // too little is fixed
      TriangleSoup s = plane(random);
      const std::vector<bool> isFree = inner(lines);
      for (std::size_t i = 0; i < s.points.size(); ++i)
        if (isFree[i]) s.points[i].z() = 0.3 * std::sin(1.7 * static_cast<double>(i));
      RC_ASSERT(fair(s.points, s.triangles, isFree, continuity));
      for (const Vec3& p : s.points) RC_ASSERT(std::abs(p.z()) < 1e-9);
    }
  }));
}

void FairingTest::onlyFreePointsMove() {
  for (Continuity continuity : kAll) {
    TriangleSoup s = test::bumpySphere(3);
    const std::vector<Vec3> before = s.points;
    std::vector<bool> isFree;
    for (const Vec3& p : s.points) isFree.push_back(p.z() > 0.6);
    QVERIFY(fair(s.points, s.triangles, isFree, continuity));
    std::size_t moved = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      moved += s.points[i] != before[i];
      QVERIFY(isFree[i] || test::sameBits(s.points[i], before[i]));
    }
    QVERIFY(moved > 20);
  }
}

// Over a regular grid the Laplacian is the five-point one, and the surface of least energy of order k has Δᵏz = 0. That
// holds for polynomials in x of degree 2k − 1, and for none of degree 2k. The heights are so small that the angles of
// the triangles do not change.
void FairingTest::orderTellsWhichPolynomialsStay() {
  constexpr double kHeight = 1e-6;
  for (Continuity continuity : kAll) {
    const std::uint32_t order = 1 + static_cast<std::uint32_t>(continuity);
    for (std::uint32_t degree = 0; degree <= 2 * order; ++degree) {
      const auto height = [&](std::uint32_t i) { return kHeight * std::pow(i / (kFairedSide - 1.0) - 0.5, degree); };
      TriangleSoup s =
          test::grid(kFairedSide, kFairedSide, false, false, [&](auto i, auto j) { return Vec3(i, j, height(i)); });
      const std::vector<Vec3> wanted = s.points;
      const std::vector<bool> isFree = inner(order);
      for (std::size_t i = 0; i < s.points.size(); ++i)
        if (isFree[i]) s.points[i].z() = kHeight * std::sin(1.7 * static_cast<double>(i));
      QVERIFY(fair(s.points, s.triangles, isFree, continuity));
      double largest = 0.0;
      for (std::size_t i = 0; i < s.points.size(); ++i) largest = std::max(largest, (s.points[i] - wanted[i]).norm());
      QVERIFY2((largest < 1e-5 * kHeight) == (degree < 2 * order), qPrintable(QString::number(largest)));
    }
  }
}

// A ball with a cap missing, of finer and finer triangles: the smoother the surface continues it, the nearer it comes
// to the ball; a membrane cannot.
void FairingTest::smootherIsNearerToABall() {
  double before = 1.0;
  for (Continuity continuity : kAll) {
    TriangleSoup s = test::icosphere(4);
    std::vector<bool> isFree;
    for (Vec3& p : s.points) isFree.push_back(p.z() > 0.8);
    QVERIFY(fair(s.points, s.triangles, isFree, continuity));
    double largest = 0.0;
    for (const Vec3& p : s.points) largest = std::max(largest, std::abs(p.norm() - 1.0));
    QVERIFY2(largest < 0.5 * before, qPrintable(QString::number(largest)));
    if (continuity == Continuity::Position) QVERIFY(largest > 0.1);
    before = largest;
  }
}

void FairingTest::sizePositionAndTurnDoNotMatter() {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()));
  const TriangleSoup start = test::bumpySphere(3);
  std::vector<bool> isFree;
  for (const Vec3& p : start.points) isFree.push_back(p.z() > 0.6);
  for (Continuity continuity : kAll) {
    TriangleSoup plain = start;
    QVERIFY(fair(plain.points, plain.triangles, isFree, continuity));
    for (const auto& [scale, shift] : {std::pair{1e-6, 0.0}, {1e6, 0.0}, {1e-100, 0.0}, {1.0, 1e6}}) {
      TriangleSoup other = start;
      for (Vec3& p : other.points) p = scale * (turn * p) + Vec3::Constant(shift);
      QVERIFY(fair(other.points, other.triangles, isFree, continuity));
      const double allowed = 1e-9 + 1e-12 * shift;  // rounding of the numbers, magnified by the equations
      for (std::size_t i = 0; i < plain.points.size(); ++i)
        QVERIFY(((other.points[i] - Vec3::Constant(shift)) / scale - turn * plain.points[i]).norm() < allowed);
    }
  }
}

// A roof's one side, whose ridge is a border: although its lower edge continues a plane of another slope, nothing
// bends at the ridge, where all could turn freely; the points of a straight line at the ridge stay where they are.
void FairingTest::borderHasNoTangent() {
  const auto roof = [](double kink) {
    return test::grid(kFairedSide, kFairedSide, false, false,
                      [&](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, j < 2 ? 0.0 : kink * (j - 1.0)); });
  };
  std::vector<bool> isFree = inner(0);
  for (std::uint32_t i = 0; i < kFairedSide * kFairedSide; ++i)
    isFree[i] = i % kFairedSide >= 2 && i % kFairedSide < kFairedSide - 1 && i / kFairedSide > 0 &&
                i / kFairedSide < kFairedSide - 1;
  for (double kink : {0.0, 0.5}) {
    TriangleSoup s = roof(kink);
    QVERIFY(fair(s.points, s.triangles, isFree));
    double slopeAtRidge = 0.0, slopeBelow = 0.0;
    const std::uint32_t middle = kFairedSide / 2 * kFairedSide;
    slopeAtRidge = s.points[middle + kFairedSide - 1].z() - s.points[middle + kFairedSide - 2].z();
    slopeBelow = s.points[middle + 2].z() - s.points[middle + 1].z();
    if (kink == 0.0) {
      QVERIFY(std::abs(slopeAtRidge) < 1e-12);
    } else {
      QVERIFY(slopeBelow < kink);          // it leaves the lower plane gently
      QVERIFY(slopeAtRidge > 0.9 * kink);  // and comes to the ridge as steep as it likes
    }
  }
}

void FairingTest::refusesWhatHasNoSurface() {
  for (Continuity continuity : kAll) {
    TriangleSoup s = test::icosphere(1);
    std::vector<bool> isFree(s.points.size(), false);
    QVERIFY(fair(s.points, s.triangles, isFree, continuity));  // nothing to do
    s.points.push_back(Vec3(1, 2, 3));                         // in no triangle
    isFree.push_back(true);
    std::vector<Vec3> before = s.points;
    QVERIFY(!fair(s.points, s.triangles, isFree, continuity));
    QVERIFY(s.points == before);

    TriangleSoup flat = test::icosphere(1);
    for (Vec3& p : flat.points) p = Vec3::Zero();
    QVERIFY(!fair(flat.points, flat.triangles, std::vector<bool>(flat.points.size(), true), continuity));
    TriangleSoup endless = test::icosphere(1);
    endless.points[3].x() = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!fair(endless.points, endless.triangles, std::vector<bool>(endless.points.size(), true), continuity));
  }
}

HANDWHEEL_TEST(FairingTest)
#include "FairingTest.moc"

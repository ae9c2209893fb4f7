// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/CollisionBody.h"

#include "AnyBodies.h"
#include "ExactConvexDistance.h"
#include "TestClass.h"
#include "collision/ProximityQuery.h"

#include <QtTest>
#include <random>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using Kind = CollisionPiece::Kind;

// Pieces of round sizes at round positions, turned by round angles about the axes.
class RoundPieces {
 public:
  explicit RoundPieces(unsigned seed) : m_random(seed) {}

  CollisionPiece piece(Kind kind) {
    const Pose at = pose();
    const Vec3 half(size(), size(), size());
    switch (kind) {
      case Kind::Ball:
        return CollisionPiece::sphere(at.translation(), half.x());
      case Kind::Block:
        return CollisionPiece::box(at, 2.0 * half);
      case Kind::Cylinder:
        return CollisionPiece::cylinder(at, half.x(), 2.0 * half.z());
      case Kind::Mesh:
        break;
    }
    return CollisionPiece::ofMesh(at, std::make_shared<const CollisionMesh>(boxSoup(half)));
  }

 private:
  int upTo(int last) { return std::uniform_int_distribution<int>(0, last)(m_random); }
  double size() { return std::array{1.0, 2.5, 5.0, 10.0, 20.0, 50.0}[static_cast<std::size_t>(upTo(5))]; }
  Pose pose() {
    Pose pose = Pose::Identity();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double degrees = std::array{0.0, 0.0, 90.0, 180.0, 45.0, 30.0}[static_cast<std::size_t>(upTo(5))];
      pose.rotate(Eigen::AngleAxisd(degrees * M_PI / 180.0, Vec3::Unit(axis)));
    }
    pose.translation() = 5.0 * Vec3(upTo(40) - 20, upTo(40) - 20, upTo(40) - 20);
    return pose;
  }

  std::mt19937 m_random;
};

// Returns the convex sets of a piece: itself, or the triangles of the box that the mesh is.
std::vector<ConvexSet> setsOf(const CollisionPiece& piece) {
  if (piece.kind != Kind::Mesh) {
    const ConvexSet::Kind kind = piece.kind == Kind::Ball    ? ConvexSet::Kind::Ball
                                 : piece.kind == Kind::Block ? ConvexSet::Kind::Block
                                                             : ConvexSet::Kind::Cylinder;
    return {{kind, piece.pose, piece.half, {}}};
  }
  const TriangleSoup soup = boxSoup(piece.boxHalf);
  std::vector<ConvexSet> sets;
  for (const Triangle& t : soup.triangles) {
    ConvexSet set;
    set.kind = ConvexSet::Kind::Triangle;
    for (std::size_t k = 0; k < 3; ++k) set.corners[k] = piece.pose * soup.points[t[k]];
    sets.push_back(set);
  }
  return sets;
}

bool holds(const CollisionPiece& piece, const Vec3& p) {
  const Vec3 at = piece.pose.inverse(Eigen::Isometry) * p;
  return piece.kind == Kind::Mesh && (at.cwiseAbs() - piece.boxHalf).maxCoeff() < 0.0;
}

// A mesh is hollow: what is inside of it without touching it has no distance.
DistanceBounds exactDistance(const CollisionPiece& a, const CollisionPiece& b) {
  if (holds(a, b.pose.translation()) || holds(b, a.pose.translation())) return {0.0, 0.0};
  DistanceBounds nearest{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const ConvexSet& first : setsOf(a)) {
    for (const ConvexSet& second : setsOf(b)) {
      const DistanceBounds bounds = boundsOfDistance(first, second, b.pose.translation(), 1e-7, nearest.most);
      nearest = {std::min(nearest.least, bounds.least), std::min(nearest.most, bounds.most)};
    }
  }
  return nearest;
}

}  // namespace

class AlignedDistancesTest : public QObject {
  Q_OBJECT

 private slots:
  void pairs_data() {
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("second");
    const std::array<const char*, 4> names{"ball", "block", "cylinder", "mesh"};
    for (int a = 0; a < 4; ++a)
      for (int b = a; b < 4; ++b)
        QTest::addRow("%s and %s", names[static_cast<std::size_t>(a)], names[static_cast<std::size_t>(b)]) << a << b;
  }
  // A distance that is too large would prove a collision free; one that is too small blocks what is free.
  void pairs() {
    QFETCH(int, first);
    QFETCH(int, second);
    constexpr double kTooLarge = 1e-9, kTooSmall = 1e-5;  // mm
    constexpr int kCount = 10'000;
    RoundPieces pieces(static_cast<unsigned>(10 * first + second));
    double unsure = 0.0;
    for (int i = 0; i < kCount; ++i) {
      const CollisionPiece a = pieces.piece(static_cast<Kind>(first)), b = pieces.piece(static_cast<Kind>(second));
      const DistanceBounds exact = exactDistance(a, b);
      unsure = std::max(unsure, exact.most - exact.least);
      const CollisionBody bodyA({a}), bodyB({b});
      const double found = distanceBetween(bodyA, Pose::Identity(), bodyB, Pose::Identity());
      const double other = distanceBetween(bodyB, Pose::Identity(), bodyA, Pose::Identity());
      ProximityQuery query({bodyA, bodyB}, {{0, 1}});
      const auto near = query.closest();
      for (const double distance : {found, other, near ? near->points.distance : found}) {
        const QString text = QString("pair %1: %2 mm instead of %3 to %4")
                                 .arg(i)
                                 .arg(distance, 0, 'g', 12)
                                 .arg(exact.least, 0, 'g', 12)
                                 .arg(exact.most, 0, 'g', 12);
        QVERIFY2(std::max(0.0, distance) <= exact.most + kTooLarge, qPrintable(text));
        QVERIFY2(std::max(0.0, distance) >= exact.least - kTooSmall, qPrintable(text));
      }
    }
    QVERIFY2(unsure < 1e-3, qPrintable(QString::number(unsure)));
  }
};

HANDWHEEL_TEST(AlignedDistancesTest)
#include "AlignedDistancesTest.moc"

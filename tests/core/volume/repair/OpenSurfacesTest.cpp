// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshShapes.h"
#include "TestClass.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeParts.h"

#include <QtTest>
#include <cmath>
#include <random>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kBallRadius = 10.0;
constexpr double kBall = 4.0 / 3.0 * M_PI * kBallRadius * kBallRadius * kBallRadius;

TriangleSoup ball(int level) {
  return moved(icosphere(level), Vec3::Zero(), kBallRadius);
}

// The triangles whose middles pass a test.
template <class Test>
TriangleSoup only(TriangleSoup soup, Test test) {
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    return !test(Vec3((soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]) / 3.0));
  });
  return soup;
}

TriangleSoup rough(TriangleSoup soup, double by) {
  std::mt19937 numbers(7);
  std::normal_distribution<double> normal(0.0, by);
  for (Vec3& p : soup.points) p += Vec3(normal(numbers), normal(numbers), normal(numbers));
  return soup;
}

// Checks that a surface becomes one body of this volume, mm³.
void checkOneBody(const TriangleSoup& surface, double expected, double share) {
  const Result<SurfaceVolume> made = volumeOfSurface(surface, 0.5);
  QVERIFY(made.hasValue());
  QCOMPARE(VolumeParts(made->volume).voxels().size(), std::size_t{1});
  QVERIFY2(std::abs(made->volume.enclosed() / expected - 1.0) < share,
           qPrintable(QString::number(made->volume.enclosed() / expected)));
}

}  // namespace

class OpenSurfacesTest : public QObject {
  Q_OBJECT

 private slots:
  // A segment of height h of a ball is π h² (3 r - h) / 3 mm³. Its rim is ragged by the triangles that are missing, and
  // rough.
  void segmentsOfABall() {
    for (const double from : {0.0, 5.0, -5.0}) {
      const double height = kBallRadius - from;
      const TriangleSoup segment = rough(only(ball(4), [&](const Vec3& p) { return p.z() > from; }), 0.08);
      checkOneBody(segment, M_PI * height * height * (3.0 * kBallRadius - height) / 3.0, 0.06);
    }
  }

  // A ball is closed of which triangles are missing everywhere.
  void trianglesMissing() {
    for (const double share : {0.1, 0.3}) {
      std::mt19937 numbers(3);
      std::bernoulli_distribution isMissing(share);
      const TriangleSoup scan = only(ball(4), [&](const Vec3&) { return !isMissing(numbers); });
      checkOneBody(scan, kBall, 0.02);
      checkOneBody(unshared(scan), kBall, 0.02);
    }
  }

  // A ball is closed whose every triangle, or every triangle of a coarse ball with the finer ones within it, is a piece
  // of its own with a gap around it.
  void cracks() {
    for (const int perPiece : {1, 16}) {
      TriangleSoup pieces;
      std::mt19937 numbers(5);
      std::normal_distribution<double> normal(0.0, 0.03);
      const TriangleSoup whole = ball(perPiece == 1 ? 3 : 4);
      // The subdivision keeps the triangles of each coarser one together.
      for (std::size_t first = 0; first < whole.triangles.size(); first += static_cast<std::size_t>(perPiece)) {
        TriangleSoup piece{whole.points,
                           {whole.triangles.begin() + static_cast<std::ptrdiff_t>(first),
                            whole.triangles.begin() + static_cast<std::ptrdiff_t>(first) + perPiece}};
        Vec3 middle = Vec3::Zero();
        for (const Triangle& t : piece.triangles)
          for (const std::uint32_t v : t) middle += whole.points[v] / (3.0 * perPiece);
        const Vec3 shift(normal(numbers), normal(numbers), normal(numbers));
        for (Vec3& p : piece.points) p = middle + 0.95 * (p - middle) + shift;
        append(pieces, piece);
      }
      checkOneBody(pieces, kBall, 0.04);
    }
  }

  // A small closed body beside an open one is no crumb.
  void closedBodiesStay() {
    TriangleSoup scan = rough(only(ball(4), [](const Vec3& p) { return p.z() > 0.0; }), 0.08);
    append(scan, moved(icosphere(2), Vec3(20.0, 0.0, 0.0), 1.0));
    const Result<SurfaceVolume> made = volumeOfSurface(scan, 0.5);
    QVERIFY(made.hasValue());
    QCOMPARE(VolumeParts(made->volume).voxels().size(), std::size_t{2});
  }
};

HANDWHEEL_TEST(OpenSurfacesTest)
#include "OpenSurfacesTest.moc"

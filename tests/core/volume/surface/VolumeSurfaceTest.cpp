// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/surface/VolumeSurface.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Result.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeShapes.h"
#include "volume/clay/ClayDab.h"
#include "volume/surface/VolumeToSurface.h"

#include <QtTest>
#include <algorithm>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using Corners = std::array<std::array<double, 3>, 3>;

// The triangles by their corners, to a few decimals, from the lowest corner on, sorted.
std::vector<Corners> sorted(std::vector<Corners> all) {
  for (Corners& corners : all) {
    for (auto& corner : corners)
      for (double& x : corner) x = std::round(x * 1e3) / 1e3;
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<Corners> trianglesOf(const TriangleSoup& soup) {
  std::vector<Corners> all;
  for (const Triangle& t : soup.triangles) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = {soup.points[t[k]].x(), soup.points[t[k]].y(), soup.points[t[k]].z()};
    all.push_back(corners);
  }
  return all;
}

Vec3 pointOf(const VolumePiece& piece, const std::vector<float>& of, std::int32_t i) {
  const auto at = 3 * static_cast<std::size_t>(i);
  return piece.origin + Vec3(of[at], of[at + 1], of[at + 2]);
}

std::vector<Corners> trianglesOf(const VolumeSurface& surface) {
  std::vector<Corners> all;
  for (const auto& [key, piece] : surface.pieces())
    for (std::size_t i = 0; i < piece->fine.corners.size(); i += 3) {
      Corners corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 p = pointOf(*piece, piece->fine.points, piece->fine.corners[i + k]);
        corners[k] = {p.x(), p.y(), p.z()};
      }
      all.push_back(corners);
    }
  return all;
}

bool isSame(const VolumeTriangles& a, const VolumeTriangles& b) {
  return a.points == b.points && a.normals == b.normals && a.corners == b.corners;
}

void pieceSizes() {
  QTest::addColumn<int>("cells");
  for (const int cells : {16, 32, 64, 128}) QTest::addRow("%d", cells) << cells;
}

}  // namespace

class VolumeSurfaceTest : public QObject {
  Q_OBJECT

 private slots:
  // The pieces together are the whole surface, whatever their size. Corners that rounding parts are a few.
  void piecesAreTheWhole_data() { pieceSizes(); }
  void piecesAreTheWhole() {
    QFETCH(int, cells);
    const SparseVolume volume = volumeOfSurface(moved(icosphere(3), Vec3::Zero(), 10.0), 0.13)->volume;
    const VolumeSurface surface(volume, {}, cells);
    QCOMPARE(surface.pieceCells(), cells);
    if (cells <= 64) QVERIFY(surface.pieces().size() > 8);
    const std::vector<Corners> pieces = sorted(trianglesOf(surface)), whole = sorted(trianglesOf(surfaceOf(volume)));
    QCOMPARE(pieces.size(), whole.size());
    QCOMPARE(surface.triangleCount(), whole.size());
    std::vector<Corners> different;
    std::set_difference(pieces.begin(), pieces.end(), whole.begin(), whole.end(), std::back_inserter(different));
    QVERIFY2(different.size() < whole.size() / 50, qPrintable(QString::number(different.size())));
    for (const auto& [key, piece] : surface.pieces()) {
      if (cells <= 64) QVERIFY(piece->fine.count() < 64'000);
      // No larger than so many cells, and where its key says.
      QVERIFY(piece->box.sizes().maxCoeff() < 0.13 * cells + 1e-5);
      for (int k = 0; k < 3; ++k) {
        const double low = volume.origin()[k] + 0.13 * cells * key[static_cast<std::size_t>(2 - k)];
        QVERIFY(piece->box.min()[k] > low - 1e-5 && piece->box.max()[k] < low + 0.13 * cells + 1e-5);
      }
    }
  }

  // Points, fine and coarse, lie on the ball, within the box, and their normals are its normals.
  void pointsAndNormalsOfABall() {
    constexpr double kRadius = 10.0, kVoxel = 0.1;
    const VolumeSurface surface(ballOfVoxels(kRadius, kVoxel));
    QVERIFY(VolumeSurface().box().isEmpty());
    for (const Vec3& corner : {Vec3(-surface.box().min()), surface.box().max()})
      QVERIFY((corner - Vec3::Constant(kRadius)).cwiseAbs().maxCoeff() < 0.05 * kVoxel);
    for (const auto& [key, piece] : surface.pieces())
      for (const bool isCoarse : {false, true}) {
        const VolumeTriangles& triangles = isCoarse ? piece->coarse : piece->fine;
        QVERIFY(triangles.count() > 0 || isCoarse);
        for (std::int32_t i = 0; i < static_cast<std::int32_t>(triangles.points.size() / 3); ++i) {
          const Vec3 p = pointOf(*piece, triangles.points, i);
          const Vec3 normal = pointOf(*piece, triangles.normals, i) - piece->origin;
          QVERIFY(std::abs(p.norm() - kRadius) < (isCoarse ? 2.0 * kVoxel : 0.02 * kVoxel));
          QVERIFY((normal - p.normalized()).norm() < (isCoarse ? 0.1 : 0.02));
          QVERIFY(isCoarse || piece->box.exteriorDistance(p) < 1e-5);
        }
      }
  }

  // Updated pieces equal newly made ones; pieces that a change does not affect are not touched.
  void updatesAreTheWhole_data() { pieceSizes(); }
  void updatesAreTheWhole() {
    QFETCH(int, cells);
    SparseVolume volume = ballOfVoxels(10.0, 0.13);
    VolumeSurface surface(volume, {}, cells);
    const VolumeSurface before = surface;
    ClayDab dab;
    dab.centre = Vec3(6.0, 5.0, 6.0);
    dab.radius = 3.0;
    surface.update(volume, applyDab(volume, dab));
    const VolumeSurface fresh(volume, {}, cells);
    QCOMPARE(surface.pieces().size(), fresh.pieces().size());
    for (const auto& [key, piece] : fresh.pieces()) {
      QVERIFY(isSame(surface.pieces().at(key)->fine, piece->fine));
      QVERIFY(isSame(surface.pieces().at(key)->coarse, piece->coarse));
    }
    std::size_t kept = 0;
    for (const auto& [key, piece] : before.pieces()) {
      const auto now = surface.pieces().find(key);  // some small ones are cut away
      kept += now != surface.pieces().end() && now->second == piece;
    }
    QVERIFY(kept > before.pieces().size() / 2 && kept < before.pieces().size());
  }

  // Around the middle of a ball the eight octants are pieces of 128 cells; each halving parts a surface in about four.
  void smallerPiecesAreMore() {
    const SparseVolume volume = ballOfVoxels(12.0, 0.1);
    std::size_t before = 0;
    for (const int cells : {128, 64, 32, 16}) {
      const std::size_t count = VolumeSurface(volume, {}, cells).pieces().size();
      if (cells == 128) QCOMPARE(count, std::size_t{8});
      QVERIFY(before == 0 || (count > 2 * before && count < 8 * before));
      before = count;
    }
  }

  void ofNothing() { QVERIFY(VolumeSurface(SparseVolume(Vec3::Zero(), 1.0)).pieces().empty()); }
};

HANDWHEEL_TEST(VolumeSurfaceTest)
#include "VolumeSurfaceTest.moc"

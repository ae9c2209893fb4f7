// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeSurface.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Result.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeToSurface.h"

#include <QtTest>
#include <algorithm>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using Corners = std::array<std::array<double, 3>, 3>;

// The triangles by their corners, from the lowest corner on, sorted.
std::vector<Corners> sorted(const TriangleSoup& soup) {
  std::vector<Corners> all;
  for (const Triangle& t : soup.triangles) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = {soup.points[t[k]].x(), soup.points[t[k]].y(), soup.points[t[k]].z()};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<Corners> sorted(const VolumeSurface& surface) {
  TriangleSoup all;
  for (const auto& [key, piece] : surface.pieces()) append(all, *piece);
  return sorted(all);
}

}  // namespace

class VolumeSurfaceTest : public QObject {
  Q_OBJECT

 private slots:
  // The pieces together are the whole surface.
  void piecesAreTheWhole() {
    const SparseVolume volume = volumeOfSurface(moved(icosphere(3), Vec3::Zero(), 10.0), 0.13)->volume;
    const VolumeSurface surface(volume);
    QVERIFY(surface.pieces().size() > 8);
    QCOMPARE(sorted(surface), sorted(surfaceOf(volume)));
    QCOMPARE(surface.triangleCount(), surfaceOf(volume).triangles.size());
    for (const auto& [key, piece] : surface.pieces()) QVERIFY(piece->triangles.size() < 64'000);
  }

  void ofNothing() { QVERIFY(VolumeSurface(SparseVolume(Vec3::Zero(), 1.0)).pieces().empty()); }
};

HANDWHEEL_TEST(VolumeSurfaceTest)
#include "VolumeSurfaceTest.moc"

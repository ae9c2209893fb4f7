// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/structure/MeshBuilder.h"

using namespace handwheel;

namespace {

// A tapering tube up to z = 0, closed below, open above with radius 1. The normals of its sides have this cosine to z.
TriangleSoup taperingTube(double cosine) {
  constexpr std::uint32_t n = 48, cells = 8;
  const double taper = cosine / std::sqrt(1.0 - cosine * cosine) / std::cos(M_PI / n);
  TriangleSoup s = test::grid(n, cells + 1, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2.0 * M_PI * i / n, z = double(j) / cells - 1.0, r = 1.0 - taper * z;
    return Vec3(r * std::cos(u), r * std::sin(u), z);
  });
  const auto low = static_cast<std::uint32_t>(s.points.size());
  s.points.push_back(Vec3(0, 0, -1));
  for (std::uint32_t i = 0; i < n; ++i) s.triangles.push_back({low, (i + 1) % n * (cells + 1), i * (cells + 1)});
  return s;
}

// A tetrahedron within the height of the tube, so far away that the box of both has this diagonal.
TriangleSoup withFarPart(TriangleSoup s, double diagonal) {
  Box box;
  for (const Vec3& p : s.points) box.extend(p);
  const double length = std::sqrt(diagonal * diagonal - box.sizes().y() * box.sizes().y() - 1.0);
  test::append(s, test::moved(test::tetrahedron(), Vec3(box.min().x() + length - 0.1, 0, -0.5), 0.1));
  return s;
}

FillAttempt faired(const TriangleSoup& soup) {
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  FillOptions options;
  options.method = FillMethod::Fair;
  options.tryOthers = false;
  return HoleFiller(mesh).propose(findBoundaryLoops(mesh).at(0), options);
}

double heightOf(const Patch& patch) {
  double height = 0.0;
  for (const Vec3& p : patch.points) height = std::max(height, p.z());
  return height;
}

}  // namespace

// How far a patch may leave the model: a case just below and one just above.
class PatchSwellingTest : public QObject {
  Q_OBJECT

 private slots:
  void capCosine();
  void modelSwelling();
};

// A patch that continues the sides rises out of the top by far more than a hundredth of the model.
void PatchSwellingTest::capCosine() {
  QCOMPARE(faired(taperingTube(0.98 * tolerance::kCapCosine)).failure, FillFailure::Bulging);
  QCOMPARE(faired(taperingTube(1.02 * tolerance::kCapCosine)).failure, FillFailure::None);
}

// The sides are too steep for a cap. The patch is the same however far away the other part is.
void PatchSwellingTest::modelSwelling() {
  const TriangleSoup tube = taperingTube(0.5 * tolerance::kCapCosine);
  const FillAttempt free = faired(withFarPart(tube, 1e4));
  QCOMPARE(free.failure, FillFailure::None);
  const double diagonal = heightOf(free.patch) / tolerance::kModelSwelling;
  QVERIFY(diagonal > 10.0);
  QCOMPARE(faired(withFarPart(tube, diagonal / 0.98)).failure, FillFailure::None);
  QCOMPARE(faired(withFarPart(tube, diagonal / 1.02)).failure, FillFailure::Bulging);
}

HANDWHEEL_TEST(PatchSwellingTest)
#include "PatchSwellingTest.moc"

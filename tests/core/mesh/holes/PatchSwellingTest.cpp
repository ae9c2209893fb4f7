// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/structure/MeshBuilder.h"

#include <algorithm>
#include <cmath>

using namespace handwheel;

namespace {

// A round surface up to z = 0, closed below, open above with radius 1. side: radius, 0 and height, from below.
TriangleSoup turned(const std::vector<Vec3>& side) {
  constexpr std::uint32_t n = 48;
  const auto rings = static_cast<std::uint32_t>(side.size());
  TriangleSoup s = test::grid(n, rings, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2.0 * M_PI * i / n;
    return Vec3(side[j].x() * std::cos(u), side[j].x() * std::sin(u), side[j].z());
  });
  const auto low = static_cast<std::uint32_t>(s.points.size());
  s.points.push_back(Vec3(0, 0, side.front().z()));
  for (std::uint32_t i = 0; i < n; ++i) s.triangles.push_back({low, (i + 1) % n * rings, i * rings});
  return s;
}

// Its side leans by 45° at the opening, by this angle (radian) in the ring below, and by 60° below that. The less the
// second ring leans, the higher a patch rises that continues the curvature.
TriangleSoup hat(double second) {
  std::vector<Vec3> side{Vec3(1, 0, 0)};
  for (const double lean : {M_PI / 4.0, second, M_PI / 3.0, M_PI / 3.0, M_PI / 3.0})
    side.push_back(side.back() + 0.13 * Vec3(std::cos(lean), 0, -std::sin(lean)));
  std::reverse(side.begin(), side.end());
  return turned(side);
}

// A tapering tube up to z = 0, closed below, open above with radius 1. The normals of its sides have this cosine to z.
TriangleSoup taperingTube(double cosine) {
  constexpr int n = 48, cells = 8;
  const double taper = cosine / std::sqrt(1.0 - cosine * cosine) / std::cos(M_PI / n);
  std::vector<Vec3> side;
  for (int j = 0; j <= cells; ++j) {
    const double z = double(j) / cells - 1.0;
    side.emplace_back(1.0 - taper * z, 0, z);
  }
  return turned(side);
}

// A tetrahedron within the height of the tube, so far away that the box of both has this diagonal.
TriangleSoup withFarPart(TriangleSoup s, double diagonal) {
  Box box;
  for (const Vec3& p : s.points) box.extend(p);
  const double length = std::sqrt(diagonal * diagonal - box.sizes().y() * box.sizes().y() - 1.0);
  test::append(s, test::moved(test::tetrahedron(), Vec3(box.min().x() + length - 0.1, 0, -0.5), 0.1));
  return s;
}

FillAttempt faired(const TriangleSoup& soup, Continuity continuity = Continuity::Tangent) {
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  FillOptions options;
  options.method = FillMethod::Fair;
  options.continuity = continuity;
  options.tryOthers = false;
  return HoleFiller(mesh).propose(findBoundaryLoops(mesh).at(0), options);
}

double heightOf(const Patch& patch) {
  double height = 0.0;
  for (const Vec3& p : patch.points) height = std::max(height, p.z());
  return height;
}

// Returns the height of the patch over a hat that continues the curvature or, if that bulges too far, the tangents,
// which is far lower.
double heightOver(const TriangleSoup& soup) {
  const FillAttempt attempt = faired(soup, Continuity::Curvature);
  return attempt.failure == FillFailure::None ? heightOf(attempt.patch) : -1.0;
}

// The lean of the second ring with which a patch rises so high in a model that is much larger, from a high one to a
// low.
double leanFor(double height, double high, double low) {
  for (int i = 0; i < 16; ++i) {
    const double middle = 0.5 * (high + low);
    (heightOver(withFarPart(hat(middle), 1e4)) > height ? high : low) = middle;
  }
  return 0.5 * (high + low);
}

}  // namespace

// Tests the largest distance of a patch from the model: a case just below and one just above.
class PatchSwellingTest : public QObject {
  Q_OBJECT

 private slots:
  void capCosine();
  void modelSwelling();
  void capSlack();
  void patchSwelling();
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

// Out of a small model a patch may rise by the slack over a cap. Over a circle of radius 1 that is tan(a / 2) high for
// a border that leans by a: by 45°, but for the chords of the circle.
void PatchSwellingTest::capSlack() {
  const double limit = tolerance::kCapSlack * std::tan(0.5 * std::atan(1.0 / std::cos(M_PI / 48.0)));
  const auto leanOf = [&](double share) { return leanFor(share * limit, 0.0, M_PI / 4.0); };
  QVERIFY(std::abs(heightOver(hat(leanOf(0.98))) - 0.98 * limit) < 1e-3);
  const double above = heightOver(hat(leanOf(1.02)));
  QVERIFY(above > 0.0 && above < 0.7 * limit);
}

// The limit is a share of the diagonal of the loop's box, 2 √2, regardless of the model's size. Greater heights cannot
// be measured: their lean is extrapolated from lower ones.
void PatchSwellingTest::patchSwelling() {
  const double limit = tolerance::kPatchSwelling * 2.0 * M_SQRT2;
  const auto leanOf = [&](double share) { return leanFor(share * limit, -M_PI / 8.0, M_PI / 8.0); };
  const double at = leanOf(0.90), step = at - leanOf(0.86);
  const auto heightWith = [](double lean) { return heightOver(withFarPart(hat(lean), 1e4)); };
  QVERIFY(std::abs(heightWith(at + 2.0 * step) - 0.98 * limit) < 0.01 * limit);
  const double above = heightWith(at + 3.0 * step);
  QVERIFY(above > 0.0 && above < 0.5 * limit);
}

HANDWHEEL_TEST(PatchSwellingTest)
#include "PatchSwellingTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/LocalIntersections.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/defects/Defects.h"
#include "mesh/sculpt/LoopSubdivision.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>
#include <algorithm>

using namespace handwheel;

class LocalIntersectionsTest : public QObject {
  Q_OBJECT

 private slots:
  void asTheSearchOfTheWhole();
  void countsWhatIsNew();
  void aSubdividedCrossingIsNotNew();
  void cancelled();
};

namespace {

std::vector<std::pair<Face, Face>> all(const HalfEdgeMesh& mesh) {
  return *findSelfIntersections(mesh);
}

// A cube, and a small one that stands in it when it is not moved.
HalfEdgeMesh cubes(const Vec3& shift) {
  TriangleSoup s = test::cube(4.0);
  test::append(s, test::cube(1.0, shift));
  return buildMesh(s).mesh;
}

}  // namespace

// The pairs after any change are those that a search of the whole mesh finds; the new ones, those that it found not
// before.
void LocalIntersectionsTest::asTheSearchOfTheWhole() {
  const bool held = rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const HalfEdgeMesh before = buildMesh(test::randomSoup(random, 40, 5)).mesh;
    HalfEdgeMesh after = before;
    for (int i = *rc::gen::inRange(0, 6); i > 0; --i) {
      const auto v = static_cast<Vertex>(random() % after.vertexSlots());
      after.setPosition(v, after.position(v) + Vec3(random() % 3 - 1.0, random() % 3 - 1.0, random() % 3 * 0.5));
    }
    if (*rc::gen::arbitrary<bool>()) after.removeFace(static_cast<Face>(random() % after.faceSlots()));
    const auto change = intersectionsChange(before, after);
    RC_ASSERT(change.has_value());
    const auto old = all(before), now = all(after);
    RC_ASSERT(intersectionsAfter(*change, old) == now);
    const auto fresh = std::count_if(
        now.begin(), now.end(), [&](const auto& pair) { return !std::binary_search(old.begin(), old.end(), pair); });
    RC_ASSERT(change->fresh == static_cast<std::size_t>(fresh));
  });
  QVERIFY(held);
}

void LocalIntersectionsTest::countsWhatIsNew() {
  const HalfEdgeMesh apart = cubes(Vec3(1.5, 1.5, 1.5)), across = cubes(Vec3(3.5, 1.6, 1.7));
  const auto change = intersectionsChange(apart, across);
  QVERIFY(change && change->fresh > 0);
  QCOMPARE(change->fresh, all(across).size());
  QCOMPARE(change->touched.size(), std::size_t{12});
  const auto back = intersectionsChange(across, apart);
  QVERIFY(back && back->fresh == 0 && back->present.empty());
  QVERIFY(intersectionsAfter(*back, all(across)).empty());
}

void LocalIntersectionsTest::aSubdividedCrossingIsNotNew() {
  const HalfEdgeMesh before = cubes(Vec3(3.5, 1.6, 1.7));
  for (const auto& [first, last] : {std::pair<Face, Face>{0, 12}, {12, 24}, {0, 24}}) {
    HalfEdgeMesh fine = before;
    const FaceSelection part = FaceSelection::where(24, [&](Face f) { return f >= first && f < last; });
    // Loop's positions would round the cubes off.
    QVERIFY(subdivide(fine, part).failure == SubdivisionFailure::None);
    for (Vertex v = 0; v < before.vertexSlots(); ++v) fine.setPosition(v, before.position(v));
    const auto change = intersectionsChange(before, fine);
    QVERIFY(change && !change->present.empty());
    QCOMPARE(change->fresh, std::size_t{0});
    QVERIFY(intersectionsAfter(*change, all(before)) == all(fine));
  }
}

void LocalIntersectionsTest::cancelled() {
  JobState state;
  state.cancelled = true;
  QVERIFY(!intersectionsChange(cubes(Vec3(1.5, 1.5, 1.5)), cubes(Vec3(3.5, 1.6, 1.7)), Progress(state)));
}

HANDWHEEL_TEST(LocalIntersectionsTest)
#include "LocalIntersectionsTest.moc"

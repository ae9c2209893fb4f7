// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/selection/FaceSelection.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshDelta.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class FaceSelectionTest : public QObject {
  Q_OBJECT

 private slots:
  void behavesAsASet();
  void copiesAreIndependent();
  void allAndInverted();
  void dropsWhatDied();
  void removesFaces();
  void removingAFlapMendsItsEdge();
};

namespace {

using Model = std::set<Face>;

FaceSelection of(const Model& model) {
  FaceSelection selection;
  for (const Face f : model) selection.add(f);
  return selection;
}

bool isLike(const FaceSelection& selection, const Model& model) {
  const std::vector<Face> faces = selection.faces();
  return selection.count() == model.size() && selection.empty() == model.empty() &&
         std::equal(faces.begin(), faces.end(), model.begin(), model.end());
}

// Around the ends of words and pages, too: a page holds 262 144 faces.
Model anyModel() {
  const auto face = rc::gen::oneOf(rc::gen::inRange<Face>(0, 200), rc::gen::inRange<Face>(262'000, 262'300));
  return *rc::gen::container<Model>(face);
}

Model join(Model a, const Model& b) {
  a.insert(b.begin(), b.end());
  return a;
}

Model without(Model a, const Model& b) {
  for (const Face f : b) a.erase(f);
  return a;
}

}  // namespace

void FaceSelectionTest::behavesAsASet() {
  QVERIFY(rc::check([] {
    const Model a = anyModel(), b = anyModel();
    FaceSelection s = of(a);
    RC_ASSERT(isLike(s, a));
    for (Face f = 0; f < 210; ++f) RC_ASSERT(s.contains(f) == (a.count(f) != 0));
    RC_ASSERT(!s.contains(kNone - 1));
    s.add(of(b));
    RC_ASSERT(isLike(s, join(a, b)));
    s.remove(of(b));
    RC_ASSERT(isLike(s, without(a, b)));
    RC_ASSERT((of(a) == of(b)) == (a == b));
    std::set<std::size_t> differing;
    for (const Face f : join(without(a, b), without(b, a))) differing.insert(f / 64);
    const std::vector<std::size_t> ranges = of(a).differingRanges(of(b), 64);
    RC_ASSERT(std::vector<std::size_t>(differing.begin(), differing.end()) == ranges);
    Model found;
    for (Face first = 0; first < 262'400; first += 128) {
      for (const Face f : s.facesIn(first, 128)) RC_ASSERT(f >= first && f < first + 128 && found.insert(f).second);
    }
    RC_ASSERT(found == without(a, b));
    for (const Face f : b) RC_ASSERT(s.remove(f) == false);
    for (const Face f : b) RC_ASSERT(s.add(f));
    for (const Face f : b) RC_ASSERT(!s.add(f));
    RC_ASSERT(isLike(s, join(a, b)));
    s.remove(s);
    RC_ASSERT(s.empty() && s == FaceSelection());
  }));
}

void FaceSelectionTest::copiesAreIndependent() {
  QVERIFY(rc::check([] {
    const Model a = anyModel(), b = anyModel();
    const FaceSelection before = of(a);
    FaceSelection after = before;
    RC_ASSERT(after == before && after.differingRanges(before, 64).empty());
    after.add(of(b));
    for (const Face f : a) after.remove(f);
    RC_ASSERT(isLike(before, a));
    RC_ASSERT(isLike(after, without(b, a)));
    after.add(before);
    RC_ASSERT(isLike(after, join(a, b)));
  }));
}

void FaceSelectionTest::allAndInverted() {
  HalfEdgeMesh mesh = buildMesh(test::icosphere(2)).mesh;
  for (const Face f : {3u, 77u, 319u}) mesh.removeFace(f);
  const FaceSelection all = FaceSelection::all(mesh);
  QCOMPARE(all.count(), std::size_t(317));
  QVERIFY(!all.contains(77) && all.contains(78) && !all.contains(320));
  const FaceSelection some{1, 2, 318};
  const FaceSelection others = some.inverted(mesh);
  QCOMPARE(others.count(), std::size_t(314));
  QVERIFY(others.inverted(mesh) == some);
  QVERIFY(FaceSelection().inverted(mesh) == all);
  QVERIFY(all.inverted(mesh).empty());
  QVERIFY(FaceSelection::all(HalfEdgeMesh()).empty());
}

void FaceSelectionTest::dropsWhatDied() {
  HalfEdgeMesh mesh = buildMesh(test::icosphere(1)).mesh;
  FaceSelection selection{0, 5, 63, 64, 79, 80, 5000};
  mesh.removeFace(5);
  mesh.removeFace(64);
  selection.dropDead(mesh);
  QVERIFY((selection == FaceSelection{0, 63, 79}));
  selection.dropDead(HalfEdgeMesh());
  QVERIFY(selection.empty());
}

void FaceSelectionTest::removesFaces() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const TriangleSoup soup = *rc::gen::element(test::icosphere(2), test::randomBlocks(random, 12, 3),
                                                test::moebiusStrip(20, 3), test::twoCubesSharingAVertex());
    const HalfEdgeMesh before = buildMesh(soup).mesh;
    HalfEdgeMesh mesh = before;
    const FaceSelection faces = FaceSelection::where(mesh.faceSlots() + 5, [&](Face) { return random() % 3 == 0; });
    const std::size_t removed = removeFaces(mesh, faces);
    RC_ASSERT(validate(mesh) == "");
    RC_ASSERT(mesh.faceSlots() == before.faceSlots());
    for (Face f = 0; f < mesh.faceSlots(); ++f) {
      RC_ASSERT(mesh.isLive(f) == !faces.contains(f));
      // A face that stays keeps its corner positions, even if it uses other vertices there.
      if (mesh.isLive(f)) {
        auto now = mesh.points(f), then = before.points(f);
        const auto byPosition = [](const Vec3& a, const Vec3& b) {
          return test::coordinates(a) < test::coordinates(b);
        };
        std::sort(now.begin(), now.end(), byPosition);
        std::sort(then.begin(), then.end(), byPosition);
        RC_ASSERT(now == then);
      }
    }
    RC_ASSERT(removed == before.liveFaceCount() - mesh.liveFaceCount());
    RC_ASSERT(removeFaces(mesh, faces) == 0u);
    MeshDelta::between(mesh, before).swap(mesh);
    RC_ASSERT(test::sameMesh(mesh, before));
  }));
}

// Two sheets and a flap meet at one edge. Once the flap is gone, the sheets are neighbours.
void FaceSelectionTest::removingAFlapMendsItsEdge() {
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}};
  soup.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 1, 4}};
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QVERIFY(test::countSeams(mesh) > 0);
  QCOMPARE(removeFaces(mesh, FaceSelection{2}), std::size_t(1));
  QCOMPARE(test::countSeams(mesh), std::size_t(0));
  QCOMPARE(test::countBorder(mesh), std::size_t(4));
}

HANDWHEEL_TEST(FaceSelectionTest)
#include "FaceSelectionTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/sculpt/PatchLevels.h"
#include "mesh/selection/RegionGrowing.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

// Levels of a patch whose mesh is edited outside of it.
class PatchLevelsFollowTest : public QObject {
  Q_OBJECT

 private slots:
  void detailFollowsAsWithoutTheEdits();
  void whatTouchesThePatchIsRefused();
  void anyEditsInAnyOrder();
};

namespace {

void splitInThree(HalfEdgeMesh& mesh, Face f) {
  const Triangle t = mesh.triangle(f);
  const std::array<HalfEdge, 2> outer = {mesh.opposite(3 * f + 1), mesh.opposite(3 * f + 2)};
  const auto [p, q, r] = mesh.points(f);
  const Vertex v = mesh.addVertex((p + q + r) / 3.0);
  const Face b = mesh.addFace({t[1], t[2], v}), c = mesh.addFace({t[2], t[0], v});
  mesh.setTriangle(f, {t[0], t[1], v});
  mesh.pair(3 * f + 1, 3 * b + 2);
  mesh.pair(3 * b + 1, 3 * c + 2);
  mesh.pair(3 * c + 1, 3 * f + 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const HalfEdge h = 3 * (i == 0 ? b : c);
    mesh.setOpposite(h, outer[i]);
    if (mesh.hasOpposite(h)) mesh.setOpposite(outer[i], h);
  }
}

void addTetrahedron(HalfEdgeMesh& mesh) {
  const HalfEdgeMesh more = buildMesh(test::tetrahedron()).mesh;
  const auto vertices = static_cast<Vertex>(mesh.vertexSlots());
  const auto halfEdges = static_cast<HalfEdge>(mesh.halfEdgeSlots());
  for (Vertex v = 0; v < more.vertexSlots(); ++v) mesh.addVertex(more.position(v) + Vec3(5, 5, 5));
  for (Face f = 0; f < more.faceSlots(); ++f) {
    Triangle corners = more.triangle(f);
    for (Vertex& v : corners) v += vertices;
    mesh.addSlot(corners, {more.opposite(3 * f) + halfEdges, more.opposite(3 * f + 1) + halfEdges,
                           more.opposite(3 * f + 2) + halfEdges});
  }
}

enum class Change { Move, Remove, Split, Add };

HalfEdgeMesh changedAt(HalfEdgeMesh mesh, Change change, Face f) {
  if (change == Change::Move) mesh.setPosition(mesh.triangle(f)[0], 1.01 * mesh.position(mesh.triangle(f)[0]));
  if (change == Change::Remove) removeFaces(mesh, {f});
  if (change == Change::Split) splitInThree(mesh, f);
  if (change == Change::Add) addTetrahedron(mesh);
  return mesh;
}

// Returns true if a face of the patch, or one that shares an edge with it, has moved or has other neighbours.
bool touches(const HalfEdgeMesh& before, const HalfEdgeMesh& after, const FaceSelection& patch) {
  const auto isPatch = [&](HalfEdge h) { return before.hasOpposite(h) && patch.contains(before.opposite(h) / 3); };
  for (Face f = 0; f < before.faceSlots(); ++f) {
    if (!patch.contains(f) && !isPatch(3 * f) && !isPatch(3 * f + 1) && !isPatch(3 * f + 2)) continue;
    if (before.triangle(f) != after.triangle(f)) return true;
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h)
      if (before.opposite(h) != after.opposite(h) || before.position(before.from(h)) != after.position(after.from(h)))
        return true;
  }
  return false;
}

// Returns true if a level equals the finest one outside its patch, with equal numbers of faces and vertices.
bool isFineOutside(const PatchLevels& levels, std::size_t level) {
  const HalfEdgeMesh& coarse = levels.mesh(level);
  const HalfEdgeMesh& fine = levels.mesh();
  for (Face f = 0; f < fine.faceSlots(); ++f) {
    if (levels.patch().contains(f)) {
      const bool isLive = f < coarse.faceSlots() && coarse.isLive(f);
      if (isLive != levels.patch(level).contains(f)) return false;
      continue;
    }
    if (coarse.triangle(f) != fine.triangle(f)) return false;
    for (HalfEdge h = 3 * f; h < 3 * f + 3 && fine.isLive(f); ++h) {
      if (!test::sameBits(coarse.position(coarse.from(h)), fine.position(fine.from(h)))) return false;
      const bool isPatch = fine.hasOpposite(h) && levels.patch().contains(fine.opposite(h) / 3);
      if (isPatch ? !levels.patch(level).contains(coarse.opposite(h) / 3) : coarse.opposite(h) != fine.opposite(h))
        return false;
    }
  }
  return coarse.faceSlots() <= fine.faceSlots() && coarse.vertexSlots() <= fine.vertexSlots();
}

bool isSame(const PatchLevels& a, const PatchLevels& b) {
  for (std::size_t i = 0; i <= a.finest(); ++i)
    if (!test::sameMesh(a.mesh(i), b.mesh(i))) return false;
  return a.finest() == b.finest() && a.patch() == b.patch();
}

// Levels that are valid, and each of which makes the next.
void checkLevels(const PatchLevels& levels) {
  for (std::size_t i = 0; i <= levels.finest(); ++i) {
    RC_ASSERT(validate(levels.mesh(i)) == std::string());
    RC_ASSERT(isFineOutside(levels, i));
    if (i == 0) continue;
    const auto step = subdivisionBetween(levels.mesh(i - 1), levels.patch(i - 1), levels.mesh(i), levels.firstAdded(i));
    RC_ASSERT(step && step->faces == levels.patch(i));
  }
}

// Moves what is within the patch of a level.
void swell(PatchLevels& levels, std::size_t level, double by) {
  HalfEdgeMesh mesh = levels.mesh(level);
  std::vector<bool> isHeld(mesh.vertexSlots(), false);
  for (Face f = 0; f < mesh.faceSlots(); ++f)
    for (std::size_t k = 0; k < 3 && mesh.isLive(f) && !levels.patch(level).contains(f); ++k)
      isHeld[mesh.triangle(f)[k]] = true;
  levels.patch(level).forEach([&](Face f) {
    for (const Vertex v : mesh.triangle(f)) {
      if (!isHeld[v]) mesh.setPosition(v, mesh.position(v) * (1.0 + by * std::sin(17.0 * mesh.position(v).x())));
      isHeld[v] = true;
    }
  });
  levels.replace(level, std::move(mesh));
}

// Returns levels of a patch of a sphere with 1280 faces, refined the given number of times, and moved at each level.
PatchLevels onSphere(Face seed, int rings, int times) {
  const HalfEdgeMesh sphere = buildMesh(test::bumpySphere(3)).mesh;
  FaceSelection patch{seed};
  for (int i = 0; i < rings; ++i) patch = grownByRing(sphere, patch);
  PatchLevels levels(sphere, patch);
  for (int i = 0; i < times; ++i) levels.refine();
  for (std::size_t i = 0; i <= levels.finest(); ++i) swell(levels, i, 0.005);
  return levels;
}

// A live face that no vertex of the patch is a corner of.
Face farFrom(const HalfEdgeMesh& mesh, const FaceSelection& patch) {
  const FaceSelection around = grownByRing(mesh, grownByRing(mesh, patch));
  Face f = 0;
  while (!mesh.isLive(f) || around.contains(f)) ++f;
  return f;
}

Face shareEdgeWith(const HalfEdgeMesh& mesh, const FaceSelection& patch) {
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
    if (patch.contains(h / 3) && !patch.contains(mesh.opposite(h) / 3)) return mesh.opposite(h) / 3;
  return kNone;
}

constexpr Change kChanges[] = {Change::Move, Change::Remove, Change::Split, Change::Add};

}  // namespace

// Sculpting at a coarse level moves the finest one as if nothing had been edited elsewhere, bit for bit.
void PatchLevelsFollowTest::detailFollowsAsWithoutTheEdits() {
  PatchLevels levels = onSphere(100, 2, 2), plain = levels;
  for (const Change change : kChanges)
    QVERIFY(levels.follow(changedAt(levels.mesh(), change, farFrom(levels.mesh(), levels.patch()))));
  QCOMPARE(levels.finest(), std::size_t(2));
  QVERIFY(!levels.patch().empty() && levels.patch() == plain.patch());
  const HalfEdgeMesh before = levels.mesh();
  swell(levels, 0, 0.02);
  swell(plain, 0, 0.02);
  std::size_t moved = 0;
  levels.patch().forEach([&](Face f) {
    QCOMPARE(levels.faceAt(0, f), plain.faceAt(0, f));
    for (const Vertex v : levels.mesh().triangle(f)) {
      QVERIFY(test::sameBits(levels.mesh().position(v), plain.mesh().position(v)));
      moved += levels.mesh().position(v) != before.position(v);
    }
  });
  QVERIFY(moved > 500);
  const auto last = static_cast<Face>(levels.mesh().faceSlots() - 1);  // last face of the tetrahedron
  QCOMPARE(levels.faceAt(0, last), last);
  levels.coarsen();
  levels.coarsen();
  QCOMPARE(validate(levels.mesh()), std::string());
  QCOMPARE(levels.mesh().liveFaceCount(), std::size_t(1280 - 1 + 2 + 4));
}

void PatchLevelsFollowTest::whatTouchesThePatchIsRefused() {
  const PatchLevels original = onSphere(100, 2, 2);
  const Face inside = original.patch().faces().front(), beside = shareEdgeWith(original.mesh(), original.patch());
  for (const Face f : {inside, beside}) {
    for (const Change change : {Change::Move, Change::Remove, Change::Split}) {
      PatchLevels levels = original;
      QVERIFY(!levels.follow(changedAt(levels.mesh(), change, f)));
      for (std::size_t i = 0; i <= 2; ++i) QVERIFY(test::sameMesh(levels.mesh(i), original.mesh(i)));
    }
  }
  PatchLevels levels = original;
  QVERIFY(!levels.follow(HalfEdgeMesh()));
}

void PatchLevelsFollowTest::anyEditsInAnyOrder() {
  const bool held = rc::check([] {
    PatchLevels levels = onSphere(*rc::gen::inRange<Face>(0, 1280), *rc::gen::inRange(1, 5), *rc::gen::inRange(1, 3));
    int followed = 0;
    for (int i = *rc::gen::inRange(1, 8); i > 0; --i) {
      const HalfEdgeMesh before = levels.mesh();
      const PatchLevels unedited = levels;
      const Face f = *rc::gen::inRange<Face>(0, static_cast<Face>(before.faceSlots()));
      if (!before.isLive(f)) continue;
      const HalfEdgeMesh after = changedAt(before, *rc::gen::elementOf(std::vector(kChanges, kChanges + 4)), f);
      const bool isElsewhere = !touches(before, after, levels.patch());
      RC_ASSERT(levels.follow(after) == isElsewhere);
      RC_ASSERT(test::sameMesh(levels.mesh(), isElsewhere ? after : before));
      checkLevels(levels);
      if (isElsewhere && *rc::gen::arbitrary<bool>()) {  // undone, and done once more
        const PatchLevels edited = levels;
        RC_ASSERT(levels.follow(before) && isSame(levels, unedited));
        RC_ASSERT(levels.follow(after) && isSame(levels, edited));
      }
      followed += isElsewhere;
      if (*rc::gen::inRange(0, 4) == 0 && levels.finest() < 3) levels.refine();
      if (*rc::gen::inRange(0, 4) == 0) swell(levels, *rc::gen::inRange<std::size_t>(0, levels.finest() + 1), 0.005);
      if (*rc::gen::inRange(0, 8) == 0 && levels.finest() > 1) levels.coarsen();
      checkLevels(levels);
    }
    RC_CLASSIFY(followed > 0);
  });
  QVERIFY(held);
}

HANDWHEEL_TEST(PatchLevelsFollowTest)
#include "PatchLevelsFollowTest.moc"

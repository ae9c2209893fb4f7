// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/MeshDelta.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

namespace {

// One low-level change; the mesh need not make sense afterwards.
void change(HalfEdgeMesh& mesh, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::uint32_t>(random() % n); };
  const Vec3 p(below(100), below(100), below(100));
  switch (below(6)) {
    case 0:
      mesh.addVertex(p);
      break;
    case 1:
      mesh.setPosition(below(mesh.vertexSlots()), p);
      break;
    case 2:
      mesh.addFace({below(mesh.vertexSlots()), below(mesh.vertexSlots()), below(mesh.vertexSlots())});
      break;
    case 3: {
      const HalfEdge h = below(mesh.halfEdgeSlots());
      if (mesh.isLive(HalfEdgeMesh::face(h))) mesh.setCorner(h, below(mesh.vertexSlots()));
      break;
    }
    case 4:
      mesh.pair(below(mesh.halfEdgeSlots()), below(mesh.halfEdgeSlots()));
      break;
    case 5: {
      // The neighbours of a dead face mean nothing to removeFace(), so each dies once.
      const Face f = below(mesh.faceSlots());
      if (mesh.isLive(f)) mesh.removeFace(f);
    }
  }
}

const HalfEdgeMesh& sphere() {
  static const HalfEdgeMesh mesh = buildMesh(test::icosphere(5)).mesh;  // 20 480 faces: several pages
  return mesh;
}

// Returns the faces whose corners or corner positions differ.
std::set<Face> changedLooks(const HalfEdgeMesh& a, const HalfEdgeMesh& b) {
  std::set<Face> faces;
  for (Face f = 0; f < std::max(a.faceSlots(), b.faceSlots()); ++f) {
    const bool inA = f < a.faceSlots() && a.isLive(f), inB = f < b.faceSlots() && b.isLive(f);
    if (inA != inB || (inA && a.points(f) != b.points(f))) faces.insert(f);
  }
  return faces;
}

}  // namespace

class MeshDeltaTest : public QObject {
  Q_OBJECT

 private slots:
  void nothingChanged();
  void undoAndRedo();
  void chainOfEdits();
  void touchedFaces();
  void sizeGrowsWithTheChange();
  void runs();
  void snapshotsStayAsTheyWere();
};

void MeshDeltaTest::nothingChanged() {
  HalfEdgeMesh mesh = sphere();
  QVERIFY(MeshDelta::between(sphere(), mesh).isEmpty());
  const Vec3 p = mesh.position(7);
  mesh.setPosition(7, Vec3(9, 9, 9));
  QVERIFY(!MeshDelta::between(sphere(), mesh).isEmpty());
  mesh.setPosition(7, p);
  MeshDelta back = MeshDelta::between(sphere(), mesh);
  QVERIFY(back.isEmpty());
  back.swap(mesh);
  QVERIFY(test::sameMesh(mesh, sphere()));
}

void MeshDeltaTest::undoAndRedo() {
  QVERIFY(rc::check("swapping leads there and back, slot by slot", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    HalfEdgeMesh before = *rc::gen::arbitrary<bool>() ? sphere() : buildMesh(test::cube()).mesh;
    HalfEdgeMesh after = before;
    for (int n = *rc::gen::inRange(0, 300); n > 0; --n) change(after, random);
    if (*rc::gen::arbitrary<bool>()) std::swap(before, after);  // a change that shrinks the mesh
    MeshDelta delta = MeshDelta::between(before, after, *rc::gen::element<std::size_t>(1, 2, 7, 64, 4096, 100'000));
    HalfEdgeMesh mesh = before;
    for (int round = 0; round < 2; ++round) {
      delta.swap(mesh);
      RC_ASSERT(test::sameMesh(mesh, after));
      delta.swap(mesh);
      RC_ASSERT(test::sameMesh(mesh, before));
    }
    RC_ASSERT(delta.isEmpty() == test::sameMesh(before, after));
    RC_ASSERT(MeshDelta::isEmptyBetween(before, after) == delta.isEmpty());
  }));
}

void MeshDeltaTest::chainOfEdits() {
  QVERIFY(rc::check("undoing and redoing at random follows the versions", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::vector<HalfEdgeMesh> versions{buildMesh(test::torus(8, 6)).mesh};
    std::vector<MeshDelta> history;
    HalfEdgeMesh mesh = versions[0];
    for (int i = 0; i < 8; ++i) {
      HalfEdgeMesh next = mesh;
      for (int n = 0; n < 20; ++n) change(next, random);
      history.push_back(MeshDelta::between(mesh, next));
      history.back().swap(mesh);
      versions.push_back(next);
    }
    for (std::size_t at = history.size(), step = 0; step < 40; ++step) {
      const bool undo = random() % 2;
      if (undo && at > 0) history[--at].swap(mesh);
      if (!undo && at < history.size()) history[at++].swap(mesh);
      RC_ASSERT(test::sameMesh(mesh, versions[at]));
    }
  }));
}

void MeshDeltaTest::touchedFaces() {
  QVERIFY(rc::check("every face that will look different is named, either way", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const HalfEdgeMesh before = buildMesh(test::torus(8, 6)).mesh;
    HalfEdgeMesh after = before;
    for (int n = *rc::gen::inRange(0, 20); n > 0; --n) change(after, random);
    MeshDelta delta = MeshDelta::between(before, after, *rc::gen::element<std::size_t>(1, 16, 4096));
    HalfEdgeMesh mesh = before;
    const std::set<Face> wanted = changedLooks(before, after);
    for (int round = 0; round < 2; ++round) {
      const std::vector<Face> named = delta.touchedFaces(mesh);
      const std::set<Face> names(named.begin(), named.end());
      RC_ASSERT(std::includes(names.begin(), names.end(), wanted.begin(), wanted.end()));
      delta.swap(mesh);
    }
  }));
}

// The size of a delta depends on the size of the change, not of the mesh.
void MeshDeltaTest::sizeGrowsWithTheChange() {
  const auto bytesFor = [](const HalfEdgeMesh& mesh, Vertex count) {
    HalfEdgeMesh after = mesh;
    for (Vertex v = 0; v < count; ++v) after.setPosition(v, Vec3(v, 1, 2));
    return MeshDelta::between(mesh, after).bytes();
  };
  const HalfEdgeMesh small = buildMesh(test::icosphere(3)).mesh;
  QCOMPARE(bytesFor(sphere(), 1), bytesFor(small, 1));
  const std::size_t of10 = bytesFor(sphere(), 10), of1000 = bytesFor(sphere(), 1000);
  QVERIFY(of10 < sizeof(MeshDelta) + 10 * 128);
  QVERIFY(of1000 > 1000 * sizeof(Vec3));
  QVERIFY(of1000 < sizeof(MeshDelta) + 1000 * 128);
}

// Every hundredth of 1000 vertices moved. With runs of 1, a number and a position are stored for each; with longer
// runs, those of the neighbours too.
void MeshDeltaTest::runs() {
  HalfEdgeMesh after = sphere();
  for (Vertex v = 0; v < 1000; v += 100) after.setPosition(v, Vec3(v, 1, 2));
  const auto bytesIn = [&](std::size_t run) { return MeshDelta::between(sphere(), after, run).bytes(); };
  const std::size_t single = bytesIn(1);
  QCOMPARE(single, sizeof(MeshDelta) + 10 * (sizeof(std::uint32_t) + sizeof(Vec3)));
  QCOMPARE(bytesIn(10), sizeof(MeshDelta) + 10 * (sizeof(std::uint32_t) + 10 * sizeof(Vec3)));
  QCOMPARE(bytesIn(1000), sizeof(MeshDelta) + sizeof(std::uint32_t) + 1000 * sizeof(Vec3));
  QCOMPARE(bytesIn(1'000'000), sizeof(MeshDelta) + sizeof(std::uint32_t) + 4096 * sizeof(Vec3));  // a page at most
}

void MeshDeltaTest::snapshotsStayAsTheyWere() {
  const HalfEdgeMesh snapshot = sphere();
  HalfEdgeMesh mesh = sphere();
  std::mt19937 random(5);
  for (int i = 0; i < 100; ++i) change(mesh, random);
  QVERIFY(test::sameMesh(snapshot, buildMesh(test::icosphere(5)).mesh));
  QVERIFY(!test::sameMesh(snapshot, mesh));
}

HANDWHEEL_TEST(MeshDeltaTest)
#include "MeshDeltaTest.moc"

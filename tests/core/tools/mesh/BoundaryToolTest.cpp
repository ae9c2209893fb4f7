// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoundaryFixture.h"
#include "TestClass.h"
#include "tools/mesh/MeshPreview.h"

#include <QTest>

using namespace handwheel;
using test::Kind;

// Tests the pointer input of BoundaryTool.
class BoundaryToolTest : public QObject, private test::BoundaryFixture {
  Q_OBJECT

 private slots:
  void init() { start(test::plateWithHole()); }
  void hoverShowsEdgeAndPoint();
  void clickChooses();
  void pullsAPoint();
  void stopsBeforeATriangleTurns();
  void aTremorIsAClick();
  void joinsPoints();
  void joinsOnlyWhatMay();
  void laysABridge();
  void bridgesByChoice();
  void controlLetsNothingAttract();
  void escPutsItBack();
  void theMeshChangedMeanwhile();
  void aDevice();
  void nothingOpen();
};

namespace {

bool hasVertexAt(const HalfEdgeMesh& mesh, const Vec3& p) {
  return test::allCoordinates(mesh.compact().soup).contains(test::coordinates(p));
}

}  // namespace

void BoundaryToolTest::hoverShowsEdgeAndPoint() {
  QCOMPARE(m_tool->pointer(test::above(Kind::Hover, -1.95, 0.0)), ToolReply::Used);
  QCOMPARE(m_tool->preview().lines.size(), std::size_t(1));
  QVERIFY(m_tool->preview().circle && m_tool->preview().circle->first == Vec3(-2, 0, 0));
  QVERIFY(m_tool->forces().empty());                      // snap targets make the forces instead
  m_tool->pointer(test::above(Kind::Hover, -1.95, 0.5));  // on the edge, between its points
  QVERIFY(!m_tool->preview().circle && m_tool->preview().lines.size() == 1);
  m_tool->pointer(test::above(Kind::Hover, -3.5, 0.5));
  QVERIFY(m_tool->preview().lines.empty());
  m_tool->pointer(test::above(Kind::Hover, -1.95, 0.0));
  m_tool->pointer(test::above(Kind::Leave, 0, 0));
  QVERIFY(m_tool->preview().lines.empty());
}

void BoundaryToolTest::clickChooses() {
  QCOMPARE(m_tool->pointer(test::above(Kind::Press, -3.5, 0.0)), ToolReply::Ignored);  // the camera's
  QVERIFY(!m_tool->loop() && !test::isEnabled(*m_tool, "smooth"));
  QCOMPARE(m_tool->pointer(test::above(Kind::Press, 0.0, 0.0)), ToolReply::Used);  // through the hole
  QVERIFY(m_tool->loop() && !m_tool->loop()->isSheetBoundary && test::isEnabled(*m_tool, "smooth"));
  m_tool->pointer(test::above(Kind::Press, -5.0, 0.5));
  QVERIFY(m_tool->loop()->isSheetBoundary);
  QCOMPARE(m_document->history()->count(), 0);
}

void BoundaryToolTest::pullsAPoint() {
  const HalfEdgeMesh before = mesh();
  drag(Vec3(-1.98, 0, 0), Vec3(-1.48, 0.3, 0));
  QCOMPARE(m_tool->problem(), JoinProblem::None);
  const ToolPreview preview = m_tool->preview();
  QCOMPARE(preview.parts.size(), std::size_t(1));
  QCOMPARE(preview.parts[0].soup->triangles.size(), std::size_t(3));
  QVERIFY(test::sameMesh(mesh(), before));
  m_tool->pointer(test::above(Kind::Release, -1.48, 0.3));
  QCOMPARE(oneStep(before), std::string());
  std::size_t moved = 0;
  for (Vertex v = 0; v < mesh().vertexSlots(); ++v) moved += !test::sameBits(mesh().position(v), before.position(v));
  QCOMPARE(moved, std::size_t(1));
  // Under the pointer, in the plane through the point that faces it.
  QVERIFY(hasVertexAt(mesh(), rounded(Vec3(-1.48, 0.3, 0), m_document->fileNumbers())));
}

void BoundaryToolTest::stopsBeforeATriangleTurns() {
  const HalfEdgeMesh before = mesh();
  drag(Vec3(-2, 0, 0), Vec3(-4, 0.5, 0));
  QCOMPARE(m_tool->problem(), JoinProblem::FlippedFace);
  QVERIFY(!problemOf("way").empty());
  m_tool->pointer(test::above(Kind::Release, -4, 0.5));
  QCOMPARE(oneStep(before), std::string());
  for (Face f = 0; f < mesh().faceSlots(); ++f) {
    const TrianglePoints p = mesh().points(f);
    QVERIFY((p[1] - p[0]).cross(p[2] - p[0]).z() > 0.0);
  }
}

void BoundaryToolTest::aTremorIsAClick() {
  drag(Vec3(-2, 0, 0), Vec3(-1.98, 0.01, 0));
  QVERIFY(m_tool->preview().parts.empty());
  m_tool->pointer(test::above(Kind::Release, -1.98, 0.01));
  QCOMPARE(m_document->history()->count(), 0);
  QVERIFY(m_tool->loop());
}

void BoundaryToolTest::joinsPoints() {
  start(test::plateWithIsland());
  const HalfEdgeMesh before = mesh();
  QCOMPARE(loops(), std::size_t(3));
  drag(Vec3(-2, 0, 0), Vec3(-5.95, 0.03, 0));
  QCOMPARE(m_tool->problem(), JoinProblem::None);
  QVERIFY(!meshPreviewOf(m_tool->preview()).highlighted.empty() && m_tool->preview().circle->first == Vec3(-6, 0, 0));
  // The thread pulls back, the point that attracts pulls on.
  const std::vector<DeviceSpring> forces = m_tool->forces();
  QCOMPARE(forces.size(), std::size_t(2));
  QCOMPARE(forces[0].target, Vec3(-2, 0, 0));
  QCOMPARE(forces[1].target, Vec3(-6, 0, 0));
  m_tool->pointer(test::above(Kind::Release, -5.95, 0.03));
  QCOMPARE(oneStep(before), std::string());
  QCOMPARE(loops(), std::size_t(2));
  QVERIFY(!hasVertexAt(mesh(), Vec3(-2, 0, 0)));
}

void BoundaryToolTest::joinsOnlyWhatMay() {
  const HalfEdgeMesh before = mesh();
  drag(Vec3(-2, 0, 0), Vec3(-5, 0, 0));  // over the plate to its rim
  QVERIFY(m_tool->problem() != JoinProblem::None && !problemOf("way").empty());
  QVERIFY(meshPreviewOf(m_tool->preview()).highlighted.empty());
  m_tool->pointer(test::above(Kind::Release, -5, 0));
  QVERIFY(test::sameMesh(mesh(), before));
  QCOMPARE(m_document->history()->count(), 0);
}

void BoundaryToolTest::laysABridge() {
  const HalfEdgeMesh before = mesh();
  drag(Vec3(0, -2, 0), Vec3(0, 1.95, 0), test::kShift);
  QCOMPARE(m_tool->problem(), JoinProblem::None);
  QCOMPARE(m_tool->preview().parts.at(0).soup->triangles.size(), std::size_t(2));
  m_tool->pointer(test::above(Kind::Release, 0, 1.95, test::kShift));
  QCOMPARE(oneStep(before), std::string());
  QCOMPARE(loops(), std::size_t(3));
  QCOMPARE(mesh().liveFaceCount(), before.liveFaceCount() + 2);
  // To no point there is no bridge.
  drag(Vec3(-2, 0, 0), Vec3(-1, 0.5, 0), test::kShift);
  QVERIFY(m_tool->preview().parts.empty());
  m_tool->pointer(test::above(Kind::Release, -1, 0.5, test::kShift));
  QCOMPARE(m_document->history()->count(), 1);
}

// With the choice a stylus does what takes Shift else, and Shift the other.
void BoundaryToolTest::bridgesByChoice() {
  m_tool->setSetting("onto", 1.0);
  m_tool->setSetting("onto", 2.0);  // there is no such
  drag(Vec3(0, -2, 0), Vec3(0, 1.95, 0));
  QCOMPARE(m_tool->preview().parts.at(0).soup->triangles.size(), std::size_t(2));
  const std::vector<DeviceSpring> forces = m_tool->forces();  // a thread, and the point that attracts
  QCOMPARE(forces.size(), std::size_t(2));
  QVERIFY(forces[0].stiffness > 0.0 && forces[0].damping > 0.0);
  m_tool->pointer(test::above(Kind::Release, 0, 1.95));
  QCOMPARE(loops(), std::size_t(3));
  drag(Vec3(-2, 0, 0), Vec3(-1.5, 0, 0), test::kShift);
  m_tool->pointer(test::above(Kind::Release, -1.5, 0, test::kShift));
  QVERIFY(hasVertexAt(mesh(), Vec3(-1.5, 0, 0)));
  QCOMPARE(m_document->history()->count(), 2);
}

void BoundaryToolTest::controlLetsNothingAttract() {
  drag(Vec3(-2, -2, 0), Vec3(-1.93, -1.05, 0), test::kControl);
  m_tool->pointer(test::above(Kind::Release, -1.93, -1.05, test::kControl));
  QVERIFY(hasVertexAt(mesh(), Vec3(-2, -1, 0)));
  QVERIFY(!hasVertexAt(mesh(), Vec3(-2, -2, 0)));
}

void BoundaryToolTest::escPutsItBack() {
  const HalfEdgeMesh before = mesh();
  drag(Vec3(-2, 0, 0), Vec3(-1.5, 0, 0));
  QCOMPARE(m_tool->perform("commit"), ToolReply::Ignored);
  QCOMPARE(m_tool->perform("revert"), ToolReply::Used);
  QVERIFY(m_tool->preview().parts.empty());
  QCOMPARE(m_tool->pointer(test::above(Kind::Release, -1.5, 0)), ToolReply::Ignored);
  QVERIFY(test::sameMesh(mesh(), before));
  QCOMPARE(m_tool->perform("revert"), ToolReply::Used);  // chooses none
  QVERIFY(!m_tool->loop());
  QCOMPARE(m_tool->perform("revert"), ToolReply::Finished);
}

// By the time a change is carried out the points may be elsewhere: then nothing happens.
void BoundaryToolTest::theMeshChangedMeanwhile() {
  test::WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(mesh());
  m_tool = std::make_unique<BoundaryTool>(*m_document, waiting.services());
  drag(Vec3(-2, 0, 0), Vec3(-1.5, 0, 0));
  m_tool->pointer(test::above(Kind::Release, -1.5, 0));
  drag(Vec3(-2, 0, 0), Vec3(-2, 1, 0));
  m_tool->pointer(test::above(Kind::Release, -2, 1));
  drag(Vec3(-2, 0, 0), Vec3(2, 0, 0), test::kShift);
  m_tool->pointer(test::above(Kind::Release, 2, 0, test::kShift));
  QCOMPARE(waiting.changes.size(), std::size_t(3));
  HalfEdgeMesh moved = mesh();
  for (Vertex v = 0; v < moved.vertexSlots(); ++v)
    if (moved.position(v) == Vec3(-2, 0, 0)) moved.setPosition(v, Vec3(-2, 0, 0.1));
  for (const MeshChange& change : waiting.changes) {
    HalfEdgeMesh same = moved, empty, done = mesh();
    change.apply(same, {});
    change.apply(empty, {});
    change.apply(done, {});
    QVERIFY(test::sameMesh(same, moved));
    QCOMPARE(empty.faceSlots(), std::size_t(0));
    QVERIFY(!test::sameMesh(done, mesh()));
    QCOMPARE(validate(done), std::string());
  }
}

// The tip of a device carries the point along in space.
void BoundaryToolTest::aDevice() {
  const HalfEdgeMesh before = mesh();
  PointerEvent event = test::above(Kind::Press, -2, 0);
  event.device = Pose(Eigen::Translation3d(-2, 0, 0.01));
  m_tool->pointer(event);
  event.kind = Kind::Drag;
  event.device = Pose(Eigen::Translation3d(-1.7, 0.1, 0.51));
  m_tool->pointer(event);
  QCOMPARE(m_tool->forces().at(0).target, Vec3(-2, 0, 0.01));  // back to where the tip took hold
  event.kind = Kind::Release;
  event.modifiers = test::kControl;
  m_tool->pointer(event);
  QCOMPARE(oneStep(before), std::string());
  const Vec3 position = Vec3(-2, 0, 0) + Vec3(-1.7, 0.1, 0.51) - Vec3(-2, 0, 0.01);
  QVERIFY(hasVertexAt(mesh(), rounded(position, m_document->fileNumbers())));
}

void BoundaryToolTest::nothingOpen() {
  for (const TriangleSoup& soup : {test::icosphere(1), TriangleSoup()}) {
    start(soup);
    m_tool->pointer(test::above(Kind::Hover, 0, 0));
    QCOMPARE(m_tool->pointer(test::above(Kind::Press, 0, 0)), ToolReply::Ignored);
    m_tool->perform("next");
    QVERIFY(!m_tool->loop() && !test::isEnabled(*m_tool, "next"));
    QCOMPARE(m_tool->perform("commit"), ToolReply::Finished);
  }
}

HANDWHEEL_TEST(BoundaryToolTest)
#include "BoundaryToolTest.moc"

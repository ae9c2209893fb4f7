// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/BoundaryTool.h"

#include "HoleShapes.h"
#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "ToolEvents.h"
#include "WaitingServices.h"
#include "mesh/MeshValidator.h"

#include <QTest>

using namespace handwheel;
using test::Kind;

class BoundaryToolTest : public QObject {
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
  void controlLetsNothingAttract();
  void escPutsItBack();
  void smoothsTheEdge();
  void settingsLookAgain();
  void removesIslands();
  void removesPeninsulas();
  void tellsWhenThereIsNothing();
  void keys();
  void followsTheDocument();
  void lateResultsAreNotShown();
  void theMeshChangedMeanwhile();
  void aDevice();
  void nothingOpen();

 private:
  void start(const TriangleSoup& soup);
  void drag(const Vec3& from, const Vec3& to, Modifiers modifiers = {});
  const HalfEdgeMesh& mesh() const { return m_document->mesh(); }
  std::size_t loops() const { return m_document->defects().loops.size(); }
  std::string problemOf(const char* property) const;
  // One step was made, it is sound, and undo leads back to the mesh before.
  std::string oneStep(const HalfEdgeMesh& before);

  std::unique_ptr<MeshDocument> m_document;
  std::unique_ptr<BoundaryTool> m_tool;
};

namespace {

bool hasVertexAt(const HalfEdgeMesh& mesh, const Vec3& p) {
  return test::places(mesh.compact().soup).contains(test::place(p));
}

}  // namespace

void BoundaryToolTest::start(const TriangleSoup& soup) {
  m_tool.reset();
  m_document = test::meshDocument(soup);
  m_tool = std::make_unique<BoundaryTool>(*m_document, immediateServices(*m_document));
  connect(m_document.get(), &Document::changed, this, [this] { m_tool->documentChanged(); });
}

void BoundaryToolTest::drag(const Vec3& from, const Vec3& to, Modifiers modifiers) {
  m_tool->pointer(test::above(Kind::Press, from.x(), from.y(), modifiers));
  const Vec3 middle = 0.5 * (from + to);
  m_tool->pointer(test::above(Kind::Drag, middle.x(), middle.y(), modifiers));
  m_tool->pointer(test::above(Kind::Drag, to.x(), to.y(), modifiers));
}

std::string BoundaryToolTest::problemOf(const char* property) const {
  const std::vector<Property> all = m_tool->settings();
  const Property* shown = test::propertyNamed(all, property);
  return shown ? shown->problem : "it is not shown";
}

std::string BoundaryToolTest::oneStep(const HalfEdgeMesh& before) {
  QUndoStack& history = *m_document->history();
  if (history.count() != 1 || history.index() != 1) return "not one step";
  if (const std::string broken = validate(mesh()); !broken.empty()) return broken;
  const HalfEdgeMesh after = mesh();
  if (test::sameMesh(before, after)) return "nothing changed";
  history.undo();
  if (!test::sameMesh(mesh(), before)) return "undo does not lead back";
  history.redo();
  if (!test::sameMesh(mesh(), after)) return "redo does not lead forth";
  return {};
}

void BoundaryToolTest::hoverShowsEdgeAndPoint() {
  QCOMPARE(m_tool->pointer(test::above(Kind::Hover, -1.95, 0.0)), ToolReply::Used);
  QCOMPARE(m_tool->preview().lines.size(), std::size_t(1));
  QVERIFY(m_tool->preview().circle && m_tool->preview().circle->first == Vec3(-2, 0, 0));
  QCOMPARE(m_tool->forces().size(), std::size_t(1));
  QCOMPARE(m_tool->forces()[0].target, Vec3(-2, 0, 0));
  m_tool->pointer(test::above(Kind::Hover, -1.95, 0.5));  // on the edge, between its points
  QVERIFY(!m_tool->preview().circle && m_tool->preview().lines.size() == 1);
  m_tool->pointer(test::above(Kind::Hover, -3.5, 0.5));
  QVERIFY(m_tool->preview().lines.empty() && m_tool->forces().empty());
  m_tool->pointer(test::above(Kind::Hover, -1.95, 0.0));
  m_tool->pointer(test::above(Kind::Leave, 0, 0));
  QVERIFY(m_tool->preview().lines.empty());
}

void BoundaryToolTest::clickChooses() {
  QCOMPARE(m_tool->pointer(test::above(Kind::Press, -3.5, 0.0)), ToolReply::Ignored);  // the camera's
  QVERIFY(!m_tool->loop() && !test::isEnabled(*m_tool, "smooth"));
  QCOMPARE(m_tool->pointer(test::above(Kind::Press, 0.0, 0.0)), ToolReply::Used);  // through the hole
  QVERIFY(m_tool->loop() && !m_tool->loop()->rim && test::isEnabled(*m_tool, "smooth"));
  m_tool->pointer(test::above(Kind::Press, -5.0, 0.5));
  QVERIFY(m_tool->loop()->rim);
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
  QVERIFY(hasVertexAt(mesh(), Vec3(-1.48, 0.3, 0)));
}

void BoundaryToolTest::stopsBeforeATriangleTurns() {
  const HalfEdgeMesh before = mesh();
  drag(Vec3(-2, 0, 0), Vec3(-4, 0.5, 0));
  QCOMPARE(m_tool->problem(), JoinProblem::TurnsOver);
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
  QVERIFY(!m_tool->preview().highlighted.empty() && m_tool->preview().circle->first == Vec3(-6, 0, 0));
  // The thread pulls back, the point that attracts pulls on.
  const std::vector<ForceTerm> forces = m_tool->forces();
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
  QVERIFY(m_tool->preview().highlighted.empty());
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

void BoundaryToolTest::smoothsTheEdge() {
  start(test::sphereWithoutCap(3, 0.5));
  const HalfEdgeMesh before = mesh();
  m_tool->perform("next");
  QCOMPARE(m_tool->perform("smooth"), ToolReply::Used);
  QCOMPARE(m_tool->preview().parts.size(), std::size_t(1));
  QVERIFY(test::sameMesh(mesh(), before));
  QCOMPARE(m_tool->perform("commit"), ToolReply::Used);
  QCOMPARE(oneStep(before), std::string());
  QCOMPARE(m_tool->perform("commit"), ToolReply::Finished);
}

void BoundaryToolTest::settingsLookAgain() {
  start(test::sphereWithoutCap(4, 0.5));
  m_tool->perform("next");
  m_tool->perform("smooth");
  const auto first = m_tool->preview().parts.at(0).soup->points;
  m_tool->setSetting("wavelength", 20.0);
  QVERIFY(m_tool->preview().parts.at(0).soup->points != first);
  m_tool->setSetting("wavelength", 8.0);
  QVERIFY(m_tool->preview().parts.at(0).soup->points == first);
  m_tool->setSetting("wavelength", 0.0);
  m_tool->setSetting("evenly", false);
  QVERIFY(m_tool->preview().parts.empty() && !test::isEnabled(*m_tool, "commit"));
  for (const PropertyValue& odd : {PropertyValue(std::nan("")), PropertyValue("8"), PropertyValue(true)})
    m_tool->setSetting("wavelength", odd);
  QCOMPARE(std::get<double>(test::propertyNamed(m_tool->settings(), "wavelength")->value), 0.0);
  m_tool->setSetting("wavelength", 1e300);
  QVERIFY(std::get<double>(test::propertyNamed(m_tool->settings(), "wavelength")->value) <= 100.0);
}

void BoundaryToolTest::removesIslands() {
  start(test::plateWithIsland());
  const HalfEdgeMesh before = mesh();
  m_tool->pointer(test::above(Kind::Press, -4, 0));  // between island and rim
  QVERIFY(m_tool->loop() && !m_tool->loop()->rim);
  m_tool->perform("islands");
  const FaceSelection marked = m_tool->preview().selected;
  QVERIFY(marked.count() > 0 && test::isEnabled(*m_tool, "commit"));
  m_tool->perform("commit");
  QCOMPARE(oneStep(before), std::string());
  QCOMPARE(loops(), std::size_t(2));
  QCOMPARE(mesh().liveFaceCount(), before.liveFaceCount() - marked.count());
}

void BoundaryToolTest::removesPeninsulas() {
  start(test::plateWithTongue());
  const HalfEdgeMesh before = mesh();
  m_tool->pointer(test::above(Kind::Press, 4, 0));
  m_tool->perform("peninsulas");
  const FaceSelection marked = m_tool->preview().selected;
  QVERIFY(marked.count() >= 28 && marked.count() <= 33);
  m_tool->perform("commit");
  QCOMPARE(oneStep(before), std::string());
  QCOMPARE(mesh().liveFaceCount(), before.liveFaceCount() - marked.count());
}

void BoundaryToolTest::tellsWhenThereIsNothing() {
  m_tool->pointer(test::above(Kind::Press, 0, 0));
  for (const char* action : {"islands", "peninsulas"}) {
    m_tool->perform(action);
    QVERIFY(!problemOf("faces").empty() && !test::isEnabled(*m_tool, "commit"));
    QCOMPARE(m_tool->perform("commit"), ToolReply::Ignored);
    QCOMPARE(m_tool->perform("revert"), ToolReply::Used);
    QVERIFY(m_tool->loop());  // only the proposal went
  }
  QCOMPARE(m_document->history()->count(), 0);
}

void BoundaryToolTest::keys() {
  std::set<std::string> inputs;
  for (const ToolAction& action : m_tool->actions())
    if (!action.id.empty()) QVERIFY2(inputs.insert(action.input).second, action.input.c_str());
  QCOMPARE(m_tool->perform("smooth"), ToolReply::Ignored);  // nothing is chosen
  m_tool->perform("next");
  const Vertex first = keyOf(mesh(), *m_tool->loop());
  m_tool->perform("next");
  QVERIFY(keyOf(mesh(), *m_tool->loop()) != first);
  m_tool->perform("previous");
  QCOMPARE(keyOf(mesh(), *m_tool->loop()), first);
  QCOMPARE(m_tool->perform("nonsense"), ToolReply::Ignored);
}

void BoundaryToolTest::followsTheDocument() {
  m_tool->pointer(test::above(Kind::Press, 0, 0));
  m_tool->perform("smooth");
  HalfEdgeMesh closed = mesh();
  FaceSelection all = FaceSelection::all(closed);
  removeFaces(closed, all);
  drag(Vec3(-2, 0, 0), Vec3(-1.5, 0, 0));
  m_document->commit("Elsewhere", inspected(closed));
  QVERIFY(!m_tool->loop() && !m_tool->isBusy());
  QCOMPARE(m_tool->pointer(test::above(Kind::Release, -1.5, 0)), ToolReply::Ignored);
  m_document->history()->undo();
  QCOMPARE(loops(), std::size_t(2));
}

void BoundaryToolTest::lateResultsAreNotShown() {
  test::WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(mesh());
  std::function<void()> late;
  {
    BoundaryTool tool(*m_document, waiting.services());
    tool.perform("next");
    tool.perform("smooth");
    QVERIFY(tool.isBusy() && !test::isEnabled(tool, "commit"));
    QCOMPARE(tool.perform("commit"), ToolReply::Ignored);
    const auto first = waiting.work();
    tool.perform("peninsulas");
    first();
    QVERIFY(tool.preview().parts.empty());
    tool.perform("revert");
    QCOMPARE(waiting.cancelled, 2);
    waiting.work()();
    QVERIFY(!tool.isBusy());
    tool.perform("smooth");
    late = waiting.work();
  }
  late();  // the tool is gone
  QCOMPARE(waiting.cancelled, 3);
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
  const Vec3 place = Vec3(-2, 0, 0) + Vec3(-1.7, 0.1, 0.51) - Vec3(-2, 0, 0.01);
  QVERIFY(hasVertexAt(mesh(), place));
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

QTEST_GUILESS_MAIN(BoundaryToolTest)
#include "BoundaryToolTest.moc"

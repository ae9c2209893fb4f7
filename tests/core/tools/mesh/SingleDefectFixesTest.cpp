// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshValidator.h"
#include "tools/mesh/MeshScript.h"
#include "tools/mesh/repair/ChangePreview.h"
#include "tools/mesh/repair/DefectFixes.h"

#include <QTest>

using namespace handwheel;

namespace {

// Two defects of a kind: the fix of one leaves the other, the preview has shown what it does, and its step does the
// same.
class OneOfTwo {
 public:
  explicit OneOfTwo(const TriangleSoup& soup)
      : m_document(test::meshDocument(soup, "/scans/part.stl", NumberType::Float64)),
        m_replayed(test::meshDocument(soup, "/scans/part.stl", NumberType::Float64)) {}

  const Defects& defects() const { return m_document->defects(); }
  const HalfEdgeMesh& mesh() const { return m_document->mesh(); }

  // Makes a change and returns its flaw; empty: none.
  std::string make(const MeshChange& change) {
    const HalfEdgeMesh before = mesh();
    const ChangePreview preview = previewOf(change, before);
    if (!commitChange(*m_document, change)) return "nothing was changed";
    const auto replayed = applyScriptLine(*m_replayed, change.step);
    if (!replayed || !test::sameMesh(m_replayed->mesh(), mesh())) return "the step does something else";
    if (before.liveFaceCount() - preview.removed.count() + preview.added.triangles.size() != mesh().liveFaceCount())
      return "the preview has other triangles";
    for (Face f = 0; f < before.faceSlots(); ++f) {
      const bool stays = mesh().isLive(f) && before.isLive(f) && mesh().points(f) == before.points(f);
      if (before.isLive(f) && stays == preview.removed.contains(f)) return "the preview marks other triangles";
    }
    return validate(mesh());
  }

 private:
  std::unique_ptr<MeshDocument> m_document, m_replayed;
};

std::vector<Vertex> endsOf(const std::pair<Vertex, Vertex>& edge) {
  return {edge.first, edge.second};
}

}  // namespace

class SingleDefectFixesTest : public QObject {
  Q_OBJECT

 private slots:
  void degenerate();
  void needlesThatHangTogether();
  void duplicate();
  void edge();
  void vertex();
  void everyVertex();
  void oneSided();
  void previewOfNothing();
  void previewCancelled();
};

void SingleDefectFixesTest::degenerate() {
  TriangleSoup soup = test::cube();
  test::addNeedles(soup, 0, 0, {0.5});
  test::addNeedles(soup, 6, 0, {0.5});
  OneOfTwo two(soup);
  const std::vector<Face> faces = two.defects().degenerateFaces;
  QCOMPARE(faces.size(), std::size_t(2));
  QCOMPARE(two.make(degenerateFix({faces[1]})), std::string());
  QCOMPARE(two.defects().degenerateFaces, std::vector<Face>{faces[0]});
  QVERIFY(test::countEdges(two.mesh()).sound());
}

// A needle that has needles at both sides can be flipped only after one of them: no gap is left.
void SingleDefectFixesTest::needlesThatHangTogether() {
  TriangleSoup soup = test::cube();
  test::addNeedles(soup, 4, 0, {0.25, 0.5, 0.75});
  for (std::size_t row = 0; row < 3; ++row) {
    OneOfTwo three(soup);
    QCOMPARE(three.make(degenerateFix({three.defects().degenerateFaces.at(row)})), std::string());
    QVERIFY(three.defects().degenerateFaces.empty());
    QVERIFY(test::countEdges(three.mesh()).sound());
    QVERIFY(std::abs(test::volume(three.mesh().compact().soup) - 1.0) < 1e-12);
  }
}

void SingleDefectFixesTest::duplicate() {
  TriangleSoup soup = test::cube();
  for (const std::size_t t : {std::size_t{3}, std::size_t{8}}) soup.triangles.push_back(soup.triangles[t]);
  OneOfTwo two(soup);
  const std::vector<Face> faces = two.defects().duplicateFaces;
  QCOMPARE(faces.size(), std::size_t(2));
  QCOMPARE(two.make(duplicateFix({faces[1]})), std::string());
  QCOMPARE(two.defects().duplicateFaces, std::vector<Face>{faces[0]});
  QCOMPARE(two.mesh().liveFaceCount(), std::size_t(13));
}

void SingleDefectFixesTest::edge() {
  TriangleSoup soup = test::twoCubesSharingAnEdge();
  test::append(soup, test::moved(test::twoCubesSharingAnEdge(), {10, 0, 0}));
  OneOfTwo two(soup);
  const auto edges = two.defects().nonManifoldEdges;
  QCOMPARE(edges.size(), std::size_t(2));
  QCOMPARE(two.make(nonManifoldFix(NumberType::Float64, endsOf(edges[1]))), std::string());
  QCOMPARE(two.defects().nonManifoldEdges, decltype(edges){edges[0]});
}

void SingleDefectFixesTest::vertex() {
  TriangleSoup soup = test::twoCubesSharingAVertex();
  test::append(soup, test::moved(test::twoCubesSharingAVertex(), {10, 0, 0}));
  OneOfTwo two(soup);
  const std::vector<Vertex> vertices = two.defects().nonManifoldVertices;
  QCOMPARE(vertices.size(), std::size_t(2));
  QCOMPARE(two.make(nonManifoldFix(NumberType::Float64, {vertices[1]})), std::string());
  QCOMPARE(two.defects().nonManifoldVertices, std::vector<Vertex>{vertices[0]});
  QCOMPARE(findSelfIntersections(two.mesh())->size(), std::size_t(0));
}

// Two solids that touch in a vertex only have no edge too many, and are separated all the same.
void SingleDefectFixesTest::everyVertex() {
  TriangleSoup soup = test::twoCubesSharingAVertex();
  test::append(soup, test::moved(test::twoCubesSharingAnEdge(), {10, 0, 0}));
  OneOfTwo both(soup);
  QCOMPARE(both.make(nonManifoldFix(NumberType::Float64)), std::string());
  QVERIFY(both.defects().nonManifoldVertices.empty() && both.defects().nonManifoldEdges.empty());
  QVERIFY(test::countEdges(both.mesh()).sound());
}

void SingleDefectFixesTest::oneSided() {
  TriangleSoup soup = test::kleinBottle(20, 8);
  const std::size_t first = soup.triangles.size();
  test::append(soup, test::moved(test::kleinBottle(20, 8), {20, 0, 0}));
  OneOfTwo two(soup);
  const auto edges = two.defects().nonOrientableEdges;
  FillOptions options;
  options.numbers = NumberType::Float64;
  QCOMPARE(two.make(nonOrientableFix(options, endsOf(edges.back()))), std::string());
  // The other has all its edges yet, and none of its triangles was touched.
  QVERIFY(!two.defects().nonOrientableEdges.empty());
  for (const auto& [a, b] : two.defects().nonOrientableEdges) QVERIFY(two.mesh().position(a).x() < 10.0);
  for (Face f = 0; f < first; ++f) QVERIFY(two.mesh().isLive(f));
  QVERIFY(test::countEdges(two.mesh()).closed());
}

void SingleDefectFixesTest::previewOfNothing() {
  const auto document = test::meshDocument(test::cube(), "/scans/part.stl", NumberType::Float64);
  const MeshChange change = nonManifoldFix(NumberType::Float64);
  const ChangePreview preview = previewOf(change, document->mesh());
  QVERIFY(preview.isEmpty());
  QCOMPARE(preview.reason, change.reason);
}

void SingleDefectFixesTest::previewCancelled() {
  TriangleSoup soup = test::cube();
  soup.triangles.push_back(soup.triangles[3]);
  const auto document = test::meshDocument(soup, "/scans/part.stl", NumberType::Float64);
  QVERIFY(!previewOf(duplicateFix(), document->mesh()).isEmpty());
  JobState state;
  state.cancelled = true;
  const ChangePreview preview = previewOf(duplicateFix(), document->mesh(), Progress(state));
  QVERIFY(preview.isEmpty() && !preview.reason);
}

HANDWHEEL_TEST(SingleDefectFixesTest)
#include "SingleDefectFixesTest.moc"

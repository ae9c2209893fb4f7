// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/repair/RemainingDefects.h"

#include "HoleShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

namespace {

struct Left {
  InspectedMesh after;
  RemainingDefects reasons;

  Left(const TriangleSoup& soup, const RepairOptions& options) {
    HalfEdgeMesh mesh = buildMesh(soup).mesh;
    const RepairReport report = repair(mesh, options);
    after = inspected(std::move(mesh));
    reasons = remainingDefects(after, report);
  }
};

bool says(const char* reason, const char* words) {
  return QString::fromUtf8(reason).contains(QLatin1String(words));
}

}  // namespace

// Each row says its own reason.
class RemainingDefectsTest : public QObject {
  Q_OBJECT

 private slots:
  void nothingLeft();
  void nearAtAKeptBoundary();
  void oneSided();
};

void RemainingDefectsTest::nothingLeft() {
  const Left left(test::torusWithSlits(1e-5), {});
  QVERIFY(left.reasons.nearVertices.empty() && left.reasons.nonOrientableEdges.empty());
  QVERIFY(left.reasons.nonManifoldEdges.empty() && left.reasons.nonManifoldVertices.empty());
}

// The hole with the slit is to stay open, so its near vertices stay apart.
void RemainingDefectsTest::nearAtAKeptBoundary() {
  RepairOptions options;
  const HalfEdgeMesh mesh = buildMesh(test::torusWithSlits(1e-5)).mesh;
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh))
    if (loop.borderEdges > 10) options.keepOpen.insert(loop.id);
  QCOMPARE(options.keepOpen.size(), std::size_t{1});
  const Left left(test::torusWithSlits(1e-5), options);
  QCOMPARE(left.after.defects->nearVertices.size(), std::size_t{2});
  QCOMPARE(left.reasons.nearVertices.size(), std::size_t{2});
  for (const char* reason : left.reasons.nearVertices) QVERIFY2(says(reason, "stay open"), reason);
}

// A Klein bottle is cut inside, but not along such a short cycle.
void RemainingDefectsTest::oneSided() {
  const Left left(test::kleinBottle(20, 8), {});
  QVERIFY(!left.after.defects->nonOrientableEdges.empty());
  QCOMPARE(left.reasons.nonOrientableEdges.size(), left.after.defects->nonOrientableEdges.size());
  for (const char* reason : left.reasons.nonOrientableEdges) QVERIFY2(says(reason, "longer than"), reason);
}

HANDWHEEL_TEST(RemainingDefectsTest)
#include "RemainingDefectsTest.moc"

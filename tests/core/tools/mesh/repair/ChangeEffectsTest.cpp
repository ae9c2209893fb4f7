// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/repair/ChangeEffects.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

class ChangeEffectsTest : public QObject {
  Q_OBJECT

 private slots:
  void onlyNewDebrisWasCutOff();
};

// Beside a ball there are two flakes, one of which was debris before.
void ChangeEffectsTest::onlyNewDebrisWasCutOff() {
  const TriangleSoup flake{{{9, 0, 0}, {9.01, 0, 0}, {9, 0.01, 0}}, {{0, 1, 2}}};
  TriangleSoup soup = test::sphereWithoutCap(4);
  const auto old = static_cast<Face>(soup.triangles.size());
  test::append(soup, flake);
  test::append(soup, test::moved(flake, {1, 0, 0}));
  const InspectedMesh after = inspected(buildMesh(soup).mesh);
  const TrianglePoints cut = after.mesh.points(old + 1);
  QCOMPARE(cutOffCorners(after.mesh, FaceSelection{old}, after),
           (std::set<PointKey>{positionKey(cut[0]), positionKey(cut[1]), positionKey(cut[2])}));
  QVERIFY(cutOffCorners(after.mesh, FaceSelection{old, old + 1}, after).empty());
  // A surface that was made anew, as from voxels, counts as not cut.
  const InspectedMesh other = inspected(buildMesh(test::moved(soup, {0, 0, 1})).mesh);
  QVERIFY(cutOffCorners(other.mesh, FaceSelection{}, after).empty());
}

HANDWHEEL_TEST(ChangeEffectsTest)
#include "ChangeEffectsTest.moc"

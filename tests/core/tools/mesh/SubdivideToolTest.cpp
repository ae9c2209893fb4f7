// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/SubdivideTool.h"

#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "ScriptWork.h"
#include "TestClass.h"
#include "mesh/structure/MeshValidator.h"
#include "tools/mesh/ManualMeshChanges.h"

#include <QTest>

using namespace handwheel;

class SubdivideToolTest : public QObject {
  Q_OBJECT

 private slots:
  void everyScheme();
  void leavesTheSurfaceUnlessAsked();
  void saysHowFarTheSurfaceMoves();
  void tooMany();
  void aRefusalHasItsReason();
};

// In the document as one step, which does the same once more.
void SubdivideToolTest::everyScheme() {
  for (const auto& [method, faces] :
       {std::pair(0.0, 1280), std::pair(1.0, 720), std::pair(2.0, 1280), std::pair(3.0, 1280)}) {
    test::Work work(test::icosphere(1));
    SubdivideTool tool(*work.document, work.services());
    tool.setSetting("method", method);
    tool.setSetting("times", 2.0);
    QCOMPARE(tool.perform("commit"), ToolReply::Used);
    QCOMPARE(work.document->mesh().liveFaceCount(), std::size_t(faces));
    QCOMPARE(validate(work.document->mesh()), std::string());
    QVERIFY2(work.step().starts_with("subdivide-mesh "), work.step().c_str());
    QCOMPARE(work.check(1), std::string());
  }
}

void SubdivideToolTest::leavesTheSurfaceUnlessAsked() {
  test::Work work(test::icosphere(1));
  const double area = test::area(test::icosphere(1));
  SubdivideTool tool(*work.document, work.services());
  QCOMPARE(tool.perform("commit"), ToolReply::Used);
  QCOMPARE(work.document->mesh().liveFaceCount(), std::size_t{320});
  QVERIFY(std::abs(test::area(work.document->mesh().compact().soup) - area) < 1e-6 * area);
  QCOMPARE(work.check(1), std::string());
  // The step without a method does the same, in the window as on the command line.
  QVERIFY(schemeSubdivisionOf(OperationValues(subdivideMeshOperation())).scheme == SubdivisionScheme::Midpoint);
}

// Both schemes cut the corners of a cube of side 2, by less than the distance to its middle.
void SubdivideToolTest::saysHowFarTheSurfaceMoves() {
  const auto distanceOf = [](SubdivisionScheme scheme) {
    const auto document = test::meshDocument(test::cube(2.0));
    const MeshChange change = subdivideMeshChange({scheme, 1}, NumberType::Float64);
    commitChange(*document, change);
    return *change.distance;
  };
  QVERIFY(!distanceOf(SubdivisionScheme::Midpoint));
  for (const auto scheme : {SubdivisionScheme::Loop, SubdivisionScheme::Sqrt3}) {
    QVERIFY(distanceOf(scheme));
    QVERIFY(*distanceOf(scheme) > 0.1 && *distanceOf(scheme) < 1.0);
  }
}

void SubdivideToolTest::tooMany() {
  const auto document = test::meshDocument(test::icosphere(1));
  SubdivideTool tool(*document, immediateServices(*document));
  const auto isOffered = [&] { return tool.actions().front().enabled; };
  QVERIFY(isOffered());
  tool.setSetting("times", 9.0);  // 80 · 4^9 are 21 million
  QVERIFY(!isOffered());
  tool.setSetting("times", -3.0);
  tool.setSetting("method", 7.0);
  QVERIFY(isOffered());
}

void SubdivideToolTest::aRefusalHasItsReason() {
  const auto document = test::meshDocument(test::boxWithInnerWall());
  const HalfEdgeMesh before = document->mesh();
  const MeshChange change = subdivideMeshChange({}, NumberType::Float64);
  QVERIFY(!commitChange(*document, change));
  QVERIFY(std::string(reasonOf(change)).find("more than two triangles") == 0);
  QVERIFY(test::sameMesh(document->mesh(), before));
}

HANDWHEEL_TEST(SubdivideToolTest)
#include "SubdivideToolTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../StlFiles.h"
#include "MeshDocuments.h"
#include "TestClass.h"
#include "window/mesh/HolePicking.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

// A torus about z with radii 30 and 10 and one quad missing: on top, at x = 30, between the angles of the quads around
// it.
class HolePickingTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<MeshDocument> m_document;
  std::unique_ptr<DefectList> m_defectList;

 private slots:
  void initTestCase() {
    TriangleSoup soup;
    for (const Corners& t : quadTorus(48, 24, {{0, 6}, {24, 18}})) {  // one on top, one below
      const auto first = std::uint32_t(soup.points.size());
      for (const Corner& c : t) soup.points.emplace_back(c[0], c[1], c[2]);
      soup.triangles.push_back({first, first + 1, first + 2});
    }
    m_document = test::meshDocument(soup);
    m_defectList = std::make_unique<DefectList>(*m_document);
    QCOMPARE(m_defectList->loopCount(), 2);
  }

  void pointingThroughAHolePicksIt() {
    const CameraState fromAbove;  // x right, y up
    const int top = m_defectList->loop(0).centre.z() > 0 ? 0 : 1;
    const Vec3 middle = m_defectList->loop(top).centre;
    const Vec3 inside(middle.x(), middle.y(), -10.0);  // the far wall, seen through the hole
    QCOMPARE(loopAround(*m_defectList, fromAbove, inside, inside), top);
    QCOMPARE(loopAround(*m_defectList, fromAbove, inside, std::nullopt), top);
  }

  void pointingBesideOrInFrontPicksNothing() {
    const CameraState fromAbove;
    const int top = m_defectList->loop(0).centre.z() > 0 ? 0 : 1;
    const Vec3 middle = m_defectList->loop(top).centre;
    const Vec3 beside = middle + Vec3(0, 8, 0);
    QCOMPARE(loopAround(*m_defectList, fromAbove, beside, beside), -1);
    const Vec3 before = middle + Vec3(0, 0, 1);
    QCOMPARE(loopAround(*m_defectList, fromAbove, before, before), -1);
    // The lower hole is behind the upper side of the torus.
    const Vec3 below = m_defectList->loop(1 - top).centre;
    const Vec3 upperSide(below.x(), below.y(), 10.0);
    QCOMPARE(loopAround(*m_defectList, fromAbove, upperSide, upperSide), -1);
  }
};

HANDWHEEL_TEST(HolePickingTest)
#include "HolePickingTest.moc"

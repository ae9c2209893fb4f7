// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/defects/DefectModel.h"

#include <QAbstractItemModelTester>
#include "MeshDocuments.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;

namespace {

// A strip of separate triangles: each is a sheet of its own, and so a rim.
std::unique_ptr<MeshDocument> scatteredTriangles(int count) {
  TriangleSoup soup;
  for (int i = 0; i < count; ++i) {
    const auto first = std::uint32_t(soup.points.size());
    for (const Vec3& p : {Vec3(3.0 * i, 0, 0), Vec3(3.0 * i + 1, 0, 0), Vec3(3.0 * i, 2, 0)}) soup.points.push_back(p);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return test::meshDocument(soup);
}

}  // namespace

class DefectModelTest : public QObject {
  Q_OBJECT

 private slots:
  void isASoundModelWithTenThousandRows() {
    const auto document = scatteredTriangles(10000);
    DefectList defectList(*document);
    DefectModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setDefectList(&defectList);
    QCOMPARE(model.rowCount(), kDefectKinds);
    int rows = 0;
    for (DefectKind kind : {DefectKind::Hole, DefectKind::KeptOpen}) rows += model.rowCount(model.groupIndex(kind));
    QCOMPARE(rows, 10000);
    for (int loop : {0, 4711, 9999}) {
      const QModelIndex index = model.loopIndex(loop);
      QCOMPARE(index.data(DefectModel::LoopRole).toInt(), loop);
      // 1 + 2 + sqrt(5)
      QVERIFY(index.data(DefectModel::DetailRole).toString().contains("5.24 mm"));
    }
    QVERIFY(!model.loopIndex(10000).isValid());
    QVERIFY(!model.loopIndex(-1).isValid());
  }

  void placesAreWhereTheDefectsAre() {
    const auto document = scatteredTriangles(3);
    DefectList defectList(*document);
    DefectModel model;
    model.setDefectList(&defectList);
    const auto [box, outward] = model.viewTargetOf(model.loopIndex(1));
    QCOMPARE(box.min().x(), 3.0);
    QCOMPARE(box.max().y(), 2.0);
    QVERIFY(outward.z() > 0 && outward.x() == 0 && outward.y() == 0);
  }

  // The count is that of "handwheel inspect": open edges, not those of the loop that other faces share in the file.
  void edgesAreOpenOnes() {
    TriangleSoup soup;  // three triangles at one edge: one of them has an edge that only a seam joins
    soup.points = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, 1}};
    soup.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
    const auto document = test::meshDocument(soup);
    DefectList defectList(*document);
    std::size_t open = 0;
    for (const BoundaryLoop& loop : document->defects().loops) {
      open += loop.borderEdges;
      const QString edges = QLocale().toString(qulonglong(loop.borderEdges)) + " edge";
      QVERIFY2(defectList.loopDetail(loop.id).startsWith(edges), qPrintable(defectList.loopDetail(loop.id)));
    }
    QCOMPARE(open, std::size_t{6});
  }

  void aRowHasTheFacesOfItsDefect() {
    const auto document = scatteredTriangles(3);
    DefectList defectList(*document);
    defectList.setSelfIntersections(document->revision(), {{0, 1}, {1, 2}});
    DefectModel model;
    model.setDefectList(&defectList);
    const QModelIndex group = model.groupIndex(DefectKind::SelfIntersection);
    QCOMPARE(model.facesOf(model.index(1, 0, group)), (std::vector<Face>{1, 2}));
    QVERIFY(model.facesOf(group).empty());
    QVERIFY(model.facesOf(QModelIndex()).empty());
  }
};

HANDWHEEL_TEST(DefectModelTest)
#include "DefectModelTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Cells.h"

#include "TestClass.h"
#include "document/cell/CellDisplay.h"

#include <QDirIterator>
#include <QTest>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

// Real robots with their meshes; not part of the sources.
class CellFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void opens_data();
  void opens();
  void partsTouch_data() { opens_data(); }
  void partsTouch();
};

void CellFilesTest::initTestCase() {
  if (qEnvironmentVariableIsEmpty("HANDWHEEL_DATA")) QSKIP("HANDWHEEL_DATA is not set: real robots are left out");
}

void CellFilesTest::opens_data() {
  QTest::addColumn<QString>("path");
  QDirIterator files(qEnvironmentVariable("HANDWHEEL_DATA") + "/robots", {"*.urdf"}, QDir::Files,
                     QDirIterator::Subdirectories);
  while (files.hasNext()) {
    const QString path = files.next();
    QTest::newRow(qPrintable(files.fileName())) << path;
  }
}

// Nothing is missing or damaged, and the container gives it all back.
void CellFilesTest::opens() {
  QFETCH(QString, path);
  const OpenedFile opened = importOrThrow(path);
  QVERIFY(opened.file.damage.empty());
  const RobotCellSnapshot& cell = cellIn(opened);
  for (const auto& surface : cell.robot->surfaces) QVERIFY(surface && !surface->triangles.empty());
  Container container;
  opened.kind->save(cell, container);
  std::vector<Error> damage;
  const Result<SnapshotPointer> again = opened.kind->load(container, damage, {});
  QVERIFY(again.hasValue() && damage.empty());
  const DisplayModel before = opened.kind->display(cell), after = opened.kind->display(**again);
  QCOMPARE(before.parts.size(), after.parts.size());
  for (std::size_t i = 0; i < before.parts.size(); ++i) {
    QVERIFY(before.parts[i].soup->points == after.parts[i].soup->points);
    QVERIFY(before.parts[i].soup->triangles == after.parts[i].soup->triangles);
    QVERIFY(before.parts[i].pose.isApprox(after.parts[i].pose, 1e-15));
  }
}

// A wrong unit tears a robot apart or makes it a speck: its size is that of a robot, and the boxes of the parts hang
// together, whatever the joints do.
void CellFilesTest::partsTouch() {
  QFETCH(QString, path);
  const OpenedFile opened = importOrThrow(path);
  const RobotCellSnapshot& cell = cellIn(opened);
  const DisplayModel model = displayOf(*cell.robot, cell.joints);
  const double size = model.bounds().diagonal().norm();
  QVERIFY2(size > 500 && size < 4000, qPrintable(QString::number(size)));
  std::vector<Box> boxes;
  for (const DisplayPart& part : model.parts) {
    boxes.push_back(DisplayModel{{part}}.bounds());
    QVERIFY(boxes.back().diagonal().norm() > 0.01 * size);
  }
  std::vector<std::size_t> open{0}, reached{0};
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (std::find(reached.begin(), reached.end(), i) != reached.end()) continue;
      if (boxes[at].exteriorDistance(boxes[i]) > 0.01 * size) continue;
      reached.push_back(i);
      open.push_back(i);
    }
  }
  QCOMPARE(reached.size(), boxes.size());
}

HANDWHEEL_TEST(CellFilesTest)
#include "CellFilesTest.moc"

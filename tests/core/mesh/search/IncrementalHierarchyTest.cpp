// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "mesh/search/IncrementalHierarchy.h"

#include <QTest>
#include <random>

using namespace handwheel;

class IncrementalHierarchyTest : public QObject {
  Q_OBJECT

 private slots:
  void againstAll();
  void stopsWithTheVisitor();
};

// After each of many additions the hierarchy visits at least the triangles with a corner in the box, and each once.
void IncrementalHierarchyTest::againstAll() {
  std::mt19937 random(7);
  const auto point = [&] { return Vec3(random() % 100, random() % 100, random() % 100); };
  IncrementalHierarchy growing;
  std::vector<TrianglePoints> all;
  for (int i = 0; i < 1000; ++i) {
    all.push_back({point(), point(), point()});
    growing.add(all.back());
    if (i % 37 != 0) continue;
    const Box box = Box(point()).extend(point());
    std::size_t visited = 0, withCorner = 0, corners = 0, boxes = 0;
    growing.forEachInBox(box, [&](const TrianglePoints& t) {
      ++visited;
      corners += box.contains(t[0]) || box.contains(t[1]) || box.contains(t[2]);
      return true;
    });
    for (const TrianglePoints& t : all) {
      withCorner += box.contains(t[0]) || box.contains(t[1]) || box.contains(t[2]);
      boxes += boxOf(t).intersects(box);
    }
    QCOMPARE(corners, withCorner);
    QVERIFY(visited >= boxes && visited <= all.size());
  }
}

void IncrementalHierarchyTest::stopsWithTheVisitor() {
  IncrementalHierarchy growing;
  for (int i = 0; i < 200; ++i) growing.add({Vec3(i, 0, 0), Vec3(i, 1, 0), Vec3(i, 0, 1)});
  const Box everything(Vec3(-1, -1, -1), Vec3(300, 2, 2));
  int visits = 0;
  QVERIFY(!growing.forEachInBox(everything, [&](const TrianglePoints&) { return ++visits < 5; }));
  QCOMPARE(visits, 5);
  visits = 0;
  QVERIFY(growing.forEachInBox(everything, [&](const TrianglePoints&) { return ++visits > 0; }));
  QCOMPARE(visits, 200);
}

HANDWHEEL_TEST(IncrementalHierarchyTest)
#include "IncrementalHierarchyTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proximity/BoxTree.h"

#include <rapidcheck.h>
#include <tbb/task_arena.h>

#include <QTest>
#include <cmath>
#include <random>

#include "TestClass.h"  // after TBB

using namespace handwheel;

namespace {

BoxedItem item(std::uint32_t id, const Eigen::Vector3f& low, const Eigen::Vector3f& high) {
  BoxedItem made{{Eigen::Array4f::Zero(), Eigen::Array4f::Zero()}};
  made.box.low.head<3>() = low;
  made.box.high.head<3>() = high;
  made.setId(id);
  return made;
}

std::vector<BoxedItem> randomItems(std::uint32_t count, float size, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto point = [&](float reach) {
    std::uniform_real_distribution<float> uniform(0, reach);
    return Eigen::Vector3f(uniform(random), uniform(random), uniform(random));
  };
  std::vector<BoxedItem> items;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Eigen::Vector3f low = point(1);
    items.push_back(item(i, low, low + point(size)));
  }
  return items;
}

bool contains(const FloatBox& outer, const FloatBox& inner) {
  return (outer.low.head<3>() <= inner.low.head<3>()).all() && (inner.high.head<3>() <= outer.high.head<3>()).all();
}

// Walks the subtree; returns its depth, 0 when anything is wrong. `next` is the item that its first leaf must begin
// with.
int soundDepth(const BoxTree& tree, std::span<const BoxedItem> items, std::uint32_t node, std::uint32_t& next) {
  const BoxNode& n = tree.node(node);
  if (n.first() != next) return 0;
  if (n.isLeaf()) {
    const std::uint32_t end = tree.leafEnd(node);
    if (end <= next || end - next > BoxTree::kLeafSize) return 0;
    for (; next < end; ++next)
      if (!contains(n.box, items[next].box)) return 0;
    return 1;
  }
  const std::uint32_t left = node + 1;
  const std::uint32_t right = left + tree.node(left).size();
  if (right + tree.node(right).size() != node + n.size()) return 0;
  if (!contains(n.box, tree.node(left).box) || !contains(n.box, tree.node(right).box)) return 0;
  const int leftDepth = soundDepth(tree, items, left, next);
  const int rightDepth = soundDepth(tree, items, right, next);
  return leftDepth && rightDepth ? 1 + std::max(leftDepth, rightDepth) : 0;
}

// Each item in one leaf, each box around what is below it, not too deep.
bool isSound(const BoxTree& tree, std::span<const BoxedItem> items) {
  std::vector<bool> seen(items.size(), false);
  for (const BoxedItem& i : items) {
    if (i.id() >= items.size() || seen[i.id()]) return false;
    seen[i.id()] = true;
  }
  if (items.empty()) return tree.empty() && tree.nodeCount() == 0;
  std::uint32_t next = 0;
  const int depth = soundDepth(tree, items, 0, next);
  return tree.node(0).size() == tree.nodeCount() && next == items.size() && depth > 0 && depth <= BoxTree::kMaxDepth;
}

}  // namespace

class BoxTreeTest : public QObject {
  Q_OBJECT

 private slots:
  void randomBoxes();
  void equalBoxes();
  void geometricSeries_data();
  void geometricSeries();
  void sameForAnyNumberOfThreads();
  void cancelled();
};

void BoxTreeTest::randomBoxes() {
  QVERIFY(rc::check([] {
    auto items = randomItems(*rc::gen::inRange(0u, 3000u), *rc::gen::element(0.0f, 0.01f, 1.0f),
                             *rc::gen::arbitrary<std::uint32_t>());
    BoxTree tree;
    RC_ASSERT(tree.build(items));
    RC_ASSERT(isSound(tree, items));
  }));
}

void BoxTreeTest::equalBoxes() {
  std::vector<BoxedItem> items;
  for (std::uint32_t i = 0; i < 50000; ++i) items.push_back(item(i, {1, 2, 3}, {4, 5, 6}));
  BoxTree tree;
  QVERIFY(tree.build(items));
  QVERIFY(isSound(tree, items));
}

void BoxTreeTest::geometricSeries_data() {
  QTest::addColumn<float>("ratio");
  for (const float ratio : {0.1f, 0.5f, 0.7f, 0.8f, 0.9f, 0.95f, 0.98f}) QTest::addRow("%g", double(ratio)) << ratio;
}

// Boxes within boxes: cuts by area take a few off the large end each time.
void BoxTreeTest::geometricSeries() {
  QFETCH(float, ratio);
  std::vector<BoxedItem> items;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const float reach = std::pow(ratio, static_cast<float>(i));
    items.push_back(item(i, {0, 0, 0}, {reach, reach, reach}));
  }
  BoxTree tree;
  QVERIFY(tree.build(items));
  QVERIFY(isSound(tree, items));
}

void BoxTreeTest::sameForAnyNumberOfThreads() {
  auto items = randomItems(100000, 0.01f, 4);
  auto itemsAlone = items;
  BoxTree tree, treeAlone;
  QVERIFY(tree.build(items));
  QVERIFY(isSound(tree, items));
  tbb::task_arena(1).execute([&] { treeAlone.build(itemsAlone); });
  QCOMPARE(tree.nodeCount(), treeAlone.nodeCount());
  for (std::uint32_t i = 0; i < tree.nodeCount(); ++i) {
    QCOMPARE(tree.node(i).size(), treeAlone.node(i).size());
    QCOMPARE(tree.node(i).first(), treeAlone.node(i).first());
  }
  for (std::size_t i = 0; i < items.size(); ++i) QCOMPARE(items[i].id(), itemsAlone[i].id());
}

void BoxTreeTest::cancelled() {
  JobState job;
  job.cancelled = true;
  auto items = randomItems(20000, 0.01f, 4);
  BoxTree tree;
  QVERIFY(!tree.build(items, Progress(job)));
  QVERIFY(tree.empty());
  QCOMPARE(tree.nodeCount(), 0u);
}

HANDWHEEL_TEST(BoxTreeTest)
#include "BoxTreeTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proximity/SelfIntersection.h"

#include "proximity/BoxTree.h"
#include "proximity/TriangleBoxes.h"
#include "proximity/TriangleIntersection.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>

namespace handwheel {
namespace {

constexpr std::uint32_t kBlockNodes = 256;  // nodes of the tree that one worker takes at a time

TrianglePoints cornersOf(std::span<const Vec3> points, const Triangle& t) {
  return {points[t[0]], points[t[1]], points[t[2]]};
}

class Search {
 public:
  Search(std::span<const Vec3> points, std::span<const Triangle> triangles, Progress progress, std::size_t maxPairs)
      : m_points(points), m_triangles(triangles), m_progress(progress), m_maxPairs(maxPairs) {}

  // False when cancelled.
  bool prepare() {
    m_items = boxedTriangles(m_points, m_triangles, BoxFrame(m_points), FlatTriangles::LeaveOut, m_progress);
    return m_tree.build(m_items, m_progress);
  }

  // Workers take blocks in their order and finish those that they took. So the finished blocks are always the first
  // ones, and what is cut off at maxPairs does not depend on the threads. False when cancelled.
  bool run() {
    m_found.resize((m_tree.nodeCount() + kBlockNodes - 1) / kBlockNodes);
    tbb::parallel_for(0, tbb::this_task_arena::max_concurrency(), [&](int) {
      while (m_total < m_maxPairs && !m_progress.cancelled()) {
        const std::size_t block = m_nextBlock++;
        if (block >= m_found.size()) return;
        searchBlock(block);
        m_total += m_found[block].size();
        m_progress.set(static_cast<double>(++m_blocksDone) / static_cast<double>(m_found.size()));
      }
    });
    return !m_progress.cancelled();
  }

  // The pairs found, sorted by counting: bounded time between two looks at the cancel flag, however many there are.
  std::optional<std::vector<TrianglePair>> sorted();

 private:
  void searchBlock(std::size_t block) {
    std::vector<TrianglePair>& out = m_found[block];
    const auto begin = static_cast<std::uint32_t>(block * kBlockNodes);
    const std::uint32_t end = std::min(begin + kBlockNodes, m_tree.nodeCount());
    for (std::uint32_t node = begin; node < end; ++node)
      if (m_tree.node(node).isLeaf() && !searchFrom(node, out)) return;
  }

  // Pairs within the leaf, and with everything behind it in preorder: so each pair is looked at once.
  bool searchFrom(std::uint32_t leaf, std::vector<TrianglePair>& out) {
    if (m_progress.cancelled()) return false;
    const std::uint32_t begin = m_tree.node(leaf).first();
    const std::uint32_t end = m_tree.leafEnd(leaf);
    for (std::uint32_t i = begin; i < end; ++i)
      if (!testAgainst(i, i + 1, end, out)) return false;
    for (std::uint32_t node = leaf + 1; node < m_tree.nodeCount();) {
      const BoxNode& other = m_tree.node(node);
      if (!other.box.meets(m_tree.node(leaf).box)) {
        node += other.size();
        continue;
      }
      if (other.isLeaf())
        for (std::uint32_t i = begin; i < end; ++i)
          if (m_items[i].box.meets(other.box) && !testAgainst(i, other.first(), m_tree.leafEnd(node), out))
            return false;
      ++node;
    }
    return true;
  }

  // Returns false to stop: cancelled, or enough found.
  bool testAgainst(std::uint32_t i, std::uint32_t begin, std::uint32_t end, std::vector<TrianglePair>& out) {
    const BoxedItem& item = m_items[i];
    for (std::uint32_t j = begin; j < end; ++j) {
      const BoxedItem& other = m_items[j];
      if (!item.box.meets(other.box)) continue;
      if (m_progress.cancelled()) return false;
      if (!trianglesMeet(cornersOf(m_points, m_triangles[item.id()]), cornersOf(m_points, m_triangles[other.id()])))
        continue;
      out.push_back(std::minmax({item.id(), other.id()}));
      if (out.size() >= m_maxPairs) return false;
    }
    return true;
  }

  std::span<const Vec3> m_points;
  std::span<const Triangle> m_triangles;
  Progress m_progress;
  std::size_t m_maxPairs;

  std::vector<BoxedItem> m_items;  // in the order of the leaves
  BoxTree m_tree;
  std::vector<std::vector<TrianglePair>> m_found;  // by block
  std::atomic<std::size_t> m_nextBlock{0};
  std::atomic<std::size_t> m_blocksDone{0};
  std::atomic<std::size_t> m_total{0};
};

std::optional<std::vector<TrianglePair>> Search::sorted() {
  std::vector<std::size_t> begin(m_triangles.size() + 1, 0);  // of the pairs with this first triangle
  std::size_t left = std::min(m_total.load(), m_maxPairs);
  for (auto& block : m_found) {
    if (m_progress.cancelled()) return std::nullopt;
    block.resize(std::min(block.size(), left));
    left -= block.size();
    for (const auto& pair : block) ++begin[pair.first + 1];
  }
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];

  std::vector<TrianglePair> pairs(begin.back());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (auto& block : m_found) {
    if (m_progress.cancelled()) return std::nullopt;
    for (const auto& pair : block) pairs[next[pair.first]++] = pair;
    block = {};
  }
  for (std::size_t i = 0; i + 1 < begin.size(); ++i) {
    if (i % 256 == 0 && m_progress.cancelled()) return std::nullopt;
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(begin[i]),
              pairs.begin() + static_cast<std::ptrdiff_t>(begin[i + 1]));
  }
  m_progress.set(1.0);
  return pairs;
}

}  // namespace

std::optional<std::vector<TrianglePair>> selfIntersections(std::span<const Vec3> points,
                                                           std::span<const Triangle> triangles, Progress progress,
                                                           std::size_t maxPairs) {
  Search search(points, triangles, progress, maxPairs);
  if (!search.prepare() || !search.run()) return std::nullopt;
  return search.sorted();
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proximity/SelfIntersection.h"

#include "proximity/BoxTree.h"
#include "proximity/HighValenceFans.h"
#include "proximity/SliverPieces.h"
#include "proximity/TriangleBoxes.h"
#include "proximity/TriangleIntersection.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>

namespace handwheel {
namespace {

// Numbers of operations that take as long as one step of Effort.
constexpr std::size_t kNodesPerStep = 256;
constexpr std::size_t kTestsPerStep = 8;    // tests of two triangles
constexpr std::size_t kFewItems = 2048;     // fewer items are cheaper without pieces
constexpr double kPrepared = 0.3;           // the share of the time until the search begins
constexpr std::uint32_t kBlockNodes = 256;  // nodes of the tree that one worker takes at a time

TrianglePoints cornersOf(std::span<const Vec3> points, const Triangle& t) {
  return {points[t[0]], points[t[1]], points[t[2]]};
}

class Search {
 public:
  Search(std::span<const Vec3> points, std::span<const Triangle> triangles, Progress progress, std::size_t maxPairs)
      : m_points(points), m_triangles(triangles), m_progress(progress), m_maxPairs(maxPairs) {}

  // Returns false if cancelled.
  bool prepare() {
    const BoxFrame frame(m_points);
    m_items = boxedTriangles(m_points, m_triangles, frame, FlatTriangles::LeaveOut, m_progress);
    m_progress.set(0.05);
    m_fans = HighValenceFans(m_points, m_triangles, m_items);
    const std::size_t whole = m_items.size();
    if (whole > kFewItems) splitSliverBoxes(m_items, m_points, m_triangles, frame);
    if (m_items.size() > whole) rememberPieces();
    m_progress.set(kPrepared / 2);
    if (!m_tree.build(m_items, m_progress, m_progress.part(kPrepared / 2, kPrepared))) return false;
    if (!m_fans.empty()) tellFansOfNodes();
    return true;
  }

  // Workers take blocks in their order and finish those that they took. So the finished blocks are always the first
  // ones, and the limit maxPairs cuts off the same pairs for any number of threads. Returns false if cancelled.
  bool run() {
    const std::size_t blocks = (m_tree.nodeCount() + kBlockNodes - 1) / kBlockNodes;
    m_found.resize(blocks + 1);  // the last: of fans
    tbb::parallel_for(0, tbb::this_task_arena::max_concurrency(), [&](int) {
      while (m_total < m_maxPairs && !m_progress.cancelled()) {
        const std::size_t block = m_nextBlock++;
        if (block >= blocks) return;
        searchBlock(block);
        m_total += m_found[block].size();
        m_progress.part(kPrepared, 1.0).set(static_cast<double>(++m_blocksDone) / static_cast<double>(blocks));
      }
    });
    if (m_total < m_maxPairs && !m_progress.cancelled()) searchFans(m_found.back());
    m_total += m_found.back().size();
    return !m_progress.cancelled();
  }

  // The pairs found, sorted by counting: the time between two polls of the cancel flag is bounded.
  std::optional<std::vector<TrianglePair>> sorted();

 private:
  void searchBlock(std::size_t block) {
    std::vector<TrianglePair>& out = m_found[block];
    const auto begin = static_cast<std::uint32_t>(block * kBlockNodes);
    const std::uint32_t end = std::min(begin + kBlockNodes, m_tree.nodeCount());
    for (std::uint32_t node = begin; node < end; ++node)
      if (m_tree.node(node).isLeaf() && !searchFrom(node, out)) return;
  }

  // Pairs within the leaf, and with everything behind it in preorder: so each pair is tested once.
  bool searchFrom(std::uint32_t leaf, std::vector<TrianglePair>& out) {
    if (m_progress.cancelled()) return false;
    std::size_t tests = 0, nodes = 0;
    const std::uint32_t begin = m_tree.node(leaf).first();
    const std::uint32_t end = m_tree.leafEnd(leaf);
    for (std::uint32_t i = begin; i < end; ++i)
      if (!testAgainst(i, i + 1, end, out, tests)) return false;
    for (std::uint32_t node = leaf + 1; node < m_tree.nodeCount(); ++nodes) {
      const BoxNode& other = m_tree.node(node);
      const bool sameFan = !m_fanOfNode.empty() && m_fanOfNode[leaf] != kNone && m_fanOfNode[leaf] == m_fanOfNode[node];
      if (sameFan || !other.box.meets(m_tree.node(leaf).box)) {
        node += other.size();
        continue;
      }
      if (other.isLeaf())
        for (std::uint32_t i = begin; i < end; ++i)
          if (m_items[i].box.meets(other.box) && !testAgainst(i, other.first(), m_tree.leafEnd(node), out, tests))
            return false;
      ++node;
    }
    m_progress.spend(tests / kTestsPerStep + nodes / kNodesPerStep);
    return true;
  }

  // Counts the tests. Returns false to stop: cancelled, or enough found.
  bool testAgainst(std::uint32_t i, std::uint32_t begin, std::uint32_t end, std::vector<TrianglePair>& out,
                   std::size_t& tests) {
    const BoxedItem& item = m_items[i];
    for (std::uint32_t j = begin; j < end; ++j) {
      const BoxedItem& other = m_items[j];
      if (!item.box.meets(other.box)) continue;
      if (m_progress.cancelled()) return false;
      if (isForFans(item.id(), other.id()) || !isFirstOf(item, other)) continue;
      ++tests;
      if (!trianglesMeet(cornersOf(m_points, m_triangles[item.id()]), cornersOf(m_points, m_triangles[other.id()])))
        continue;
      out.push_back(std::minmax({item.id(), other.id()}));
      if (out.size() >= m_maxPairs) return false;
    }
    return true;
  }

  bool isForFans(std::uint32_t i, std::uint32_t j) const {
    return m_fans.of(i) != kNone && m_fans.of(i) == m_fans.of(j);
  }

  void searchFans(std::vector<TrianglePair>& out) {
    const auto visit = [&](std::uint32_t i, std::uint32_t j) {
      m_progress.spend(1);
      if (m_progress.cancelled()) return false;
      if (trianglesMeet(cornersOf(m_points, m_triangles[i]), cornersOf(m_points, m_triangles[j])))
        out.push_back(std::minmax({i, j}));
      return out.size() < m_maxPairs;
    };
    m_fans.forEachPair(visit, m_progress);
  }

  // A node's fan is that of all its items.
  void tellFansOfNodes() {
    m_fanOfNode.assign(m_tree.nodeCount(), kNone);
    for (std::uint32_t node = m_tree.nodeCount(); node-- > 0;) {
      if (!m_tree.node(node).isLeaf()) {
        const std::uint32_t left = node + 1, right = left + m_tree.node(left).size();
        if (m_fanOfNode[left] == m_fanOfNode[right]) m_fanOfNode[node] = m_fanOfNode[left];
        continue;
      }
      const std::uint32_t begin = m_tree.node(node).first(), fan = m_fans.of(m_items[begin].id());
      const auto inFan = [&](const BoxedItem& item) { return m_fans.of(item.id()) == fan; };
      const auto first = m_items.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto last = m_items.begin() + static_cast<std::ptrdiff_t>(m_tree.leafEnd(node));
      if (std::all_of(first, last, inFan)) m_fanOfNode[node] = fan;
    }
  }

  // The pieces of each triangle, one after the other, and numbered.
  void rememberPieces() {
    for (std::uint32_t i = 0; i < m_items.size(); ++i) m_items[i].box.high[3] = std::bit_cast<float>(i);
    m_pieces = m_items;
    std::stable_sort(m_pieces.begin(), m_pieces.end(),
                     [](const BoxedItem& a, const BoxedItem& b) { return a.id() < b.id(); });
    m_firstPiece.assign(m_triangles.size() + 1, 0);
    for (const BoxedItem& piece : m_pieces) ++m_firstPiece[piece.id() + 1];
    for (std::size_t i = 1; i < m_firstPiece.size(); ++i) m_firstPiece[i] += m_firstPiece[i - 1];
  }

  std::span<const BoxedItem> piecesOf(std::uint32_t triangle) const {
    return std::span(m_pieces).subspan(m_firstPiece[triangle], m_firstPiece[triangle + 1] - m_firstPiece[triangle]);
  }

  // Returns true for the first meeting of pieces of two triangles, where the pair is tested. False for two pieces of
  // one triangle.
  bool isFirstOf(const BoxedItem& a, const BoxedItem& b) const {
    if (a.id() == b.id()) return false;
    if (m_pieces.empty()) return true;
    const bool isTurned = b.id() < a.id();
    const BoxedItem &low = isTurned ? b : a, &high = isTurned ? a : b;
    const std::span<const BoxedItem> pieces = piecesOf(low.id()), others = piecesOf(high.id());
    // Both triangles have pieces. Because a and b meet, some pair of their pieces does: the last one, if none before
    // it.
    const std::size_t n = others.size(), last = pieces.size() * n - 1;
    std::size_t first = 0;
    while (first < last && !pieces[first / n].box.meets(others[first % n].box)) ++first;
    return isSame(pieces[first / n], low) && isSame(others[first % n], high);
  }

  static bool isSame(const BoxedItem& a, const BoxedItem& b) {
    return std::bit_cast<std::uint32_t>(a.box.high[3]) == std::bit_cast<std::uint32_t>(b.box.high[3]);
  }

  std::span<const Vec3> m_points;
  std::span<const Triangle> m_triangles;
  Progress m_progress;
  std::size_t m_maxPairs;

  HighValenceFans m_fans;
  std::vector<std::uint32_t> m_fanOfNode;  // none where no fan is crowded
  std::vector<BoxedItem> m_pieces;         // by triangle; none where nothing was cut
  std::vector<std::size_t> m_firstPiece;
  std::vector<BoxedItem> m_items;  // in the order of the leaves
  BoxTree m_tree;
  std::vector<std::vector<TrianglePair>> m_found;  // by block
  std::atomic<std::size_t> m_nextBlock{0};
  std::atomic<std::size_t> m_blocksDone{0};
  std::atomic<std::size_t> m_total{0};
};

std::optional<std::vector<TrianglePair>> Search::sorted() {
  std::vector<std::size_t> begin(m_triangles.size() + 1, 0);  // start of the pairs with this first triangle
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

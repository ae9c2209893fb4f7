// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "proximity/SimdFloat4.h"

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace handwheel {

// An axis-aligned box in single precision. Its corners are rows of four numbers, each processed by one instruction; the
// fourth number of a row is free to store an index.
struct FloatBox {
  Eigen::Array4f low;
  Eigen::Array4f high;

  bool meets(const FloatBox& other) const {
    return (atMost(low, other.high) & atMost(other.low, high) & 0b111) == 0b111;
  }
};

// An item with a bounding box, for example a triangle.
struct BoxedItem {
  FloatBox box;

  std::uint32_t id() const { return std::bit_cast<std::uint32_t>(box.low[3]); }
  void setId(std::uint32_t id) { box.low[3] = std::bit_cast<float>(id); }
};

// A node of a box tree. Nodes are stored in preorder: a node's left child follows it, the right child follows the left
// one's subtree.
struct BoxNode {
  FloatBox box;

  // Returns the number of nodes in the subtree, including this one; 1 for a leaf.
  std::uint32_t size() const { return std::bit_cast<std::uint32_t>(box.low[3]); }
  void setSize(std::size_t size) { box.low[3] = std::bit_cast<float>(static_cast<std::uint32_t>(size)); }

  // Returns the index of the first item of the node, in the order of the items after build().
  std::uint32_t first() const { return std::bit_cast<std::uint32_t>(box.high[3]); }
  void setFirst(std::size_t first) { box.high[3] = std::bit_cast<float>(static_cast<std::uint32_t>(first)); }

  bool isLeaf() const { return size() == 1; }
};

// A binary bounding volume hierarchy over boxes.
class BoxTree {
 public:
  // The largest number of items in a leaf, and of nodes from the root to a leaf.
  static constexpr std::uint32_t kLeafSize = 4;
  static constexpr int kMaxDepth = 80;

  // Builds the tree and sorts the items into the order of the leaves. O(n log n), on all threads of the arena; the tree
  // is the same for any number of threads. Returns false and leaves the tree empty if cancelled. whole: the range in
  // which the progress of the whole build is reported.
  bool build(std::span<BoxedItem> items, Progress progress = {}, std::optional<Progress> whole = std::nullopt);

  bool empty() const { return m_nodes.empty(); }
  std::uint32_t nodeCount() const { return m_nodes.empty() ? 0 : static_cast<std::uint32_t>(m_nodes.size() - 1); }
  const BoxNode& node(std::uint32_t i) const { return m_nodes[i]; }
  // Returns the index after the last item of a leaf.
  std::uint32_t leafEnd(std::uint32_t leaf) const { return m_nodes[leaf + 1].first(); }

 private:
  std::vector<BoxNode> m_nodes;  // nodes, followed by an end node, whose first() is the number of items
};

}  // namespace handwheel

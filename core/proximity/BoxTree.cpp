// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proximity/BoxTree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>

namespace handwheel {
namespace {

constexpr std::size_t kMaxBins = 16;
constexpr std::size_t kParallelItems = 16384;  // a smaller range is not worth a task
// Beyond this depth ranges are halved by count, so that the depth stays within kMaxDepth: 2^32 items need 32 more.
constexpr int kSurfaceAreaDepth = 44;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const FloatBox kNothing{Eigen::Array4f::Constant(kInfinity), Eigen::Array4f::Constant(-kInfinity)};

inline void extend(FloatBox& box, const FloatBox& other) {
  box.low = box.low.min(other.low);
  box.high = box.high.max(other.high);
}

float halfArea(const FloatBox& box) {
  const float x = box.high[0] - box.low[0];
  const float y = box.high[1] - box.low[1];
  const float z = box.high[2] - box.low[2];
  return x * y + y * z + z * x;
}

// Twice the centre: only its order along an axis matters.
float centre(const FloatBox& box, Eigen::Index axis) {
  return box.low[axis] + box.high[axis];
}

inline void extendByCentre(FloatBox& centres, const FloatBox& box) {
  const Eigen::Array4f twice = box.low + box.high;
  extend(centres, {twice, twice});
}

struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;
  FloatBox centres = kNothing;

  std::size_t count() const { return end - begin; }
  Eigen::Index longestAxis() const {
    Eigen::Index axis = 0;
    (centres.high - centres.low).head<3>().maxCoeff(&axis);
    return axis;
  }
};

// Equal slices of a range along its longest axis.
class Slices {
 public:
  explicit Slices(const Range& range)
      : m_axis(range.longestAxis()), m_count(std::clamp<std::size_t>(range.count() / 2, 4, kMaxBins)) {
    m_low = range.centres.low[m_axis];
    const float extent = range.centres.high[m_axis] - m_low;
    m_scale = extent > 0.0f ? static_cast<float>(m_count) / extent : 0.0f;
    if (!(m_scale < kInfinity)) m_scale = 0.0f;
  }

  Eigen::Index axis() const { return m_axis; }
  bool useful() const { return m_scale > 0.0f; }
  std::size_t of(const FloatBox& box) const {
    const float slice = (centre(box, m_axis) - m_low) * m_scale;
    return std::min(static_cast<std::size_t>(static_cast<int>(slice)), m_count - 1);
  }

  // The first slice of the right half, where the surface area heuristic (Goldsmith and Salmon 1987; Wald 2007 for the
  // slices) expects the cheapest queries. Both halves hold something.
  std::size_t bestCut(std::span<const BoxedItem> items) const {
    std::array<FloatBox, kMaxBins> boxes;
    std::array<std::size_t, kMaxBins> counts{};
    boxes.fill(kNothing);
    for (const BoxedItem& item : items) {
      const std::size_t slice = of(item.box);
      extend(boxes[slice], item.box);
      ++counts[slice];
    }
    std::array<float, kMaxBins> rightCost{};
    FloatBox right = kNothing;
    std::size_t rightCount = 0;
    for (std::size_t i = m_count; i-- > 1;) {
      extend(right, boxes[i]);
      rightCount += counts[i];
      rightCost[i] = rightCount ? halfArea(right) * static_cast<float>(rightCount) : kInfinity;
    }
    FloatBox left = kNothing;
    std::size_t leftCount = 0;
    std::size_t best = m_count / 2;
    float bestCost = kInfinity;
    for (std::size_t i = 1; i < m_count; ++i) {
      extend(left, boxes[i - 1]);
      leftCount += counts[i - 1];
      const float cost = leftCount ? halfArea(left) * static_cast<float>(leftCount) + rightCost[i] : kInfinity;
      if (cost < bestCost) {
        bestCost = cost;
        best = i;
      }
    }
    return best;
  }

 private:
  Eigen::Index m_axis;
  std::size_t m_count;
  float m_low;
  float m_scale;
};

class Builder {
 public:
  Builder(std::span<BoxedItem> items, Progress progress, std::optional<Progress> whole)
      : m_items(items), m_progress(progress), m_whole(whole) {}

  // Appends the subtree of the range. Ranges are cut independently of each other, so the tree does not depend on the
  // threads.
  void append(std::vector<BoxNode>& out, const Range& range, int depth) {
    const std::size_t self = out.size();
    out.push_back({kNothing});
    if (range.count() <= BoxTree::kLeafSize) {
      for (std::size_t i = range.begin; i < range.end; ++i) extend(out[self].box, m_items[i].box);
      finish(out, self, range);
      return;
    }
    if (range.count() >= kParallelItems && m_progress.cancelled()) return;
    Range left, right;
    cut(range, depth, left, right);
    std::size_t second = 0;
    if (range.count() < kParallelItems) {
      append(out, left, depth + 1);
      second = out.size();
      append(out, right, depth + 1);
    } else {
      std::vector<BoxNode> rightNodes;
      tbb::parallel_invoke([&] { appendAndTell(out, left, depth + 1); },
                           [&] { appendAndTell(rightNodes, right, depth + 1); });
      second = out.size();
      out.insert(out.end(), rightNodes.begin(), rightNodes.end());
    }
    extend(out[self].box, out[self + 1].box);
    extend(out[self].box, out[second].box);
    finish(out, self, range);
  }

 private:
  void appendAndTell(std::vector<BoxNode>& out, const Range& range, int depth) {
    append(out, range, depth);
    if (range.count() >= kParallelItems) return;  // its parts have reported
    m_done += range.count();
    if (m_whole) m_whole->set(static_cast<double>(m_done) / static_cast<double>(m_items.size()));
  }

  // The numbers are set after the box, whose computation overwrites them.
  static void finish(std::vector<BoxNode>& out, std::size_t self, const Range& range) {
    out[self].setSize(out.size() - self);
    out[self].setFirst(range.begin);
  }

  void cut(const Range& range, int depth, Range& left, Range& right) const {
    const Slices slices(range);
    const auto begin = m_items.begin() + static_cast<std::ptrdiff_t>(range.begin);
    const auto end = m_items.begin() + static_cast<std::ptrdiff_t>(range.end);
    auto middle = begin + static_cast<std::ptrdiff_t>(range.count() / 2);
    if (slices.useful() && depth < kSurfaceAreaDepth) {
      const std::size_t best = slices.bestCut({begin, end});
      middle = std::partition(begin, end, [&](const BoxedItem& item) {
        const bool isLeft = slices.of(item.box) < best;
        extendByCentre(isLeft ? left.centres : right.centres, item.box);
        return isLeft;
      });
    } else {
      std::nth_element(begin, middle, end, [&](const BoxedItem& a, const BoxedItem& b) {
        return centre(a.box, slices.axis()) < centre(b.box, slices.axis());
      });
      for (auto i = begin; i != end; ++i) extendByCentre(i < middle ? left.centres : right.centres, i->box);
    }
    left.begin = range.begin;
    left.end = right.begin = static_cast<std::size_t>(middle - m_items.begin());
    right.end = range.end;
  }

  std::span<BoxedItem> m_items;
  Progress m_progress;
  std::optional<Progress> m_whole;
  std::atomic<std::size_t> m_done{0};  // items in the leaves
};

}  // namespace

bool BoxTree::build(std::span<BoxedItem> items, Progress progress, std::optional<Progress> whole) {
  m_nodes.clear();
  if (items.empty()) return true;
  Range all{0, items.size(), kNothing};
  for (const BoxedItem& item : items) extendByCentre(all.centres, item.box);
  m_nodes.reserve(items.size());
  Builder builder(items, progress, whole);
  builder.append(m_nodes, all, 1);
  if (progress.cancelled()) {
    m_nodes.clear();
    return false;
  }
  m_nodes.emplace_back().setFirst(items.size());
  return true;
}

}  // namespace handwheel

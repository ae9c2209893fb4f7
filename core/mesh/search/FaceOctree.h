// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <cmath>
#include <iterator>
#include <map>
#include <unordered_map>
#include <vector>

namespace handwheel {

// A loose octree of face boxes, with insertion and removal. There is a level for each power of two in size: a box is
// stored in the level whose cells are just larger than the box, in the cell of its lowest corner, so it extends at most
// into the next cell (Ulrich, "Loose octrees", 2000). Cells without faces in or below them are not stored.
class FaceOctree {
 public:
  // Adds or removes a face. Boxes must be finite. A face must be removed with the box with which it was added.
  void add(Face f, const Box& box);
  void remove(Face f, const Box& box);

  // Calls visit(face) once for each face near the box, at least for those whose boxes meet it, until it returns false.
  // Returns false if a visit returned false.
  template <class Visit>
  bool forEachNear(const Box& box, Visit visit) const {
    if (m_levels.empty()) return true;
    const auto top = std::prev(m_levels.end());
    const Range range = rangeOf(box, top->first);
    Walk<Visit> walk{box, visit, {range}};
    if (range.count() > static_cast<double>(top->second.size())) {
      for (const auto& [cell, node] : top->second) {
        if (range.contains(cell) && !walk.down(top, 0, cell, node)) return false;
      }
      return true;
    }
    return range.forEach([&](const Cell& cell) {
      const auto found = top->second.find(cell);
      return found == top->second.end() || walk.down(top, 0, cell, found->second);
    });
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& c) const {
      std::uint64_t h = 0;
      for (const std::int64_t k : c) h = (h ^ static_cast<std::uint64_t>(k)) * 0x9e3779b97f4a7c15u, h ^= h >> 29;
      return h;
    }
  };
  struct Node {
    std::vector<Face> faces;             // faces stored in the cell
    std::array<const Node*, 8> parts{};  // parts in the cells below, by their numbers; null: none
    bool hasParts() const { return parts != decltype(parts){}; }
  };
  using Cells = std::unordered_map<Cell, Node, Hash>;
  using Levels = std::map<int, Cells>;

  struct Range {
    Cell low, high;
    double count() const;
    bool contains(const Cell& cell) const {
      for (std::size_t k = 0; k < 3; ++k)
        if (cell[k] < low[k] || cell[k] > high[k]) return false;
      return true;
    }
    template <class Visit>
    bool forEach(Visit visit) const {
      for (std::int64_t x = low[0]; x <= high[0]; ++x)
        for (std::int64_t y = low[1]; y <= high[1]; ++y)
          for (std::int64_t z = low[2]; z <= high[2]; ++z)
            if (!visit(Cell{x, y, z})) return false;
      return true;
    }
  };

  // A search from the largest cells down.
  template <class Visit>
  struct Walk {
    const Box& box;
    Visit& visit;
    std::vector<Range> ranges;  // ranges of the levels from the top, as far as the search has descended

    bool down(Levels::const_iterator level, std::size_t depth, const Cell& cell, const Node& node) {
      for (const Face f : node.faces)
        if (!visit(f)) return false;
      if (!node.hasParts()) return true;
      const auto below = std::prev(level);
      if (ranges.size() == depth + 1) ranges.push_back(rangeOf(box, below->first));
      const Range range = ranges[depth + 1];
      for (unsigned number = 0; number < 8; ++number) {
        if (!node.parts[number]) continue;
        const Cell part = partOf(cell, number);
        if (range.contains(part) && !down(below, depth + 1, part, *node.parts[number])) return false;
      }
      return true;
    }
  };

  static int levelOf(const Box& box);
  static Cell cellOf(const Vec3& p, int level);
  // Returns the cells of a level that can contain the lowest corner of a face near the box.
  static Range rangeOf(const Box& box, int level);
  static Cell wholeOf(const Cell& part);
  static Cell partOf(const Cell& whole, unsigned number) {
    return {2 * whole[0] + (number & 1), 2 * whole[1] + (number >> 1 & 1), 2 * whole[2] + (number >> 2 & 1)};
  }
  // Returns the number of a part in the cell above.
  static std::size_t numberOf(const Cell& part);

  void raiseTo(int level);
  void tellAbove(int level, Cell cell, const Node* node);

  // The levels by the exponent of their cell size. The ancestors of each cell exist in all levels up to the largest.
  // Nodes stay in place while others are added and removed.
  Levels m_levels;
};

}  // namespace handwheel

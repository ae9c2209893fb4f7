// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <cmath>
#include <map>
#include <unordered_map>
#include <vector>

namespace handwheel {

// A hierarchical spatial hash of face boxes, with insertion and removal. There is a grid for each power of two in size
// (Eitz and Gu, "Hierarchical spatial hashing for real-time collision detection", 2007): a box lies in at most eight
// cells of the one whose cells are as large as it is.
class FaceGrid {
 public:
  // Boxes are finite; one that is removed is the one that was added.
  void add(Face f, const Box& box);
  void remove(Face f, const Box& box);

  // Calls visit(face) for each face whose cells the box meets, perhaps more than once, until it returns false. Returns
  // false when a visit did.
  template <class Visit>
  bool forEachNear(const Box& box, Visit visit) const {
    for (const auto& [level, cells] : m_levels) {
      const Range range = rangeOf(box, level);
      if (range.count() > static_cast<double>(cells.size())) {
        for (const auto& [cell, faces] : cells) {
          if (range.contains(cell) && !visitAll(faces, visit)) return false;
        }
        continue;
      }
      const bool goesOn = range.forEach([&, &cells = cells](const Cell& cell) {
        const auto found = cells.find(cell);
        return found == cells.end() || visitAll(found->second, visit);
      });
      if (!goesOn) return false;
    }
    return true;
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
  using Cells = std::unordered_map<Cell, std::vector<Face>, Hash>;

  struct Range {
    Cell low, high;
    double count() const;
    bool contains(const Cell& cell) const;
    template <class Visit>
    bool forEach(Visit visit) const {
      for (std::int64_t x = low[0]; x <= high[0]; ++x)
        for (std::int64_t y = low[1]; y <= high[1]; ++y)
          for (std::int64_t z = low[2]; z <= high[2]; ++z)
            if (!visit(Cell{x, y, z})) return false;
      return true;
    }
  };

  template <class Visit>
  static bool visitAll(const std::vector<Face>& faces, Visit visit) {
    for (const Face f : faces)
      if (!visit(f)) return false;
    return true;
  }
  static int levelOf(const Box& box);
  static Range rangeOf(const Box& box, int level);

  std::map<int, Cells> m_levels;  // by the exponent of the size of their cells; none without faces
};

}  // namespace handwheel

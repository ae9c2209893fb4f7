// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/FaceOctree.h"

#include <algorithm>

namespace handwheel {
namespace {

// Least size of a cell as a share of its coordinates, so that cell numbers fit.
constexpr int kSmallestShare = -40;

}  // namespace

double FaceOctree::Range::count() const {
  double n = 1.0;
  for (std::size_t k = 0; k < 3; ++k) n *= static_cast<double>(high[k]) - static_cast<double>(low[k]) + 1.0;
  return n;
}

int FaceOctree::levelOf(const Box& box) {
  const double size = box.sizes().maxCoeff();
  const double reach = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  const double least = std::max(std::ldexp(reach, kSmallestShare), 1e-300);
  return std::ilogb(std::max(size, least)) + 1;
}

FaceOctree::Cell FaceOctree::cellOf(const Vec3& p, int level) {
  // A query box may extend beyond all cells of a fine level.
  constexpr double kMost = 0x1p62;
  Cell cell{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double number = std::floor(std::ldexp(p[static_cast<Eigen::Index>(k)], -level));
    cell[k] = static_cast<std::int64_t>(std::clamp(number, -kMost, kMost));
  }
  return cell;
}

FaceOctree::Range FaceOctree::rangeOf(const Box& box, int level) {
  Range range{cellOf(box.min(), level), cellOf(box.max(), level)};
  for (std::int64_t& k : range.low) --k;  // a face may begin in the cell before
  return range;
}

FaceOctree::Cell FaceOctree::wholeOf(const Cell& part) {
  return {part[0] >> 1, part[1] >> 1, part[2] >> 1};
}

std::size_t FaceOctree::numberOf(const Cell& part) {
  return static_cast<std::size_t>((part[0] & 1) | (part[1] & 1) << 1 | (part[2] & 1) << 2);
}

// Makes a level the largest if none is as large.
void FaceOctree::raiseTo(int level) {
  if (m_levels.empty()) m_levels[level];
  for (int top = m_levels.rbegin()->first; top < level; ++top) {
    Cells& above = m_levels[top + 1];
    for (const auto& [cell, node] : m_levels[top]) above[wholeOf(cell)].parts[numberOf(cell)] = &node;
  }
}

// Marks a new cell in its ancestors.
void FaceOctree::tellAbove(int level, Cell cell, const Node* node) {
  bool isNew = true;
  for (const int top = m_levels.rbegin()->first; isNew && level < top; ++level) {
    const std::size_t number = numberOf(cell);
    cell = wholeOf(cell);
    const auto [above, wasMissing] = m_levels[level + 1].try_emplace(cell);
    above->second.parts[number] = node;
    node = &above->second;
    isNew = wasMissing;
  }
}

void FaceOctree::add(Face f, const Box& box) {
  const int level = levelOf(box);
  raiseTo(level);
  const Cell cell = cellOf(box.min(), level);
  const auto [entry, isNew] = m_levels[level].try_emplace(cell);
  entry->second.faces.push_back(f);
  if (isNew) tellAbove(level, cell, &entry->second);
}

void FaceOctree::remove(Face f, const Box& box) {
  const int level = levelOf(box);
  auto cells = m_levels.find(level);
  if (cells == m_levels.end()) return;
  Cell cell = cellOf(box.min(), level);
  auto found = cells->second.find(cell);
  if (found == cells->second.end()) return;
  std::vector<Face>& faces = found->second.faces;
  const auto entry = std::find(faces.begin(), faces.end(), f);
  if (entry == faces.end()) return;
  *entry = faces.back();
  faces.pop_back();
  while (found->second.faces.empty() && !found->second.hasParts()) {
    cells->second.erase(found);
    if (++cells == m_levels.end()) return;
    const std::size_t number = numberOf(cell);
    cell = wholeOf(cell);
    found = cells->second.find(cell);
    found->second.parts[number] = nullptr;
  }
}

}  // namespace handwheel

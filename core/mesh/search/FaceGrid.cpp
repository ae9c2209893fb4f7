// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/FaceGrid.h"

#include <algorithm>

namespace handwheel {
namespace {

// So that cell numbers fit: a cell is not smaller than this share of its coordinates.
constexpr int kSmallestShare = -40;

}  // namespace

double FaceGrid::Range::count() const {
  double n = 1.0;
  for (std::size_t k = 0; k < 3; ++k) n *= static_cast<double>(high[k]) - static_cast<double>(low[k]) + 1.0;
  return n;
}

bool FaceGrid::Range::contains(const Cell& cell) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (cell[k] < low[k] || cell[k] > high[k]) return false;
  return true;
}

int FaceGrid::levelOf(const Box& box) {
  const double size = box.sizes().maxCoeff();
  const double reach = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  const double least = std::max(std::ldexp(reach, kSmallestShare), 1e-300);
  return std::ilogb(std::max(size, least)) + 1;
}

FaceGrid::Range FaceGrid::rangeOf(const Box& box, int level) {
  Range range{};
  for (Eigen::Index k = 0; k < 3; ++k) {
    // A box that is asked for may reach beyond all cells of a fine level.
    constexpr double kMost = 0x1p62;
    const auto cell = [&](double x) {
      return static_cast<std::int64_t>(std::clamp(std::floor(std::ldexp(x, -level)), -kMost, kMost));
    };
    range.low[static_cast<std::size_t>(k)] = cell(box.min()[k]);
    range.high[static_cast<std::size_t>(k)] = cell(box.max()[k]);
  }
  return range;
}

void FaceGrid::add(Face f, const Box& box) {
  const int level = levelOf(box);
  Cells& cells = m_levels[level];
  rangeOf(box, level).forEach([&](const Cell& cell) {
    cells[cell].push_back(f);
    return true;
  });
}

void FaceGrid::remove(Face f, const Box& box) {
  const int level = levelOf(box);
  const auto cells = m_levels.find(level);
  if (cells == m_levels.end()) return;
  rangeOf(box, level).forEach([&](const Cell& cell) {
    const auto found = cells->second.find(cell);
    if (found == cells->second.end()) return true;
    std::vector<Face>& faces = found->second;
    const auto place = std::find(faces.begin(), faces.end(), f);
    if (place != faces.end()) {
      *place = faces.back();
      faces.pop_back();
    }
    if (faces.empty()) cells->second.erase(found);
    return true;
  });
  if (cells->second.empty()) m_levels.erase(cells);
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/segment/SegmentParts.h"

#include "mesh/structure/DisjointSets.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <limits>
#include <numeric>

namespace handwheel {

SegmentParts::SegmentParts(const ImageVolume& image, const Segment& segment, const Progress& progress)
    : m_size(image.grid().size), m_range(segment.range()) {
  findRuns(image, segment, progress);
  DisjointSets sets(m_runs.size());
  const auto joinRows = [&](std::size_t a, std::size_t b) {
    std::size_t i = m_begins[a], j = m_begins[b];
    while (i < m_begins[a + 1] && j < m_begins[b + 1]) {
      if (m_runs[i].begin < m_runs[j].end && m_runs[j].begin < m_runs[i].end)
        sets.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
      ++(m_runs[i].end < m_runs[j].end ? i : j);
    }
  };
  for (int z = 0; z < m_size[2] && !progress.cancelled(); ++z) {
    progress.set(0.5 + 0.3 * z / m_size[2]);
    for (int y = 0; y < m_size[1]; ++y) {
      if (y > 0) joinRows(rowOf(y, z), rowOf(y - 1, z));
      if (z > 0) joinRows(rowOf(y, z), rowOf(y, z - 1));
    }
  }
  // The sets in the order of their first runs, then by size.
  constexpr std::uint32_t kUnnumbered = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> numbers(m_runs.size(), kUnnumbered);
  std::vector<std::size_t> sizes;
  m_parts.resize(m_runs.size());
  for (std::size_t i = 0; i < m_runs.size(); ++i) {
    std::uint32_t& number = numbers[sets.root(static_cast<std::uint32_t>(i))];
    if (number == kUnnumbered) {
      number = static_cast<std::uint32_t>(sizes.size());
      sizes.push_back(0);
    }
    m_parts[i] = number;
    sizes[number] += static_cast<std::size_t>(m_runs[i].end - m_runs[i].begin);
  }
  std::vector<std::uint32_t> order(sizes.size()), ranks(sizes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return sizes[a] > sizes[b]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    ranks[order[i]] = static_cast<std::uint32_t>(i);
    m_samples.push_back(sizes[order[i]]);
  }
  for (std::uint32_t& part : m_parts) part = ranks[part];
}

void SegmentParts::findRuns(const ImageVolume& image, const Segment& segment, const Progress& progress) {
  std::vector<std::vector<Run>> slices(static_cast<std::size_t>(m_size[2]));
  m_begins.assign(rowOf(0, m_size[2]) + 1, 0);
  readSegment(image, segment, [&](const auto& reader) {
    tbb::parallel_for(0, m_size[2], [&](int z) {
      if (progress.cancelled()) return;
      std::vector<Run>& runs = slices[static_cast<std::size_t>(z)];
      std::vector<std::uint8_t> row(static_cast<std::size_t>(m_size[0]) + 2, 0);
      for (int y = 0; y < m_size[1]; ++y) {
        reader.readRow(y, z, std::span(row).subspan(1));
        const std::size_t before = runs.size();
        for (int x = 0; x <= m_size[0]; ++x) {
          const std::uint8_t last = row[static_cast<std::size_t>(x)], next = row[static_cast<std::size_t>(x) + 1];
          if (next > last) runs.push_back({x, x});
          if (next < last) runs.back().end = x;
        }
        m_begins[rowOf(y, z) + 1] = runs.size() - before;
      }
    });
  });
  std::partial_sum(m_begins.begin(), m_begins.end(), m_begins.begin());
  m_runs.reserve(m_begins.back());
  for (std::vector<Run>& runs : slices) {
    m_runs.insert(m_runs.end(), runs.begin(), runs.end());
    runs = {};
  }
}

std::size_t SegmentParts::total() const {
  return std::accumulate(m_samples.begin(), m_samples.end(), std::size_t{0});
}

std::size_t SegmentParts::countFrom(std::size_t samples) const {
  const auto end =
      std::partition_point(m_samples.begin(), m_samples.end(), [&](std::size_t n) { return n >= samples; });
  return static_cast<std::size_t>(end - m_samples.begin());
}

std::optional<std::size_t> SegmentParts::partAt(const VoxelIndex& sample) const {
  const std::size_t row = rowOf(sample.y(), sample.z());
  const auto begin = m_runs.begin() + static_cast<std::ptrdiff_t>(m_begins[row]),
             end = m_runs.begin() + static_cast<std::ptrdiff_t>(m_begins[row + 1]);
  const auto run = std::partition_point(begin, end, [&](const Run& each) { return each.end <= sample.x(); });
  if (run == end || run->begin > sample.x()) return {};
  return m_parts[static_cast<std::size_t>(run - m_runs.begin())];
}

Segment SegmentParts::only(std::size_t first, std::size_t end) const {
  const std::array<int, 3> count = Segment::bricksOf(m_size);
  const auto across = static_cast<std::size_t>(count[0]);
  const Segment::Brick none = std::make_shared<SegmentBrick>();
  std::vector<Segment::Brick> bricks(across * static_cast<std::size_t>(count[1]) * static_cast<std::size_t>(count[2]),
                                     none);
  tbb::parallel_for(0, count[2], [&](int layer) {
    // The bricks of one row of them at a time.
    for (int line = 0; line < count[1]; ++line) {
      std::vector<std::shared_ptr<SegmentBrick>> made(across);
      for (int z = 16 * layer; z < std::min(16 * (layer + 1), m_size[2]); ++z)
        for (int y = 16 * line; y < std::min(16 * (line + 1), m_size[1]); ++y)
          for (std::size_t i = m_begins[rowOf(y, z)]; i < m_begins[rowOf(y, z) + 1]; ++i) {
            if (m_parts[i] < first || m_parts[i] >= end) continue;
            for (int x = m_runs[i].begin; x < m_runs[i].end; ++x) {
              std::shared_ptr<SegmentBrick>& brick = made[static_cast<std::size_t>(x >> 4)];
              if (!brick) brick = std::make_shared<SegmentBrick>();
              brick->set(x & 15, y & 15, z & 15, true);
            }
          }
      const std::size_t start =
          (static_cast<std::size_t>(layer) * static_cast<std::size_t>(count[1]) + static_cast<std::size_t>(line)) *
          across;
      for (std::size_t i = 0; i < across; ++i)
        if (made[i]) bricks[start + i] = std::move(made[i]);
    }
  });
  return {m_range, m_size, std::move(bricks)};
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/surface/VolumeSurface.h"

#include "volume/surface/VolumeToSurface.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <set>
#include <unordered_map>
#include <vector>

namespace handwheel {
namespace {

constexpr int kStride = 4;  // stride of the samples of coarse triangles

// The division of a volume's blocks among pieces.
class PieceGrid {
 public:
  // cells: of a piece along each axis.
  explicit PieceGrid(int cells)
      : m_cells(cells), m_bits(std::countr_zero(static_cast<unsigned>(cells / VolumeBlock::kSize))) {}

  int cells() const { return m_cells; }

  VolumeSurface::Key pieceOf(const VoxelIndex& block) const {
    return {block.z() >> m_bits, block.y() >> m_bits, block.x() >> m_bits};
  }
  VoxelIndex firstBlockOf(const VolumeSurface::Key& key) const {
    return (1 << m_bits) * VoxelIndex(key[2], key[1], key[0]);
  }
  VoxelIndex firstVoxelOf(const VolumeSurface::Key& key) const { return VolumeBlock::kSize * firstBlockOf(key); }
  Vec3 originOf(const SparseVolume& volume, const VolumeSurface::Key& key) const {
    return volume.centre(firstVoxelOf(key) + VoxelIndex::Constant(m_cells / 2));
  }

  // The number of a block in its piece.
  std::uint16_t numberOf(const VoxelIndex& block) const {
    const int last = (1 << m_bits) - 1;
    return static_cast<std::uint16_t>((block.z() & last) << 2 * m_bits | (block.y() & last) << m_bits |
                                      (block.x() & last));
  }
  VoxelIndex blockOfNumber(std::uint16_t number) const {
    const int last = (1 << m_bits) - 1;
    return {number & last, number >> m_bits & last, number >> 2 * m_bits};
  }

  // The blocks of a piece in whose cells there can be surface, by number.
  std::vector<std::uint16_t> blocksOf(const SparseVolume& volume, const VolumeSurface::Key& key) const {
    const int side = (1 << m_bits) + 1;  // with those whose first samples end the last cells
    const auto at = [side](int x, int y, int z) { return static_cast<std::size_t>((z * side + y) * side + x); };
    std::vector<std::uint8_t> state(at(0, 0, side));  // 0 empty, 1 full, 2 samples
    const VoxelIndex first = firstBlockOf(key);
    for (int z = 0; z < side; ++z)
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
          const SparseVolume::View view = volume.view(first + VoxelIndex(x, y, z));
          state[at(x, y, z)] = view.block ? 2 : view.isFull ? 1 : 0;
        }
    std::vector<std::uint16_t> blocks;
    for (int i = 0; i < 1 << 3 * m_bits; ++i) {
      const auto number = static_cast<std::uint16_t>(i);
      const VoxelIndex in = blockOfNumber(number);
      const std::uint8_t own = state[at(in.x(), in.y(), in.z())];
      bool hasCells = own == 2;
      for (int k = 1; k < 8 && !hasCells; ++k)
        hasCells = state[at(in.x() + (k & 1), in.y() + (k >> 1 & 1), in.z() + (k >> 2))] != own;
      if (hasCells) blocks.push_back(number);
    }
    return blocks;
  }

 private:
  int m_cells;
  int m_bits;  // bits of a block's index in its piece along an axis
};

void extendBox(VolumePiece& piece) {
  const std::vector<float>& points = piece.fine.points;
  Eigen::AlignedBox3f box;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3)
    box.extend(Eigen::Vector3f(points[i], points[i + 1], points[i + 2]));
  if (!box.isEmpty()) piece.box = Box(box.min().cast<double>() + piece.origin, box.max().cast<double>() + piece.origin);
}

// The triangles of rebuilt blocks, by index.
using Renewed = std::unordered_map<std::uint16_t, VolumeTriangles>;

// Returns a piece of the rebuilt blocks and, for the other blocks, of the previous piece; null: empty.
VolumeSurface::Piece assembled(const SparseVolume& volume, const PieceGrid& grid, const VolumeSurface::Key& key,
                               const std::vector<std::uint16_t>& blocks, const Renewed& renewed,
                               const VolumePiece* before) {
  auto piece = std::make_shared<VolumePiece>();
  piece->origin = grid.originOf(volume, key);
  for (const std::uint16_t block : blocks) {
    const auto points = static_cast<std::uint32_t>(piece->fine.points.size() / 3);
    const auto corners = static_cast<std::uint32_t>(piece->fine.corners.size());
    if (const auto made = renewed.find(block); made != renewed.end()) {
      piece->fine.append(made->second, 0, made->second.points.size() / 3, 0, made->second.corners.size());
    } else if (before) {
      const auto& parts = before->parts;
      const auto part = std::lower_bound(parts.begin(), parts.end(), block,
                                         [](const VolumePiece::BlockPart& p, std::uint16_t b) { return p.block < b; });
      if (part == parts.end() || part->block != block) continue;
      const bool isLast = std::next(part) == parts.end();
      const std::size_t pointEnd = isLast ? before->fine.points.size() / 3 : std::next(part)->firstPoint;
      const std::size_t cornerEnd = isLast ? before->fine.corners.size() : std::next(part)->firstCorner;
      piece->fine.append(before->fine, part->firstPoint, pointEnd - part->firstPoint, part->firstCorner,
                         cornerEnd - part->firstCorner);
    }
    if (piece->fine.corners.size() > corners) piece->parts.push_back({block, points, corners});
  }
  if (piece->fine.corners.empty()) return nullptr;
  piece->coarse = coarseTriangles(volume, grid.firstVoxelOf(key), grid.cells() / kStride, kStride, piece->origin);
  extendBox(*piece);
  return piece;
}

}  // namespace

VolumeSurface::VolumeSurface(const SparseVolume& volume, Progress progress, int pieceCells) : m_pieceCells(pieceCells) {
  const PieceGrid grid(pieceCells);
  std::set<Key> pieces;
  for (const VoxelIndex& block : blocksWithCells(volume)) pieces.insert(grid.pieceOf(block));
  make(volume, std::vector<Key>(pieces.begin(), pieces.end()), progress);
}

std::vector<VolumeSurface::Key> VolumeSurface::piecesOf(std::span<const VoxelIndex> blocks, bool withNormals) const {
  const PieceGrid grid(m_pieceCells);
  std::set<Key> pieces;
  const int last = withNormals ? 1 : 0;
  for (const VoxelIndex& block : blocks)
    for (int z = -1; z <= last; ++z)
      for (int y = -1; y <= last; ++y)
        for (int x = -1; x <= last; ++x) pieces.insert(grid.pieceOf(block + VoxelIndex(x, y, z)));
  return {pieces.begin(), pieces.end()};
}

void VolumeSurface::make(const SparseVolume& volume, std::span<const Key> keys, Progress progress) {
  const PieceGrid grid(m_pieceCells);
  std::vector<Piece> made(keys.size());
  std::atomic<std::size_t> done{0};
  tbb::parallel_for(std::size_t{0}, keys.size(), [&](std::size_t i) {
    if (progress.cancelled()) return;
    const std::vector<std::uint16_t> blocks = grid.blocksOf(volume, keys[i]);
    Renewed all;
    for (const std::uint16_t block : blocks)
      all[block] = blockTriangles(volume, grid.firstBlockOf(keys[i]) + grid.blockOfNumber(block),
                                  grid.originOf(volume, keys[i]));
    made[i] = assembled(volume, grid, keys[i], blocks, all, nullptr);
    progress.set(static_cast<double>(++done) / static_cast<double>(keys.size()));
  });
  for (std::size_t i = 0; i < keys.size(); ++i) set(keys[i], std::move(made[i]));
}

void VolumeSurface::update(const SparseVolume& volume, std::span<const VoxelIndex> changedBlocks) {
  // A block's samples are corners of its own cells and of those of the blocks below, and give normals around it.
  const PieceGrid grid(m_pieceCells);
  std::map<Key, std::set<std::uint16_t>> touched;
  for (const VoxelIndex& block : changedBlocks)
    for (int k = 0; k < 27; ++k) {
      const VoxelIndex near = block + VoxelIndex(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
      touched[grid.pieceOf(near)].insert(grid.numberOf(near));
    }
  struct Work {
    Key key;
    std::vector<std::uint16_t> blocks;
    Renewed renewed;
    Piece made;
  };
  std::vector<Work> works;
  std::vector<std::pair<std::size_t, VolumeTriangles*>> renewals;  // pairs of work index and triangles; filled below
  std::vector<std::uint16_t> numbers;
  for (const auto& [key, dirty] : touched) {
    Work& work = works.emplace_back(Work{key, grid.blocksOf(volume, key), {}, nullptr});
    for (const std::uint16_t block : work.blocks)
      if (dirty.contains(block)) work.renewed[block];
  }
  for (std::size_t i = 0; i < works.size(); ++i)
    for (auto& [block, triangles] : works[i].renewed) {
      renewals.emplace_back(i, &triangles);
      numbers.push_back(block);
    }
  tbb::parallel_for(std::size_t{0}, renewals.size(), [&](std::size_t i) {
    const Key& key = works[renewals[i].first].key;
    *renewals[i].second =
        blockTriangles(volume, grid.firstBlockOf(key) + grid.blockOfNumber(numbers[i]), grid.originOf(volume, key));
  });
  tbb::parallel_for(std::size_t{0}, works.size(), [&](std::size_t i) {
    const auto before = m_pieces.find(works[i].key);
    works[i].made = assembled(volume, grid, works[i].key, works[i].blocks, works[i].renewed,
                              before != m_pieces.end() ? before->second.get() : nullptr);
  });
  for (Work& work : works) set(work.key, std::move(work.made));
}

void VolumeSurface::set(const Key& key, Piece piece) {
  if (piece) {
    m_pieces[key] = std::move(piece);
  } else {
    m_pieces.erase(key);
  }
}

Box VolumeSurface::box() const {
  Box all;
  for (const auto& [key, piece] : m_pieces) all.extend(piece->box);
  return all;
}

std::size_t VolumeSurface::triangleCount() const {
  std::size_t count = 0;
  for (const auto& [key, piece] : m_pieces) count += piece->fine.count();
  return count;
}

std::size_t VolumePiece::bytes() const {
  std::size_t sum = 0;
  for (const VolumeTriangles* t : {&fine, &coarse})
    sum += 2 * sizeof(float) * t->points.size() + sizeof(std::int32_t) * t->corners.size();
  return sum;
}

std::size_t VolumeSurface::bytes() const {
  std::size_t sum = 0;
  for (const auto& [key, piece] : m_pieces) sum += piece->bytes();
  return sum;
}

}  // namespace handwheel

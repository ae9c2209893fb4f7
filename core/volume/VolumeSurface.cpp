// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeSurface.h"

#include "volume/CellPolygons.h"
#include "volume/VolumeReader.h"
#include "volume/VolumeToSurface.h"

#include <tbb/parallel_for.h>

#include <atomic>
#include <set>
#include <unordered_map>
#include <vector>

namespace handwheel {
namespace {

constexpr int kSide = 64;   // cells of a piece
constexpr int kStride = 4;  // of the samples of coarse triangles

VolumeSurface::Key pieceOf(const VoxelIndex& block) {
  return {block.z() >> 3, block.y() >> 3, block.x() >> 3};
}

VoxelIndex firstBlockOf(const VolumeSurface::Key& key) {
  return 8 * VoxelIndex(key[2], key[1], key[0]);
}

// The blocks of a piece in whose cells there can be surface.
std::vector<VoxelIndex> blocksOf(const SparseVolume& volume, const VolumeSurface::Key& key) {
  constexpr int kBlocks = 9;                                    // with those whose first samples end the last cells
  std::array<std::uint8_t, kBlocks * kBlocks * kBlocks> state;  // 0 empty, 1 full, 2 samples
  const auto at = [](int x, int y, int z) { return static_cast<std::size_t>((z * kBlocks + y) * kBlocks + x); };
  const VoxelIndex first = firstBlockOf(key);
  for (int z = 0; z < kBlocks; ++z)
    for (int y = 0; y < kBlocks; ++y)
      for (int x = 0; x < kBlocks; ++x) {
        const SparseVolume::View view = volume.view(first + VoxelIndex(x, y, z));
        state[at(x, y, z)] = view.block ? 2 : view.isFull ? 1 : 0;
      }
  std::vector<VoxelIndex> blocks;
  for (int z = 0; z < 8; ++z)
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) {
        const std::uint8_t own = state[at(x, y, z)];
        bool hasCells = own == 2;
        for (int k = 1; k < 8 && !hasCells; ++k)
          hasCells = state[at(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2))] != own;
        if (hasCells) blocks.push_back(first + VoxelIndex(x, y, z));
      }
  return blocks;
}

// Adds vertices with the normals of the depths there.
class Vertices {
 public:
  Vertices(const VolumeReader& reader, const Vec3& origin, VolumeTriangles& to)
      : m_reader(reader), m_origin(origin), m_to(to) {}

  void add(const Vec3& p) {
    const Vec3 n = m_reader.normalAt(p);
    for (int k = 0; k < 3; ++k) {
      m_to.points.push_back(static_cast<float>(p[k] - m_origin[k]));
      m_to.normals.push_back(static_cast<float>(n[k]));
    }
  }

 private:
  const VolumeReader& m_reader;
  Vec3 m_origin;
  VolumeTriangles& m_to;
};

void makeFine(const VolumeReader& reader, const std::vector<VoxelIndex>& blocks, VolumePiece& piece) {
  const TriangleSoup soup = surfaceOf(reader.volume(), blocks);
  VolumeTriangles& made = piece.fine;
  made.points.reserve(3 * soup.points.size());
  made.normals.reserve(3 * soup.points.size());
  made.corners.reserve(3 * soup.triangles.size());
  Vertices vertices(reader, piece.origin, made);
  for (const Vec3& p : soup.points) {
    vertices.add(p);
    piece.box.extend(p);
  }
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t v : t) made.corners.push_back(static_cast<std::int32_t>(v));
}

// Marching cubes over cells of kStride voxels.
VolumeTriangles coarseTriangles(const VolumeReader& reader, const Vec3& origin, const VoxelIndex& first) {
  constexpr int n = kSide / kStride + 1;
  const auto at = [](int x, int y, int z) { return static_cast<std::size_t>((z * n + y) * n + x); };
  std::array<std::int16_t, n * n * n> samples;
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) samples[at(x, y, z)] = reader.sample(first + kStride * VoxelIndex(x, y, z));
  VolumeTriangles made;
  Vertices vertices(reader, origin, made);
  std::unordered_map<std::size_t, std::int32_t>
      known;  // vertices by 3 times the sample where their edge begins, and axis
  const CellPolygons& table = CellPolygons::table();
  const auto vertexOf = [&](const VoxelIndex& cell, int edge) {
    const auto [low, high] = cornersOfCellEdge(edge);
    const VoxelIndex a = cell + VoxelIndex(low & 1, low >> 1 & 1, low >> 2);
    const VoxelIndex b = cell + VoxelIndex(high & 1, high >> 1 & 1, high >> 2);
    const auto key = 3 * at(a.x(), a.y(), a.z()) + static_cast<std::size_t>(edge / 4);
    const auto [found, isNew] = known.try_emplace(key, static_cast<std::int32_t>(known.size()));
    if (isNew) {
      const double from = samples[at(a.x(), a.y(), a.z())], to = samples[at(b.x(), b.y(), b.z())];
      const Vec3 p = (a.cast<double>() + from / (from - to) * (b - a).cast<double>()) * kStride + first.cast<double>();
      vertices.add(reader.volume().origin() + reader.volume().voxel() * p);
    }
    return found->second;
  };
  for (int z = 0; z + 1 < n; ++z)
    for (int y = 0; y + 1 < n; ++y)
      for (int x = 0; x + 1 < n; ++x) {
        unsigned inside = 0;
        for (int c = 0; c < 8; ++c)
          if (samples[at(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2))] > 0) inside |= 1u << c;
        for (const CellPolygons::EdgeTriangle& t : table.triangles[inside])
          for (const int edge : t) made.corners.push_back(vertexOf({x, y, z}, edge));
      }
  return made;
}

VolumeSurface::Piece makePiece(const SparseVolume& volume, const VolumeSurface::Key& key) {
  const std::vector<VoxelIndex> blocks = blocksOf(volume, key);
  if (blocks.empty()) return nullptr;
  const VolumeReader reader(volume);
  auto piece = std::make_shared<VolumePiece>();
  const VoxelIndex first = VolumeBlock::kSize * firstBlockOf(key);
  piece->origin = volume.centre(first + VoxelIndex::Constant(kSide / 2));
  makeFine(reader, blocks, *piece);
  if (piece->fine.corners.empty()) return nullptr;
  piece->coarse = coarseTriangles(reader, piece->origin, first);
  return piece;
}

}  // namespace

VolumeSurface::VolumeSurface(const SparseVolume& volume, Progress progress) {
  std::set<Key> keys;
  for (const VoxelIndex& block : blocksWithCells(volume)) keys.insert(pieceOf(block));
  make(volume, {keys.begin(), keys.end()}, progress);
}

void VolumeSurface::update(const SparseVolume& volume, std::span<const VoxelIndex> changedBlocks) {
  // A block's samples are corners of its own cells and of those of the blocks below, and give normals around it.
  std::set<Key> touched;
  for (const VoxelIndex& block : changedBlocks)
    for (int k = 0; k < 27; ++k) touched.insert(pieceOf(block + VoxelIndex(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1)));
  make(volume, {touched.begin(), touched.end()}, {});
}

void VolumeSurface::make(const SparseVolume& volume, const std::vector<Key>& keys, Progress progress) {
  std::vector<Piece> made(keys.size());
  std::atomic<std::size_t> done{0};
  tbb::parallel_for(std::size_t{0}, keys.size(), [&](std::size_t i) {
    if (progress.cancelled()) return;
    made[i] = makePiece(volume, keys[i]);
    progress.set(static_cast<double>(++done) / static_cast<double>(keys.size()));
  });
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (made[i]) {
      m_pieces[keys[i]] = std::move(made[i]);
    } else {
      m_pieces.erase(keys[i]);
    }
  }
}

std::size_t VolumeSurface::triangleCount() const {
  std::size_t count = 0;
  for (const auto& [key, piece] : m_pieces) count += piece->fine.count();
  return count;
}

std::size_t VolumeSurface::bytes() const {
  std::size_t sum = 0;
  for (const auto& [key, piece] : m_pieces)
    for (const VolumeTriangles* t : {&piece->fine, &piece->coarse})
      sum += 2 * sizeof(float) * t->points.size() + sizeof(std::int32_t) * t->corners.size();
  return sum;
}

}  // namespace handwheel

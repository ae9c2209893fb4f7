// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/FaceHierarchy.h"
#include "viewport/overlay/ColourScale.h"
#include "viewport/surface/SurfaceGeometry.h"

#include <QFutureWatcher>
#include <functional>
#include <optional>
#include <set>

namespace handwheel {

// The default approximate number of triangles of the simplified mesh. A slow display draws the simplified mesh instead
// of a large mesh while the camera moves. The setting is view.coarse_triangles.
inline constexpr std::size_t kCoarseTriangles = 50000;
// Returns true if a mesh gets a simplified version. The version must have at most a quarter of the triangles, because
// otherwise the gain does not justify the loss of quality.
bool hasCoarseVersion(const HalfEdgeMesh& mesh, std::size_t coarseTriangles);

// Prepares a mesh for drawing and picking on worker threads. It builds the blocks, a simplified version and the search
// structure from a snapshot. The results are delivered on the window thread; results of a mesh that has been replaced
// meanwhile are discarded.
class MeshPreparation {
 public:
  struct Receivers {
    std::function<void(std::size_t block, SurfaceGeometry)> block;
    std::function<void(SurfaceGeometry)> coarse;
    std::function<void(std::shared_ptr<const FaceHierarchy>)> faces;
    std::function<void()> outOfMemory;  // called if memory runs out: some results will not be delivered
  };

  explicit MeshPreparation(Receivers receivers) : m_receivers(std::move(receivers)) {}
  ~MeshPreparation() { cancel(); }

  // Sets the number of faces per block, from the next startAll() on. The value is the setting view.block_faces.
  void setBlockFaces(Face faces) { m_nextBlockFaces = faces; }
  Face blockFaces() const { return m_blockFaces; }  // number of faces per block in the present preparation

  // Sets the size of the simplified version, from the next start on.
  void setCoarseTriangles(std::size_t triangles) { m_coarseTriangles = triangles; }

  // Sets the vertex values, from the next start on; null for none.
  void setValues(VertexValues values) { m_values = std::move(values); }

  // Builds all blocks of a mesh, the simplified version and the search structure. Drops pending work.
  void startAll(const HalfEdgeMesh& mesh, const Box& bounds, const Vec3& origin);
  // Prepares a mesh after an edit. Builds the given blocks, the blocks that are still pending, the simplified version
  // and the search structure.
  void startSome(const HalfEdgeMesh& mesh, const Box& bounds, const Vec3& origin,
                 const std::vector<std::size_t>& blocks);
  // Builds everything again for the last started mesh, after setValues().
  void startAgain(const HalfEdgeMesh& mesh, const Box& bounds, const Vec3& origin);
  // Builds blocks of a version that is shown only temporarily. Each run ends before the next one starts, so that some
  // versions are visible even if they arrive fast. Of the versions that arrive during a run, only the last is built.
  void show(const HalfEdgeMesh& mesh, const Vec3& origin, const std::set<std::size_t>& blocks);
  void cancel();
  // Waits for the blocks and delivers them.
  void finishBlocks();

 private:
  struct Block {
    std::size_t number;
    std::shared_ptr<SurfaceGeometry> geometry;  // shared, because futures return copies
  };
  struct Rest {
    std::shared_ptr<SurfaceGeometry> coarse;  // null: no simplified version
    std::shared_ptr<const FaceHierarchy> faces;
  };

  void startBlocks(const HalfEdgeMesh& mesh, const Vec3& origin);
  bool showNext();
  void startRest(const HalfEdgeMesh& mesh, const Box& bounds, const Vec3& origin);
  void deliver(const Block& block);

  Receivers m_receivers;
  Face m_blockFaces = kBlockFaces;
  Face m_nextBlockFaces = kBlockFaces;
  std::size_t m_coarseTriangles = kCoarseTriangles;
  VertexValues m_values;
  std::set<std::size_t> m_owed;  // blocks not yet delivered
  struct Shown {
    HalfEdgeMesh mesh;
    Vec3 origin;
    std::set<std::size_t> blocks;
  };
  std::optional<Shown> m_next;  // the version to show after the present run
  // A watcher is used for one run; destroying it drops pending results.
  std::unique_ptr<QFutureWatcher<Block>> m_blocks;
  std::unique_ptr<QFutureWatcher<Rest>> m_rest;
};

}  // namespace handwheel

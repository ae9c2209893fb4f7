// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ColourScale.h"
#include "viewport/Picking.h"
#include "viewport/SurfaceGeometry.h"

#include <QFutureWatcher>
#include <functional>
#include <optional>
#include <set>

namespace handwheel {

// Roughly the triangles that a slow display draws of a large mesh while the camera moves: the setting
// view.coarse_triangles, and its default.
inline constexpr std::size_t kCoarseTriangles = 50000;
// A stand-in must have far fewer triangles than the mesh, or it is not worth the look: a quarter at most.
bool hasStandIn(const HalfEdgeMesh& mesh, std::size_t coarseTriangles);

// Builds on worker threads what drawing and picking need of a mesh: blocks, a coarse stand-in and the search structure.
// Works on a snapshot; results come to the window thread, and none of a mesh that has been replaced meanwhile.
class MeshPreparation {
 public:
  using Index = std::shared_ptr<const PickIndex>;
  struct Receivers {
    std::function<void(std::size_t block, SurfaceGeometry)> block;
    std::function<void(SurfaceGeometry)> coarse;
    std::function<void(Index)> index;
    std::function<void()> outOfMemory;  // something of these will not come
  };

  explicit MeshPreparation(Receivers receivers) : m_receivers(std::move(receivers)) {}
  ~MeshPreparation() { cancel(); }

  // Faces to a block, from the next startAll() on: the setting view.block_faces.
  void setBlockFaces(Face faces) { m_nextBlockFaces = faces; }
  Face blockFaces() const { return m_blockFaces; }  // at present

  // Of the stand-in, from the next start on.
  void setCoarseTriangles(std::size_t triangles) { m_coarseTriangles = triangles; }

  // Of the vertices, for what is built from the next start on; null for none.
  void setValues(VertexValues values) { m_values = std::move(values); }

  // All blocks of the mesh and the rest. Drops what is under way.
  void startAll(const HalfEdgeMesh& mesh, const Box& bounds, const Vec3& origin);
  // After an edit: the given blocks, those still owed of the state before, and the rest.
  void startSome(const HalfEdgeMesh& mesh, const Box& bounds, const Vec3& origin,
                 const std::vector<std::size_t>& blocks);
  // All blocks of the mesh that was started last, with other values, and the rest.
  void startAgain(const HalfEdgeMesh& mesh, const Box& bounds, const Vec3& origin);
  // Blocks of a version that is only looked at for a moment. One run ends before the next begins, so that something is
  // seen however fast they come; of those that come meanwhile only the last is built.
  void show(const HalfEdgeMesh& mesh, const Vec3& origin, const std::set<std::size_t>& blocks);
  void cancel();
  // Waits for the blocks and hands them over.
  void finishBlocks();

 private:
  struct Block {
    std::size_t number;
    std::shared_ptr<SurfaceGeometry> geometry;  // shared, as futures hand out copies
  };
  struct Rest {
    std::shared_ptr<SurfaceGeometry> coarse;  // null where there is none
    Index index;
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
  std::optional<Shown> m_next;  // to be shown when the present run has ended
  // A watcher serves one run; destroying it drops the results that are on their way.
  std::unique_ptr<QFutureWatcher<Block>> m_blocks;
  std::unique_ptr<QFutureWatcher<Rest>> m_rest;
};

}  // namespace handwheel

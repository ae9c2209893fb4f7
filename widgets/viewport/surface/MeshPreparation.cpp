// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/MeshPreparation.h"

#include "viewport/Worker.h"

namespace handwheel {

namespace {

template <class T>
void drop(std::unique_ptr<QFutureWatcher<T>>& watcher) {
  if (watcher) watcher->cancel();
  watcher.reset();
}

}  // namespace

bool hasCoarseVersion(const HalfEdgeMesh& mesh, std::size_t coarseTriangles) {
  constexpr std::size_t kGain = 4;
  return mesh.faceSlots() / kGain > coarseTriangles;
}

void MeshPreparation::startAll(const HalfEdgeMesh& mesh, const Box& bounds, const Vec3& origin) {
  cancel();
  m_blockFaces = m_nextBlockFaces;
  for (std::size_t b = 0; b < blockCount(mesh, m_blockFaces); ++b) m_owed.insert(b);
  startBlocks(mesh, origin);
  startRest(mesh, bounds, origin);
}

void MeshPreparation::startSome(const HalfEdgeMesh& mesh, const Box& bounds, const Vec3& origin,
                                const std::vector<std::size_t>& blocks) {
  m_owed.insert(blocks.begin(), blocks.end());
  if (m_next) m_owed.merge(m_next->blocks);
  startBlocks(mesh, origin);
  startRest(mesh, bounds, origin);
}

void MeshPreparation::startAgain(const HalfEdgeMesh& mesh, const Box& bounds, const Vec3& origin) {
  for (std::size_t b = 0; b < blockCount(mesh, m_blockFaces); ++b) m_owed.insert(b);
  startBlocks(mesh, origin);
  startRest(mesh, bounds, origin);
}

void MeshPreparation::show(const HalfEdgeMesh& mesh, const Vec3& origin, const std::set<std::size_t>& blocks) {
  if (m_blocks && !m_blocks->isFinished()) {
    Shown next{mesh, origin, blocks};
    if (m_next) next.blocks.merge(m_next->blocks);
    m_next = std::move(next);
    return;
  }
  m_owed.insert(blocks.begin(), blocks.end());
  if (m_next) m_owed.merge(m_next->blocks);
  startBlocks(mesh, origin);
}

void MeshPreparation::cancel() {
  m_next.reset();
  drop(m_blocks);
  drop(m_rest);
  m_owed.clear();
}

void MeshPreparation::finishBlocks() {
  if (!m_blocks) return;
  do {
    m_blocks->waitForFinished();
    for (const Block& block : m_blocks->future().results()) deliver(block);
  } while (showNext());
}

void MeshPreparation::startBlocks(const HalfEdgeMesh& mesh, const Vec3& origin) {
  m_next.reset();
  drop(m_blocks);
  const std::vector<std::size_t> owed(m_owed.begin(), m_owed.end());
  m_blocks =
      runOnWorker<Block>([mesh, origin, owed, faces = m_blockFaces, values = m_values](QPromise<Block>& promise) {
        for (const std::size_t b : owed) {
          if (promise.isCanceled()) return;
          promise.addResult(
              Block{b, std::make_shared<SurfaceGeometry>(blockGeometry(mesh, b, origin, faces, values.get()))});
        }
      });
  QObject::connect(m_blocks.get(), &QFutureWatcherBase::resultReadyAt, m_blocks.get(),
                   [this](int i) { deliver(m_blocks->resultAt(i)); });
  QObject::connect(m_blocks.get(), &QFutureWatcherBase::finished, m_blocks.get(), [this] {
    if (!m_blocks->isCanceled() && !m_owed.empty()) m_receivers.outOfMemory();
  });
  // Queued: a watcher must not be destroyed by its own report.
  QObject::connect(
      m_blocks.get(), &QFutureWatcherBase::finished, m_blocks.get(), [this] { showNext(); }, Qt::QueuedConnection);
}

bool MeshPreparation::showNext() {
  if (!m_next) return false;
  const Shown next = std::move(*m_next);
  m_owed.insert(next.blocks.begin(), next.blocks.end());
  startBlocks(next.mesh, next.origin);
  return true;
}

void MeshPreparation::startRest(const HalfEdgeMesh& mesh, const Box& bounds, const Vec3& origin) {
  drop(m_rest);
  m_rest = runOnWorker<Rest>([mesh, bounds, origin, triangles = m_coarseTriangles,
                              values = m_values](QPromise<Rest>& promise) {
    Rest rest;
    if (hasCoarseVersion(mesh, triangles)) {
      rest.coarse = std::make_shared<SurfaceGeometry>(coarseGeometry(mesh, bounds, origin, triangles, values.get()));
    }
    if (promise.isCanceled()) return;
    rest.faces = std::make_shared<const FaceHierarchy>(mesh);
    promise.addResult(std::move(rest));
  });
  QObject::connect(m_rest.get(), &QFutureWatcherBase::resultReadyAt, m_rest.get(), [this](int) {
    const Rest rest = m_rest->result();
    if (rest.coarse) m_receivers.coarse(std::move(*rest.coarse));
    m_receivers.faces(rest.faces);
  });
  QObject::connect(m_rest.get(), &QFutureWatcherBase::finished, m_rest.get(), [this] {
    if (!m_rest->isCanceled() && m_rest->future().resultCount() == 0) m_receivers.outOfMemory();
  });
}

void MeshPreparation::deliver(const Block& block) {
  if (m_owed.erase(block.number) == 0) return;  // already handed over by finishBlocks()
  m_receivers.block(block.number, std::move(*block.geometry));
}

}  // namespace handwheel

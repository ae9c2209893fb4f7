// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/MeshLayer.h"

#include "mesh/selection/PreviewMesh.h"
#include "mesh/structure/MeshBounds.h"
#include "viewport/surface/MeshLayerPrivate.h"

namespace handwheel {

namespace {

constexpr std::size_t kOutlineFaces = 5000;

// Returns corners of faces at even intervals.
std::vector<Vec3> sample(const HalfEdgeMesh& mesh) {
  std::vector<Vec3> points;
  const std::size_t step = mesh.faceSlots() / kOutlineFaces + 1;
  for (std::size_t f = 0; f < mesh.faceSlots(); f += step) {
    const auto face = static_cast<Face>(f);
    if (!mesh.isLive(face)) continue;
    for (const Vertex v : mesh.triangle(face)) points.push_back(mesh.position(v));
  }
  return points;
}

Box boundsOfTouched(const PreviewMesh* previewMesh) {
  Box bounds;
  if (!previewMesh) return bounds;
  previewMesh->touched.forEach([&](Face f) {
    if (!previewMesh->mesh.isLive(f)) return;
    for (const Vec3& p : previewMesh->mesh.points(f)) bounds.extend(p);
  });
  return bounds;
}

}  // namespace

MeshLayer::MeshLayer() : d(std::make_unique<Private>(*this)) {}

MeshLayer::~MeshLayer() = default;

void MeshLayer::setBlockFaces(Face faces) {
  d->preparation.setBlockFaces(faces);
}

void MeshLayer::setCoarseTriangles(std::size_t triangles) {
  d->preparation.setCoarseTriangles(triangles);
}

void MeshLayer::setMesh(const HalfEdgeMesh& mesh) {
  setMesh(mesh, boundsOf(mesh));
}

void MeshLayer::setMesh(const HalfEdgeMesh& mesh, const Box& bounds) {
  d->dropDerived(true);
  d->take(mesh, bounds, sample(mesh));
  d->preparation.startAll(mesh, d->box, d->origin);
  report(LayerChange::Model);
}

void MeshLayer::setMeshAtOnce(const HalfEdgeMesh& mesh, VertexValues values, const ColourScale& scale) {
  d->preparation.cancel();
  d->dropDerived(false);
  d->take(mesh, boundsOf(mesh), sample(mesh));
  for (std::size_t b = 0; b < blockCount(mesh); ++b) {
    d->blocks.enqueue(b, blockGeometry(mesh, b, d->origin, kBlockFaces, values.get()));
  }
  d->values = std::move(values);
  if (d->values) setColourScale(scale);
  report(LayerChange::Model);
}

void MeshLayer::updateMesh(const HalfEdgeMesh& mesh, const std::vector<Face>& touched) {
  const std::vector<std::size_t> blocks = blocksAround(d->mesh, mesh, touched, d->preparation.blockFaces());
  d->dropDerived(true);
  d->mesh = mesh;
  d->outline = sample(mesh);
  // Removed faces may leave the bounds too large, which harms nothing; measuring a large mesh anew takes its time.
  for (const Face f : touched) {
    if (f >= mesh.faceSlots() || !mesh.isLive(f)) continue;  // its slot may have been removed with it
    for (const Vertex v : mesh.triangle(f)) d->box.extend(mesh.position(v));
  }
  d->marks.setMesh(mesh, d->origin);
  d->preparation.startSome(mesh, d->box, d->origin, blocks);
  report(LayerChange::Elements);
}

void MeshLayer::clear() {
  d->preparation.cancel();
  d->dropDerived(false);
  d->marks.clear();
  d->take({}, {}, {});
  report(LayerChange::Elements);
}

void MeshLayer::setSurfaceValues(VertexValues values, const ColourScale& scale) {
  if (!values && !d->values) return;
  const bool isNew = values && values != d->values;
  d->values = std::move(values);
  d->preparation.setValues(d->values);
  if (!d->values) {
    d->blocks.setColourScale(std::nullopt);
    return report(LayerChange::Look);
  }
  setColourScale(scale);
  if (isNew) d->preparation.startAgain(d->mesh, d->box, d->origin);
}

void MeshLayer::setColourScale(const ColourScale& scale) {
  d->colourScale = scale;
  if (d->values) d->blocks.setColourScale(scale);
  report(LayerChange::Look);
}

void MeshLayer::setLoops(std::vector<LoopMark> loops) {
  d->marks.setLoops(std::move(loops));
  report(LayerChange::Look);
}

void MeshLayer::setFaceMarks(std::vector<FaceMark> marks) {
  d->marks.setFaceMarks(std::move(marks));
  report(LayerChange::Look);
}

void MeshLayer::setPointMarks(std::vector<PointMark> marks) {
  d->marks.setPointMarks(std::move(marks));
  report(LayerChange::Look);
}

void MeshLayer::setLineMarks(std::vector<LineMark> marks) {
  d->marks.setLineMarks(std::move(marks));
  report(LayerChange::Look);
}

void MeshLayer::setSection(std::vector<SectionMark> section) {
  d->marks.setSection(std::move(section));
  report(LayerChange::Look);
}

void MeshLayer::setPreview(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
  d->marks.setPreview(points, triangles);
  report(LayerChange::Look);
}

void MeshLayer::setHighlightedLoop(int id) {
  if (id == d->listLoop) return;
  d->listLoop = id;
  d->markHovered();
  report(LayerChange::Look);
}

// A tool may set all that it shows with each move of the mouse: equal values cost no frame.

void MeshLayer::setSelectedFaces(const FaceSelection& faces) {
  if (d->marks.setSelectedFaces(faces)) report(LayerChange::Look);
}

void MeshLayer::setHighlightedFaces(const FaceSelection& faces) {
  if (d->marks.setHighlightedFaces(faces)) report(LayerChange::Look);
}

void MeshLayer::setPreviewMesh(const std::shared_ptr<const PreviewMesh>& previewMesh) {
  if (previewMesh == d->previewMesh) return;
  std::set<std::size_t> blocks = d->previewBlocks();
  d->previewMesh = previewMesh;
  blocks.merge(d->previewBlocks());
  d->previewBox = boundsOfTouched(previewMesh.get());
  d->markHovered();
  d->preparation.show(previewMesh ? previewMesh->mesh : d->mesh, d->origin, blocks);
}

}  // namespace handwheel

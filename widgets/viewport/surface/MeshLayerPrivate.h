// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/MarkActors.h"
#include "viewport/surface/MeshBlocks.h"
#include "viewport/surface/MeshLayer.h"
#include "viewport/surface/MeshPreparation.h"

namespace handwheel {

struct PreviewMesh;

// The private data of MeshLayer, shared by its source files. One of these files sets the content, the other answers the
// calls of the view.
class MeshLayer::Private {
 public:
  explicit Private(MeshLayer& layer)
      : q(layer),
        blocks(layer.props()),
        marks(layer.props()),
        preparation({[this](std::size_t block, SurfaceGeometry geometry) {
                       blocks.enqueue(block, std::move(geometry));
                       q.report(LayerChange::Look);
                     },
                     [this](SurfaceGeometry geometry) { blocks.setCoarse(std::move(geometry)); },
                     [this](std::shared_ptr<const FaceHierarchy> built) {
                       faces = std::move(built);
                       areFacesAwaited = false;
                       q.report(LayerChange::Search);
                     },
                     [this] { q.report(LayerChange::OutOfMemory); }}) {}

  // Drops the search structure and the values of the previous mesh.
  void dropDerived(bool areFacesAwaitedNow) {
    faces.reset();
    areFacesAwaited = areFacesAwaitedNow;
    q.setSurfaceValues(nullptr, {});
  }
  void take(const HalfEdgeMesh& next, const Box& bounds, std::vector<Vec3> points) {
    previewMesh.reset();
    previewBox.setEmpty();
    blocks.clear();
    mesh = next;
    box = bounds;
    outline = std::move(points);
    origin = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center());
    marks.setMesh(mesh, origin);
  }
  // Returns the blocks of the faces that the preview changes. Neighbouring faces, whose normals change with them, are
  // nearly always in the same blocks.
  std::set<std::size_t> previewBlocks() const {
    std::set<std::size_t> found;
    if (previewMesh) previewMesh->touched.forEach([&](Face f) { found.insert(f / preparation.blockFaces()); });
    return found;
  }
  // Updates the hovered marks. No face is marked while a preview version of the mesh is shown.
  void markHovered() { marks.setHovered(listLoop, hoveredLoop, previewMesh ? kNone : hoveredFace); }

  MeshLayer& q;
  MeshBlocks blocks;
  MarkActors marks;
  HalfEdgeMesh mesh;
  Box box;
  Box previewBox;  // bounds of the changes by a tool
  std::vector<Vec3> outline;
  Vec3 origin = Vec3::Zero();                  // the model point at the origin of the geometry
  std::shared_ptr<const FaceHierarchy> faces;  // for picking
  bool areFacesAwaited = false;
  MeshPreparation preparation;
  VertexValues values;  // values that colour the mesh; null: none
  ColourScale colourScale;
  std::shared_ptr<const PreviewMesh> previewMesh;
  int listLoop = -1;
  int hoveredLoop = -1;
  Face hoveredFace = kNone;
};

}  // namespace handwheel

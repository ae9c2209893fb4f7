// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/selection/FaceSelection.h"
#include "viewport/MeshMarks.h"
#include "viewport/ViewLayer.h"
#include "viewport/overlay/ColourScale.h"

namespace handwheel {

class FaceHierarchy;
struct PreviewMesh;

// A view layer that shows a mesh with its marks. Its elements are faces and, near the cursor, loops.
class MeshLayer : public ViewLayer {
 public:
  MeshLayer();
  ~MeshLayer() override;

  // Sets the number of faces that are built and drawn together, from the next setMesh() on. The value is the setting
  // view.block_faces.
  void setBlockFaces(Face faces);
  // Sets the approximate number of triangles that a slow display draws of a large mesh while the camera moves, from the
  // next setMesh() or edit on. The value is the setting view.coarse_triangles.
  void setCoarseTriangles(std::size_t triangles);

  // Shows another model, and keeps the marks. Returns at once; the blocks appear over the next frames.
  void setMesh(const HalfEdgeMesh& mesh);
  // Shows another model whose bounds are known, because computing them is slow for a large mesh. bounds: the bounds of
  // the live faces.
  void setMesh(const HalfEdgeMesh& mesh, const Box& bounds);
  // Shows another model for pictures: builds all blocks before it returns, and makes no face pickable. values: one
  // value per vertex slot, or null.
  void setMeshAtOnce(const HalfEdgeMesh& mesh, VertexValues values, const ColourScale& scale);
  // Shows the same model after an edit that touched these faces (added, removed, turned or with moved corners).
  // Rebuilds only the blocks concerned.
  void updateMesh(const HalfEdgeMesh& mesh, const std::vector<Face>& touched);
  // Removes the mesh and every mark.
  void clear();

  // Colours the mesh by one value per vertex slot, with a legend, until the mesh is edited or replaced; null removes
  // the colours. The blocks change colour over the next frames.
  void setSurfaceValues(VertexValues values, const ColourScale& scale);
  // Changes the colour scale of the surface values, without building geometry again.
  void setColourScale(const ColourScale& scale);

  void setLoops(std::vector<LoopMark> loops);
  void setFaceMarks(std::vector<FaceMark> marks);
  void setPointMarks(std::vector<PointMark> marks);
  void setLineMarks(std::vector<LineMark> marks);
  // Draws the outline of a section on the model.
  void setSection(std::vector<SectionMark> section);
  // Shows a translucent patch over the model, as the preview of an operation. An empty patch removes it.
  void setPreview(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
  // Highlights a loop like the one under the cursor, when its row is hovered in a list; -1: none.
  void setHighlightedLoop(int id);

  // Set the faces that are selected or highlighted by a tool, until the next call.
  void setSelectedFaces(const FaceSelection& faces);
  void setHighlightedFaces(const FaceSelection& faces);
  // Shows another version instead of the mesh while a tool works on it; null: shows the mesh. Marks and picking still
  // refer to the mesh. The version appears when its blocks are built, and is skipped if the next version arrives
  // earlier.
  void setPreviewMesh(const std::shared_ptr<const PreviewMesh>& previewMesh);

  // Returns the search structure over the faces of the mesh, for picking and for tools. While the structure of the
  // present version is being built, the result may be that of an older version; it is null before the first one is
  // ready.
  std::shared_ptr<const FaceHierarchy> faces() const;

  Box bounds() const override;
  Box drawnBounds() const override;
  std::vector<Vec3> outline() const override;
  void setStyle(const SurfaceStyle& style) override;
  void setCoarseShown(bool isReduced) override;
  std::size_t takePiece() override;
  std::size_t takeMarks() override;
  bool owesMarks() const override;
  void finish() override;
  int builtCount() const override;
  void prepare(const LayerFrame& frame) override;
  void paintOver(QPainter& painter, const QSizeF& size, LengthUnit unit, const SceneColours& colours) const override;
  bool isSearchable() const override;
  std::optional<LayerHit> firstHit(const Vec3& origin, const Vec3& direction) const override;
  void findNear(const CameraNavigation& view, const Vec2& cursor, std::vector<LayerHit>& found) const override;
  Vec3 normalNear(const Vec3& p) const override;
  void setHovered(std::optional<std::uint64_t> element) override;

 private:
  class Private;
  std::unique_ptr<Private> d;
};

// Return the face or the loop of a mesh layer that was hit, or kNone and -1 if the hit is not of that kind. A loop
// within 8 pixels of the cursor takes precedence over the face behind it.
Face faceOf(const Pick& pick);
int loopOf(const Pick& pick);

}  // namespace handwheel

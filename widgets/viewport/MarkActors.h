// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/DepthOffsetActor.h"
#include "viewport/Lighting.h"
#include "viewport/MeshMarks.h"
#include "viewport/surface/FaceActors.h"

#include <bitset>

namespace handwheel {

// Strokes with an outline of another colour. They are visible on every surface and background.
class CasedStrokes {
 public:
  CasedStrokes(LayerProps& props, double lift, double width, double rim);

  void set(std::vector<Stroke> strokes, const QColor& rim, const Vec3& origin);
  void prepare(const LayerFrame& frame);

 private:
  StrokeActors m_rim;
  StrokeActors m_core;
};

// All marks that are drawn over the model.
class MarkActors {
 public:
  explicit MarkActors(LayerProps& props);

  void clear();
  void setLoops(std::vector<LoopMark> loops);
  void setFaceMarks(std::vector<FaceMark> marks);
  void setPointMarks(std::vector<PointMark> marks);
  void setLineMarks(std::vector<LineMark> marks);
  void setSection(std::vector<SectionMark> section);
  void setPreview(std::vector<Vec3> points, std::vector<Triangle> triangles);
  // Set the faces that are selected or highlighted by a tool, until the next call. Return false if the faces are
  // unchanged.
  bool setSelectedFaces(const FaceSelection& faces);
  bool setHighlightedFaces(const FaceSelection& faces) { return m_highlighted.set(faces); }
  const std::vector<LoopMark>& loops() const { return m_loops; }

  // Sets the loops to be drawn as hovered and the face under the cursor; -1 and kNone: none.
  void setHovered(int listLoop, int cursorLoop, Face face);
  void setColours(const SceneColours& colours);
  // Sets the mesh that face marks refer to, and the model point at the origin of the drawing.
  void setMesh(const HalfEdgeMesh& mesh, const Vec3& origin);

  // Builds some of the face marks that are not yet drawn. Returns the approximate cost in triangles, or 0 if all are
  // drawn.
  std::size_t buildPendingFaces();
  bool hasPendingFaces() const { return m_selected.isStale() || m_highlighted.isStale(); }
  // Rebuilds the other marks that have changed since the last frame. Each is rebuilt once, however often it was set.
  void prepare(const LayerFrame& frame);

 private:
  enum Part { Loops, Faces, HoveredFace, Points, Lines, Section, Preview, SelectedEdges, kParts };

  void rebuildStale();
  void rebuildLoops();
  void rebuildFaces();
  void rebuildHoveredFace();
  void rebuildPoints();
  void rebuildLines();
  void rebuildSection();
  void rebuildPreview();
  void rebuildSelectedEdges();
  void addFace(PolyDataBuilder& builder, Face face, const QColor& colour) const;

  HalfEdgeMesh m_mesh;  // the mesh that face marks refer to; shares its pages with the copy of the layer
  Vec3 m_origin = Vec3::Zero();
  SceneColours m_colours;
  std::vector<LoopMark> m_loops;
  std::vector<FaceMark> m_faceMarks;
  std::vector<PointMark> m_pointMarks;
  std::vector<LineMark> m_lineMarks;
  std::vector<SectionMark> m_sectionMarks;
  std::vector<Vec3> m_previewPoints;
  std::vector<Triangle> m_previewTriangles;
  std::vector<Face> m_outlined;  // the selected faces, if they are few
  int m_listLoop = -1;
  int m_cursorLoop = -1;
  Face m_hoveredFace = kNone;
  std::bitset<kParts> m_stale;

  DepthOffsetActor m_faces;
  FaceActors m_selected;
  FaceActors m_highlighted;
  DepthOffsetActor m_hovered;
  DepthOffsetActor m_preview;
  StrokeActors m_previewEdges;
  CasedStrokes m_plainLoops;
  CasedStrokes m_strongLoops;
  CasedStrokes m_lines;
  CasedStrokes m_points;
  CasedStrokes m_section;
  CasedStrokes m_selectedEdges;
};

}  // namespace handwheel

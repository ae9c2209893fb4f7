// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/FaceSelection.h"
#include "viewport/Layers.h"

#include <map>
#include <set>

namespace handwheel {

// Faces of the mesh in one colour, in pieces by their numbers: so a change of a large set costs what changed, and what
// is much comes in the course of some frames.
class FaceLayer {
 public:
  static constexpr Face kPieceFaces = 16'384;

  FaceLayer(vtkRenderer* renderer, double lift, double opacity);

  bool set(const FaceSelection& faces);  // false when they are the same as before
  void setColour(const QColor& colour);
  // The mesh is another, or was edited.
  void setStale();
  bool isStale() const { return !m_stale.empty(); }
  // Builds one piece that is stale. Returns about what it cost, in triangles; 0 when none was.
  std::size_t takeOne(const HalfEdgeMesh& mesh, const Vec3& origin);
  void prepare(const LayerFrame& frame);

 private:
  Layer& layer(std::size_t piece);
  void drop(std::size_t piece);

  vtkRenderer* m_renderer;
  double m_lift;
  double m_opacity;
  QColor m_colour;
  FaceSelection m_faces;
  std::set<std::size_t> m_stale;          // pieces
  std::map<std::size_t, Layer> m_layers;  // of the pieces that have faces
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/selection/FaceSelection.h"
#include "viewport/DepthOffsetActor.h"

#include <map>
#include <set>

namespace handwheel {

// The actors of a set of faces that is drawn in one colour. The set is split into pieces by face number. Therefore a
// change of a large set costs only the changed pieces, and a large set is built over several frames.
class FaceActors {
 public:
  static constexpr Face kPieceFaces = 16'384;

  FaceActors(LayerProps& props, double lift, double opacity);

  bool set(const FaceSelection& faces);  // sets the faces; returns false if they are unchanged
  void setColour(const QColor& colour);
  // Marks all pieces as outdated. To be called when the mesh was replaced or edited.
  void setStale();
  bool isStale() const { return !m_stale.empty(); }
  // Builds one stale piece. Returns the approximate cost in triangles, or 0 if no piece is stale.
  std::size_t takeOne(const HalfEdgeMesh& mesh, const Vec3& origin);
  void prepare(const LayerFrame& frame);

 private:
  DepthOffsetActor& actor(std::size_t piece);
  void drop(std::size_t piece);

  LayerProps& m_props;
  double m_lift;
  double m_opacity;
  QColor m_colour;
  FaceSelection m_faces;
  std::set<std::size_t> m_stale;                     // piece numbers
  std::map<std::size_t, DepthOffsetActor> m_actors;  // actors of the pieces that have faces
};

}  // namespace handwheel

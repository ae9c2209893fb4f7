// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/FaceActors.h"

#include <vtkProperty.h>

namespace handwheel {

FaceActors::FaceActors(LayerProps& props, double lift, double opacity)
    : m_props(props), m_lift(lift), m_opacity(opacity) {}

bool FaceActors::set(const FaceSelection& faces) {
  const std::vector<std::size_t> pieces = m_faces.differingRanges(faces, kPieceFaces);
  m_faces = faces;
  m_stale.insert(pieces.begin(), pieces.end());
  return !pieces.empty();
}

void FaceActors::setColour(const QColor& colour) {
  m_colour = colour;
  for (auto& [piece, actor] : m_actors) actor.property()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

void FaceActors::setStale() {
  for (const auto& [piece, actor] : m_actors) m_stale.insert(piece);
}

std::size_t FaceActors::takeOne(const HalfEdgeMesh& mesh, const Vec3& origin) {
  if (m_stale.empty()) return 0;
  const std::size_t piece = m_stale.extract(m_stale.begin()).value();
  const std::vector<Face> faces = m_faces.facesIn(static_cast<Face>(piece * kPieceFaces), kPieceFaces);
  faces.empty() ? drop(piece) : actor(piece).setData(facesOf(mesh, faces, origin));
  return faces.size() + 1;
}

void FaceActors::prepare(const LayerFrame& frame) {
  for (auto& [piece, actor] : m_actors) actor.prepare(frame);
}

void FaceActors::drop(std::size_t piece) {
  const auto node = m_actors.extract(piece);
  if (!node.empty()) m_props.remove(node.mapped().actor());
}

DepthOffsetActor& FaceActors::actor(std::size_t piece) {
  const auto [entry, isNew] = m_actors.try_emplace(piece, m_props, m_lift);
  if (isNew) {
    setOverlayMaterial(entry->second.property());
    entry->second.property()->SetOpacity(m_opacity);
    setColour(m_colour);
  }
  return entry->second;
}

}  // namespace handwheel

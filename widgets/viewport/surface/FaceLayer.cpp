// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/FaceLayer.h"

#include <vtkProperty.h>

namespace handwheel {

FaceLayer::FaceLayer(vtkRenderer* renderer, double lift, double opacity)
    : m_renderer(renderer), m_lift(lift), m_opacity(opacity) {}

bool FaceLayer::set(const FaceSelection& faces) {
  const std::vector<std::size_t> pieces = m_faces.differingRanges(faces, kPieceFaces);
  m_faces = faces;
  m_stale.insert(pieces.begin(), pieces.end());
  return !pieces.empty();
}

void FaceLayer::setColour(const QColor& colour) {
  m_colour = colour;
  for (auto& [piece, layer] : m_layers) layer.property()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

void FaceLayer::setStale() {
  for (const auto& [piece, layer] : m_layers) m_stale.insert(piece);
}

std::size_t FaceLayer::takeOne(const HalfEdgeMesh& mesh, const Vec3& origin) {
  if (m_stale.empty()) return 0;
  const std::size_t piece = m_stale.extract(m_stale.begin()).value();
  const std::vector<Face> faces = m_faces.facesIn(static_cast<Face>(piece * kPieceFaces), kPieceFaces);
  faces.empty() ? drop(piece) : layer(piece).setData(facesOf(mesh, faces, origin));
  return faces.size() + 1;
}

void FaceLayer::prepare(const LayerFrame& frame) {
  for (auto& [piece, layer] : m_layers) layer.prepare(frame);
}

void FaceLayer::drop(std::size_t piece) {
  const auto node = m_layers.extract(piece);
  if (!node.empty()) m_renderer->RemoveActor(node.mapped().actor());
}

Layer& FaceLayer::layer(std::size_t piece) {
  const auto [place, isNew] = m_layers.try_emplace(piece, m_renderer, m_lift);
  if (isNew) {
    setOverlayMaterial(place->second.property());
    place->second.property()->SetOpacity(m_opacity);
    setColour(m_colour);
  }
  return place->second;
}

}  // namespace handwheel

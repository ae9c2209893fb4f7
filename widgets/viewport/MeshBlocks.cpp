// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/MeshBlocks.h"

#include "viewport/PolyData.h"

#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace handwheel {

MeshBlocks::MeshBlocks(vtkRenderer* renderer) : m_renderer(renderer), m_colours(sceneColours(false)) {}

void MeshBlocks::clear() {
  for (const auto& actor : m_blocks) {
    if (actor) m_renderer->RemoveActor(actor);
  }
  m_blocks.clear();
  m_queue.clear();
  setCoarse(std::nullopt);
}

void MeshBlocks::enqueue(std::size_t block, SurfaceGeometry geometry) {
  m_queue.push_back({block, std::move(geometry)});
}

bool MeshBlocks::takeOne() {
  if (m_queue.empty()) return false;
  const Pending next = std::move(m_queue.front());
  m_queue.pop_front();
  if (next.block >= m_blocks.size()) m_blocks.resize(next.block + 1);
  auto& actor = m_blocks[next.block];
  if (actor) m_renderer->RemoveActor(actor);
  actor = makeActor(next.geometry);
  actor->SetVisibility(!m_reduced || !m_coarse);
  ++m_built;
  return true;
}

void MeshBlocks::setCoarse(std::optional<SurfaceGeometry> geometry) {
  if (m_coarse) m_renderer->RemoveActor(m_coarse);
  m_coarse = geometry ? makeActor(*geometry) : nullptr;
  updateVisibility();
}

void MeshBlocks::setReduced(bool reduced) {
  if (reduced == m_reduced) return;
  m_reduced = reduced;
  updateVisibility();
}

void MeshBlocks::updateVisibility() {
  const bool showCoarse = m_reduced && m_coarse;
  if (m_coarse) m_coarse->SetVisibility(showCoarse);
  for (const auto& actor : m_blocks) {
    if (actor) actor->SetVisibility(!showCoarse);
  }
}

vtkSmartPointer<vtkActor> MeshBlocks::makeActor(const SurfaceGeometry& geometry) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(toPolyData(geometry));
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->PickableOff();
  style(actor);
  m_renderer->AddActor(actor);
  return actor;
}

void MeshBlocks::style(vtkActor* actor) const {
  setSurfaceMaterial(actor, m_colours);
  for (vtkProperty* p : {actor->GetProperty(), actor->GetBackfaceProperty()}) {
    p->SetEdgeVisibility(m_shading == Shading::ShadedWithEdges);
    p->SetEdgeColor(m_colours.edge.redF(), m_colours.edge.greenF(), m_colours.edge.blueF());
    p->SetLineWidth(static_cast<float>(m_pixelRatio));
    if (m_shading == Shading::Wireframe) {
      p->SetRepresentationToWireframe();
      p->LightingOff();
      p->SetColor(m_colours.wire.redF(), m_colours.wire.greenF(), m_colours.wire.blueF());
    } else {
      p->SetRepresentationToSurface();
      p->LightingOn();
    }
  }
}

void MeshBlocks::styleAll() {
  for (const auto& actor : m_blocks) {
    if (actor) style(actor);
  }
  if (m_coarse) style(m_coarse);
}

void MeshBlocks::setShading(Shading shading) {
  m_shading = shading;
  styleAll();
}

void MeshBlocks::setColours(const SceneColours& colours) {
  m_colours = colours;
  styleAll();
}

void MeshBlocks::setPixelRatio(double ratio) {
  if (ratio == m_pixelRatio) return;
  m_pixelRatio = ratio;
  styleAll();
}

}  // namespace handwheel

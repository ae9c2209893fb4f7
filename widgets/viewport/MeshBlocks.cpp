// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/MeshBlocks.h"

#include "viewport/PolyData.h"

#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <algorithm>

namespace handwheel {

MeshBlocks::MeshBlocks(vtkRenderer* renderer) : m_renderer(renderer) {}

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

std::size_t MeshBlocks::takeOne() {
  if (m_queue.empty()) return 0;
  const Pending next = std::move(m_queue.front());
  m_queue.pop_front();
  if (next.block >= m_blocks.size()) m_blocks.resize(next.block + 1);
  auto& actor = m_blocks[next.block];
  if (actor) m_renderer->RemoveActor(actor);
  actor = makeActor(next.geometry);
  actor->SetVisibility(!m_reduced || !m_coarse);
  ++m_built;
  return std::max<std::size_t>(next.geometry.indices.size() / 3, 1);
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
  applyStyle(actor, m_style, {m_style.colours.front});
}

void MeshBlocks::setStyle(const SurfaceStyle& style) {
  m_style = style;
  for (const auto& actor : m_blocks) {
    if (actor) this->style(actor);
  }
  if (m_coarse) this->style(m_coarse);
}

}  // namespace handwheel

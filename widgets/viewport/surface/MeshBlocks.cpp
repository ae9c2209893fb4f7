// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/MeshBlocks.h"

#include "viewport/surface/PolyData.h"

#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <algorithm>
#include <limits>

namespace handwheel {

namespace {

vtkSmartPointer<vtkScalarsToColors> colourMapOf(const ColourScale& scale) {
  constexpr int kColours = 1024;
  const auto map = vtkSmartPointer<vtkLookupTable>::New();
  map->SetNumberOfTableValues(kColours);
  map->SetTableRange(-scale.range, scale.range);
  for (int i = 0; i < kColours; ++i) {
    const QColor c = scale.at(scale.range * (2.0 * (i + 0.5) / kColours - 1.0));
    map->SetTableValue(i, c.redF(), c.greenF(), c.blueF());
  }
  const QColor unknown = scale.at(std::numeric_limits<double>::quiet_NaN());
  map->SetNanColor(unknown.redF(), unknown.greenF(), unknown.blueF(), 1.0);
  return map;
}

}  // namespace

MeshBlocks::MeshBlocks(LayerProps& props) : m_props(props) {}

void MeshBlocks::clear() {
  for (const auto& actor : m_blocks) {
    if (actor) m_props.remove(actor);
  }
  m_blocks.clear();
  m_queue.clear();
  m_toColour.clear();
  setCoarse(std::nullopt);
}

void MeshBlocks::enqueue(std::size_t block, SurfaceGeometry geometry) {
  m_queue.push_back({block, std::move(geometry)});
}

std::size_t MeshBlocks::takeOne() {
  if (m_queue.empty()) return colourOne();
  const Pending next = std::move(m_queue.front());
  m_queue.pop_front();
  if (next.block >= m_blocks.size()) m_blocks.resize(next.block + 1);
  auto& actor = m_blocks[next.block];
  if (actor) m_props.remove(actor);
  actor = makeActor(next.geometry);
  m_props.show(actor, !m_reduced || !m_coarse);
  ++m_built;
  return std::max<std::size_t>(next.geometry.indices.size() / 3, 1);
}

void MeshBlocks::setCoarse(std::optional<SurfaceGeometry> geometry) {
  if (m_coarse) m_props.remove(m_coarse);
  m_coarse = geometry ? makeActor(*geometry) : nullptr;
  updateVisibility();
}

void MeshBlocks::setCoarseShown(bool reduced) {
  if (reduced == m_reduced) return;
  m_reduced = reduced;
  updateVisibility();
}

void MeshBlocks::updateVisibility() {
  const bool showCoarse = m_reduced && m_coarse;
  if (m_coarse) m_props.show(m_coarse, showCoarse);
  for (const auto& actor : m_blocks) {
    if (actor) m_props.show(actor, !showCoarse);
  }
}

vtkSmartPointer<vtkActor> MeshBlocks::makeActor(const SurfaceGeometry& geometry) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(toPolyData(geometry));
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->PickableOff();
  colour(actor);
  actor->SetPosition(m_offset.x(), m_offset.y(), m_offset.z());
  m_props.add(actor);
  return actor;
}

void MeshBlocks::style(vtkActor* actor) const {
  const bool isColoured = actor->GetMapper()->GetScalarVisibility();
  applyStyle(actor, m_style, {.front = m_style.colours.front, .gloss = isColoured ? 0.0 : SurfaceMaterial().gloss});
  keepInnerSide(actor, isColoured);
}

void MeshBlocks::colour(vtkActor* actor) const {
  auto* mapper = static_cast<vtkPolyDataMapper*>(actor->GetMapper());
  const bool isColoured = m_colourMap && mapper->GetInput()->GetPointData()->GetScalars();
  mapper->SetScalarVisibility(isColoured);
  style(actor);
  if (!isColoured) return;
  mapper->SetInterpolateScalarsBeforeMapping(true);  // colours by value within triangles too
  mapper->SetUseLookupTableScalarRange(true);
  mapper->SetLookupTable(m_colourMap);
}

std::size_t MeshBlocks::colourOne() {
  if (m_toColour.empty()) return 0;
  vtkActor* actor = m_blocks[m_toColour.front()];
  m_toColour.pop_front();
  if (!actor) return 1;
  colour(actor);
  const auto triangles = static_cast<vtkPolyDataMapper*>(actor->GetMapper())->GetInput()->GetNumberOfPolys();
  return std::max<std::size_t>(static_cast<std::size_t>(triangles), 1);
}

// Blocks that wait already keep their position in the queue, so that all have their turn while a scale is being
// dragged.
void MeshBlocks::setColourScale(const std::optional<ColourScale>& scale) {
  if (!scale && !m_colourMap) return;
  m_colourMap = scale ? colourMapOf(*scale) : nullptr;
  if (m_coarse) colour(m_coarse);
  for (std::size_t b = 0; b < m_blocks.size(); ++b) {
    if (std::find(m_toColour.begin(), m_toColour.end(), b) == m_toColour.end()) m_toColour.push_back(b);
  }
}

void MeshBlocks::setOffset(const Vec3& offset) {
  if (offset == m_offset) return;
  m_offset = offset;
  for (const auto& actor : m_blocks) {
    if (actor) actor->SetPosition(offset.x(), offset.y(), offset.z());
  }
  if (m_coarse) m_coarse->SetPosition(offset.x(), offset.y(), offset.z());
}

void MeshBlocks::setStyle(const SurfaceStyle& style) {
  m_style = style;
  for (const auto& actor : m_blocks) {
    if (actor) this->style(actor);
  }
  if (m_coarse) this->style(m_coarse);
}

}  // namespace handwheel

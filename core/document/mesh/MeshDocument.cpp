// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/MeshDocument.h"

#include "document/mesh/KeepOpenEdit.h"
#include "document/mesh/MeshEdit.h"
#include "document/mesh/ReversalEdit.h"
#include "mesh/measure/MeshFidelity.h"

#include <algorithm>

namespace handwheel {

MeshDocument::MeshDocument(OpenedFile opened, QObject* parent)
    : Document(*opened.kind, std::move(opened.file), parent) {
  const auto& content = static_cast<const MeshSnapshot&>(*opened.content);
  m_build = content.build;
  m_numbers = content.numbers;
  m_mesh = content.mesh.mesh;
  m_defects = content.mesh.defects;
  m_keptOpen = content.keptOpen;
  m_reversedFaces = m_build->reversedFaces;
  if (content.asInFile) beginWithReversal(*content.asInFile);
  if (content.levels) keepLevels(*content.levels);
  m_fillChoice = content.fillChoice;
}

void MeshDocument::beginWithReversal(const InspectedMesh& asInFile) {
  auto reversal = std::make_unique<ReversalEdit>(MeshDelta::between(asInFile.mesh, m_mesh),
                                                 DefectsDelta::between(*asInFile.defects, *m_defects));
  m_mesh = asInFile.mesh;
  m_defects = asInFile.defects;
  m_wasOpenedReversed = m_hasFileDirections = true;
  beginHistory(tr("Triangles reversed on opening: %1").arg(m_build->reversedFaces.size()), std::move(reversal));
}

std::vector<Face> MeshDocument::facesAsInFile() const {
  return m_hasFileDirections ? m_build->reversedFaces : std::vector<Face>();
}

NumberType MeshDocument::fileNumbers() const {
  const auto format = formatForName(file().path);
  return format ? numberTypeOf(*format, m_numbers) : m_numbers;
}

SnapshotPointer MeshDocument::snapshot() const {
  auto snapshot = std::make_shared<MeshSnapshot>();
  snapshot->mesh = {m_mesh, m_defects};
  snapshot->build = m_build;
  if (m_hasFileDirections) {
    auto build = std::make_shared<BuildReport>(*m_build);
    build->reversedFaces.clear();
    snapshot->build = std::move(build);
  }
  snapshot->keptOpen = m_keptOpen;
  snapshot->numbers = m_numbers;
  if (const PatchLevels* found = levels()) snapshot->levels = std::make_shared<const PatchLevels>(*found);
  snapshot->fillChoice = m_fillChoice;
  return snapshot;
}

std::vector<Property> MeshDocument::properties() const {
  std::vector<Property> all;
  const auto add = [&all](const char* id, const char* label, double value, Quantity quantity) {
    Property property;
    property.id = id;
    property.group = QT_TRANSLATE_NOOP("Property", "Mesh");
    property.label = label;
    property.value = value;
    property.quantity = quantity;
    property.editable = false;
    all.push_back(std::move(property));
  };
  std::size_t faces = 0;
  double area = 0.0, volume = 0.0;
  for (const Component& part : m_defects->components) {
    faces += part.faceCount;
    area += part.area;
    volume += part.volume;
  }
  add("triangles", QT_TRANSLATE_NOOP("Property", "Triangles"), static_cast<double>(faces), Quantity::Number);
  add("parts", QT_TRANSLATE_NOOP("Property", "Pieces"), static_cast<double>(m_defects->components.size()),
      Quantity::Number);
  const Vec3 size = m_defects->box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(m_defects->box.sizes());
  add("size_x", QT_TRANSLATE_NOOP("Property", "Size in X"), size.x(), Quantity::Length);
  add("size_y", QT_TRANSLATE_NOOP("Property", "Size in Y"), size.y(), Quantity::Length);
  add("size_z", QT_TRANSLATE_NOOP("Property", "Size in Z"), size.z(), Quantity::Length);
  add("area", QT_TRANSLATE_NOOP("Property", "Surface area (mm²)"), area, Quantity::Number);
  // A cavity is taken off, as its faces look inward. A body inside another is added, as in slicers, which is said.
  const char* const label = m_defects->nestedBodies == 0
                                ? QT_TRANSLATE_NOOP("Property", "Volume (mm³)")
                                : QT_TRANSLATE_NOOP("Property", "Volume of all bodies added up (mm³)");
  if (const MeshState state = m_defects->state({}); state.closed && state.oriented)
    add("volume", label, volume, Quantity::Number);
  for (Property& common : Document::properties()) all.push_back(std::move(common));
  return all;
}

bool MeshDocument::commit(const QString& text, const InspectedMesh& after, std::string step) {
  const auto runSlots = static_cast<std::size_t>(m_fidelity.of(undoGranularitySetting()));
  MeshDelta delta = MeshDelta::between(m_mesh, after.mesh, runSlots);
  if (delta.isEmpty()) return false;  // not even pushed as obsolete: that would cost the user the steps to redo
  commit(text, std::make_unique<MeshEdit>(std::move(delta), DefectsDelta::between(*m_defects, *after.defects)),
         DragPhase::Ends, std::move(step));
  return true;
}

bool MeshDocument::isKeptOpen(const BoundaryLoop& loop) const {
  return m_keptOpen.contains(keyOf(m_mesh, loop));
}

void MeshDocument::setKeptOpen(const BoundaryLoop& loop, bool keep) {
  if (isKeptOpen(loop) == keep) return;
  const Vertex key = keyOf(m_mesh, loop);
  commit(keep ? tr("Keep open") : tr("No longer keep open"), std::make_unique<KeepOpenEdit>(key, keep), DragPhase::Ends,
         (keep ? "keep-open v" : "no-longer-open v") + std::to_string(key));
}

void MeshDocument::meshWasChanged(const std::vector<Face>& touched) {
  m_reversedFaces.clear();
  if (!m_hasFileDirections)
    std::copy_if(m_build->reversedFaces.begin(), m_build->reversedFaces.end(), std::back_inserter(m_reversedFaces),
                 [this](Face f) { return m_mesh.isLive(f); });
  countChange();
  emit meshChanged(touched);
  emit changed();
}

}  // namespace handwheel

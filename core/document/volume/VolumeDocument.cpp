// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/VolumeDocument.h"

#include "base/NumberText.h"

#include <QtGlobal>

namespace handwheel {

VolumeDocument::VolumeDocument(OpenedFile opened, QObject* parent)
    : Document(*opened.kind, std::move(opened.file), parent),
      m_volume(std::static_pointer_cast<const VolumeSnapshot>(opened.content)),
      m_scan(m_volume->scan),
      m_segment(m_volume->segment) {}

std::shared_ptr<const VolumeSnapshot> VolumeDocument::withScan(
    const std::shared_ptr<const VolumeSnapshot>& volume) const {
  if (!m_scan || (volume->scan == m_scan && volume->segment == m_segment)) return volume;
  auto whole = std::make_shared<VolumeSnapshot>(*volume);
  whole->scan = m_scan;
  whole->segment = m_segment;
  return whole;
}

std::vector<Property> VolumeDocument::properties() const {
  const SparseVolume& volume = m_volume->volume;
  const std::string group = QT_TRANSLATE_NOOP("Property", "Volume");
  std::vector<Property> all;
  const auto add = [&](std::string id, std::string label, PropertyValue value, Quantity quantity) {
    Property property{std::move(id), group, std::move(label), std::move(value), quantity};
    property.editable = false;
    all.push_back(std::move(property));
  };
  add("voxel", QT_TRANSLATE_NOOP("Property", "Voxel"), volume.voxel(), Quantity::Length);
  add("material", QT_TRANSLATE_NOOP("Property", "Material (mm³)"), volume.material(), Quantity::Number);
  add("triangles", QT_TRANSLATE_NOOP("Property", "Triangles"), static_cast<double>(m_volume->surface.triangleCount()),
      Quantity::Number);
  add("memory", QT_TRANSLATE_NOOP("Property", "Memory (MB)"), static_cast<double>(volume.bytes()) / 1e6,
      Quantity::Number);
  add("source", QT_TRANSLATE_NOOP("Property", "Made from"), m_volume->source, Quantity::Number);
  for (Property& common : Document::properties()) all.push_back(std::move(common));
  return all;
}

}  // namespace handwheel

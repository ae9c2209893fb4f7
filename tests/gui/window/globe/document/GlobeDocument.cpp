// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "globe/document/GlobeDocument.h"

namespace handwheel::test {

SnapshotPointer globe(double radius) {
  return std::make_shared<const GlobeSnapshot>(GlobeSurface(radius));
}

const GlobeSurface& surfaceOf(const Snapshot& content) {
  return static_cast<const GlobeSnapshot&>(content).surface;
}

GlobeDocument::GlobeDocument(OpenedFile opened)
    : Document(*opened.kind, std::move(opened.file)), m_content(std::move(opened.content)) {}

std::vector<Property> GlobeDocument::properties() const {
  std::vector<Property> all{{.id = "radius",
                             .group = "Globe",
                             .label = "Radius",
                             .value = surface().radius(),
                             .quantity = Quantity::Length,
                             .least = kLeastRadius,
                             .largest = kLargestRadius}};
  for (Property& common : Document::properties()) all.push_back(std::move(common));
  return all;
}

Result<std::unique_ptr<Edit>> GlobeDocument::propertyEdit(const std::string& id, const PropertyValue& value) const {
  if (id != "radius") return Document::propertyEdit(id, value);
  const double radius = std::get<double>(value);
  if (radius == surface().radius()) return std::unique_ptr<Edit>();
  return std::unique_ptr<Edit>(std::make_unique<GlobeEdit>(surface().withRadius(radius)));
}

void GlobeEdit::exchange(Document& document) {
  auto& owner = static_cast<GlobeDocument&>(document);
  GlobeSurface former = owner.surface();
  owner.m_content = std::make_shared<const GlobeSnapshot>(std::exchange(m_surface, std::move(former)));
  owner.wasChanged();
}

}  // namespace handwheel::test

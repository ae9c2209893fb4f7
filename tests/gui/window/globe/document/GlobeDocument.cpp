// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "globe/document/GlobeDocument.h"

#include "document/scene/BodyChanges.h"
#include "document/scene/BodyProperties.h"

namespace handwheel::test {

namespace {

BodyPointer bodyOf(BodyId id, const char* name, const Vec3& position, const GlobeSurface& points) {
  Body body;
  body.id = id;
  body.name = name;
  body.pose.translation() = position;
  body.geometry = std::make_shared<const GlobeGeometry>(points);
  return std::make_shared<const Body>(std::move(body));
}

Body withPoints(Body body, GlobeSurface points) {
  body.geometry = std::make_shared<const GlobeGeometry>(std::move(points));
  return body;
}

}  // namespace

BodySet globeBodies(const GlobeSurface& points) {
  const double r = points.radius();
  return BodySet()
      .with(bodyOf(kGlobeBody, "globe", Vec3::Zero(), points))
      .with(bodyOf(kMoonBody, "moon", {0, 1.5 * r, 0}, GlobeSurface(0.25 * r)));
}

SnapshotPointer globe(double radius) {
  return std::make_shared<const GlobeSnapshot>(globeBodies(GlobeSurface(radius)));
}

const BodySet& bodiesOf(const Snapshot& content) {
  return static_cast<const GlobeSnapshot&>(content).bodies;
}

const GlobeSurface& pointsOf(const Body& body) {
  return static_cast<const GlobeGeometry&>(*body.geometry).points();
}

BodySet withGlobe(const BodySet& bodies, GlobeSurface points) {
  return bodies.with(std::make_shared<const Body>(withPoints(*bodies.withId(kGlobeBody), std::move(points))));
}

GlobeDocument::GlobeDocument(OpenedFile opened)
    : Document(*opened.kind, std::move(opened.file)), BodyOwner(bodiesOf(*opened.content)) {}

std::vector<Property> GlobeDocument::properties() const {
  std::vector<Property> all{{.id = "radius",
                             .group = "Globe",
                             .label = "Radius",
                             .value = surface().radius(),
                             .quantity = Quantity::Length,
                             .least = kLeastRadius,
                             .largest = kLargestRadius}};
  for (Property& each : bodyProperties(bodies())) all.push_back(std::move(each));
  for (Property& common : Document::properties()) all.push_back(std::move(common));
  return all;
}

Result<std::unique_ptr<Edit>> GlobeDocument::propertyEdit(const std::string& id, const PropertyValue& value) const {
  if (bodyOfProperty(id)) return bodyPropertyEdit(bodies(), id, value);
  if (id != "radius") return Document::propertyEdit(id, value);
  return surfaceEdit(surface().withRadius(std::get<double>(value)));
}

std::unique_ptr<Edit> GlobeDocument::surfaceEdit(GlobeSurface points) const {
  if (points == surface()) return nullptr;
  auto edit = changeBodyEdit(bodies(), withPoints(*bodies().withId(kGlobeBody), std::move(points)));
  return std::move(edit).value();
}

}  // namespace handwheel::test

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Document.h"
#include "document/scene/BodyOwner.h"
#include "globe/document/GlobeGeometry.h"

// A globe of points and its moon, a kind of document for tests only.
namespace handwheel::test {

// Ids of the two bodies.
inline constexpr BodyId kGlobeBody = 1, kMoonBody = 2;

struct GlobeSnapshot : Snapshot {
  explicit GlobeSnapshot(BodySet b) : bodies(std::move(b)) {}
  BodySet bodies;
};

// Returns a globe at the origin and its moon.
BodySet globeBodies(const GlobeSurface& points);
// Returns the content of a document with a globe of this radius, mm, without dents.
SnapshotPointer globe(double radius);

const BodySet& bodiesOf(const Snapshot& content);
const GlobeSurface& pointsOf(const Body& body);
inline const GlobeSurface& surfaceOf(const Snapshot& content) {
  return pointsOf(*bodiesOf(content).withId(kGlobeBody));
}
inline double radiusOf(const Snapshot& content) {
  return surfaceOf(content).radius();
}
// Returns the bodies with the surface of the globe replaced.
BodySet withGlobe(const BodySet& bodies, GlobeSurface points);

class GlobeDocument : public Document, public BodyOwner {
 public:
  explicit GlobeDocument(OpenedFile opened);

  SnapshotPointer snapshot() const override { return std::make_shared<const GlobeSnapshot>(bodies()); }
  const GlobeSurface& surface() const { return pointsOf(*bodies().withId(kGlobeBody)); }
  const Pose& pose() const { return bodies().withId(kGlobeBody)->pose; }
  std::vector<Property> properties() const override;
  Result<std::unique_ptr<Edit>> propertyEdit(const std::string& id, const PropertyValue& value) const override;
  // Returns an edit that gives the globe these points, or null if the globe already has them.
  std::unique_ptr<Edit> surfaceEdit(GlobeSurface points) const;

 private:
  void bodiesChanged() override { wasChanged(); }
};

}  // namespace handwheel::test

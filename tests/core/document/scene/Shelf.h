// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Document.h"
#include "document/DocumentErrors.h"
#include "document/DocumentKind.h"
#include "document/mesh/MeshKind.h"
#include "document/scene/BodyBlobs.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyErrors.h"
#include "document/scene/BodyLinks.h"
#include "document/scene/BodyOwner.h"
#include "document/scene/BodyProperties.h"
#include "scene/MeshGeometry.h"
#include "scene/PrimitiveGeometry.h"
#include "scene/RevolvedGeometry.h"
#include "scene/RigidPose.h"

#include <rapidcheck.h>
#include <nlohmann/json.hpp>
#include <stdexcept>

// A kind of document that holds bodies and nothing else.
namespace handwheel::test {

struct ShelfSnapshot : Snapshot {
  BodySet bodies;
};

inline SnapshotPointer shelf(BodySet bodies) {
  auto snapshot = std::make_shared<ShelfSnapshot>();
  snapshot->bodies = std::move(bodies);
  return snapshot;
}

inline const BodySet& bodiesOf(const Snapshot& content) {
  return static_cast<const ShelfSnapshot&>(content).bodies;
}

class ShelfDocument : public Document, public BodyOwner {
 public:
  explicit ShelfDocument(OpenedFile opened)
      : Document(*opened.kind, std::move(opened.file)), BodyOwner(bodiesOf(*opened.content)) {}
  SnapshotPointer snapshot() const override { return shelf(bodies()); }
  std::vector<Property> properties() const override {
    std::vector<Property> all = bodyProperties(bodies());
    for (Property& common : Document::properties()) all.push_back(std::move(common));
    return all;
  }
  Result<std::unique_ptr<Edit>> propertyEdit(const std::string& id, const PropertyValue& value) const override {
    return bodyOfProperty(id) ? bodyPropertyEdit(bodies(), id, value) : Document::propertyEdit(id, value);
  }

 private:
  void bodiesChanged() override { wasChanged(); }
};

class ShelfKind : public DocumentKind {
 public:
  std::string id() const override { return "shelf"; }
  std::string title() const override { return "Shelf"; }
  std::vector<FileFormat> formats() const override { return {}; }
  bool recognises(std::string_view, std::string_view) const override { return false; }
  Result<OpenedFile> import(const std::filesystem::path&, const ReadOptions&, Progress) const override {
    return Error{ErrorCode::Unsupported, {}, {}, {}};
  }
  Result<WrittenFile> exportTo(const Snapshot&, const std::filesystem::path&, Progress) const override {
    return Error{DocumentError::ExtensionUnknown, {}, {}, {}};
  }
  void save(const Snapshot& content, Container& container) const override {
    writeBodies(bodiesOf(content), "shelf", container);
  }
  Result<SnapshotPointer> load(const Container& container, std::vector<Error>& damage,
                               Progress progress) const override {
    auto bodies = readBodies(container, "shelf", damage, progress);
    if (!bodies) return bodies.error();
    return shelf(*bodies);
  }
  SnapshotPointer withCheckedLinks(SnapshotPointer content, const std::filesystem::path& folder,
                                   std::vector<Note>& notes, Progress progress) const override {
    return shelf(withCheckedBodyLinks(bodiesOf(*content), folder, notes, progress));
  }
  SnapshotPointer blank() const override { return shelf({}); }
  std::unique_ptr<Document> make(OpenedFile opened) const override {
    return std::make_unique<ShelfDocument>(std::move(opened));
  }
  nlohmann::json describe(const Snapshot&) const override { return {}; }
  DisplayModel display(const Snapshot& content) const override {
    DisplayModel model;
    for (const BodyPointer& body : bodiesOf(content)) {
      DisplayPart part;
      part.name = body->name;
      part.soup = body->geometry->surface();
      part.pose = body->pose;
      model.parts.push_back(std::move(part));
    }
    return model;
  }
};

inline const DocumentKinds& kinds() {
  static const DocumentKinds all = [] {
    std::vector<std::unique_ptr<DocumentKind>> list;
    list.push_back(std::make_unique<ShelfKind>());
    list.push_back(std::make_unique<MeshKind>());
    return DocumentKinds(std::move(list));
  }();
  return all;
}

inline std::unique_ptr<ShelfDocument> newShelf() {
  return std::make_unique<ShelfDocument>(DocumentKinds::blank(*kinds().withId("shelf")));
}

template <class T>
T valueOf(Result<T> result) {
  if (!result) throw std::runtime_error(std::string("error ") + result.error().code->id);
  return std::move(result).value();
}

inline TriangleSoup tetrahedron(double size = 10.0) {
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
  soup.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return soup;
}

inline GeometryPointer cube(double size = 10.0) {
  return valueOf(PrimitiveGeometry::make(Primitive::Cuboid, {size, size, size}));
}

inline Body body(const std::string& name, GeometryPointer geometry = cube()) {
  return {.name = name, .geometry = std::move(geometry)};
}

inline void add(ShelfDocument& document, Body added) {
  document.commit("Add", valueOf(addBodyEdit(document.bodies(), std::move(added))));
}

// Returns the file that these bytes contain, with the damage and notes found by reading.
inline OpenedFile opened(const std::string& bytes) {
  return valueOf(kinds().openContainer(bytes));
}

inline std::string saved(const OpenedFile& file) {
  return valueOf(containerBytes(*file.kind, file.file, *file.content, {}, Compression::Fast));
}

inline OpenedFile shelfWith(BodySet bodies) {
  OpenedFile file = DocumentKinds::blank(*kinds().withId("shelf"));
  file.content = shelf(std::move(bodies));
  return file;
}

inline BodySet with(const BodySet& bodies, Body added) {
  added.id = bodies.freeId();
  return bodies.with(std::make_shared<const Body>(std::move(added)));
}

inline double anyLength(double most = 1e4) {
  return *rc::gen::inRange(-1'000'000, 1'000'001) * 1e-6 * most;
}

inline Pose anyPose() {
  return poseOf({anyLength(), anyLength(), anyLength()}, {anyLength(3.1), anyLength(1.5), anyLength(3.1)});
}

inline GeometryPointer anyGeometry() {
  const auto size = [] { return *rc::gen::inRange(1, 100'000) / 997.0; };
  const int which = *rc::gen::inRange(0, 6);
  if (which == 0) return std::make_shared<const MeshGeometry>(tetrahedron(size()));
  if (which == 1) {
    const double height = size();
    auto profile = ProfileCurve::polyline({{size(), 0.0}, {size(), height}, {size(), 2 * height}});
    return valueOf(RevolvedGeometry::make(valueOf(std::move(profile)), 0.5));
  }
  const PrimitiveDescription& primitive = primitives()[std::size_t(which - 2)];
  std::vector<double> dimensions;
  for (std::size_t i = 0; i < primitive.dimensions.size(); ++i) dimensions.push_back(size());
  return valueOf(PrimitiveGeometry::make(primitive.primitive, dimensions));
}

inline Body anyBody(const BodySet& others) {
  Body made = body(freeBodyName(others, *rc::gen::element<std::string>("vice", "Tür", "a b", "x")), anyGeometry());
  made.pose = anyPose();
  for (float& level : made.look.colour) level = *rc::gen::inRange(0, 256) / 255.0f;
  made.look.smooth = *rc::gen::arbitrary<bool>();
  made.visible = *rc::gen::arbitrary<bool>();
  if (*rc::gen::arbitrary<bool>())
    made.link = BodyLink{"/parts/" + made.name + ".stl", *rc::gen::element<std::string>("", "a.stl"), "0123abcd"};
  return made;
}

}  // namespace handwheel::test

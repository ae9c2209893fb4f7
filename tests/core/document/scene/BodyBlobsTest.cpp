// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/container/ArchiveErrors.h"
#include "document/scene/BodyBlobs.h"

#include "Shelf.h"
#include "TestClass.h"
#include "scene/UnknownGeometry.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

bool isSameShape(const BodyGeometry& a, const BodyGeometry& b) {
  if (a.kind() != b.kind()) return false;
  if (const auto* p = dynamic_cast<const PrimitiveGeometry*>(&a)) {
    const auto& q = dynamic_cast<const PrimitiveGeometry&>(b);
    return p->primitive() == q.primitive() && p->dimensions() == q.dimensions();
  }
  if (const auto* r = dynamic_cast<const RevolvedGeometry*>(&a)) {
    const auto& s = dynamic_cast<const RevolvedGeometry&>(b);
    const ProfileNurbs &m = r->profile().nurbs(), &n = s.profile().nurbs();
    return r->chord() == s.chord() && m.degree == n.degree && m.knots == n.knots && m.poles == n.poles &&
           m.weights == n.weights;
  }
  return a.surface()->points == b.surface()->points && a.surface()->triangles == b.surface()->triangles;
}

bool isSame(const BodySet& a, const BodySet& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const BodyPointer& x, const BodyPointer& y) {
    Body other = *y;
    other.geometry = x->geometry;  // compared by its value
    return *x == other && isSameShape(*x->geometry, *y->geometry);
  });
}

// With a body of a kind that only a newer program knows.
std::string withVoxels() {
  Container container = valueOf(readContainer(saved(shelfWith(with({}, body("vice")))))).container;
  nlohmann::json& entry = (*container.manifest)["document"]["bodies"]["0001"];
  entry["geometry"] = {{"kind", "voxels"}, {"spacing", 0.5}, {"deep", {{"er", {1, 2, 3}}}}};
  entry["glow"] = "green";
  container.blobs["shelf/bodies/0001/grid/0000"] = "12345678";
  return valueOf(writeContainer(container, Compression::Fast));
}

}  // namespace

class BodyBlobsTest : public QObject {
  Q_OBJECT

 private slots:
  void saveAndLoad() {
    QVERIFY(rc::check("save and load", [] {
      BodySet bodies;
      for (int i = *rc::gen::inRange(0, 6); i > 0; --i) bodies = with(bodies, anyBody(bodies));
      if (!bodies.empty() && *rc::gen::arbitrary<bool>()) bodies = bodies.without((*bodies.begin())->id);
      const OpenedFile again = opened(saved(shelfWith(bodies)));
      RC_ASSERT(again.file.damage.empty());
      RC_ASSERT(isSame(bodiesOf(*again.content), bodies));
      RC_ASSERT(bodiesOf(*again.content).freeId() == bodies.freeId());
      RC_ASSERT(saved(again) == saved(opened(saved(again))));
    }));
  }

  void unknownShapesAreKept() {
    const OpenedFile read = opened(withVoxels());
    const BodyPointer vice = bodiesOf(*read.content).withName("vice");
    QVERIFY(vice && !vice->geometry->isKnown());
    QCOMPARE(vice->geometry->kind(), "voxels");
    QVERIFY(read.file.damage.empty());  // so that the file can be replaced

    // Moved and saved, its shape is as it was.
    const auto document = read.kind->make(read);
    QVERIFY(document->setProperty("body.1.x", 7.0).hasValue());
    const Container after = valueOf(readContainer(valueOf(containerBytes(
                                        *read.kind, document->file(), *document->snapshot(), {}, Compression::Fast))))
                                .container;
    const nlohmann::json& entry = (*after.manifest)["document"]["bodies"]["0001"];
    QCOMPARE(entry["pose"][3].get<double>(), 7.0);
    QCOMPARE(entry["glow"].get<std::string>(), "green");
    QVERIFY(entry["geometry"] == nlohmann::json({{"kind", "voxels"}, {"spacing", 0.5}, {"deep", {{"er", {1, 2, 3}}}}}));
    QCOMPARE(after.blobs.at("shelf/bodies/0001/grid/0000"), "12345678");
  }

  void aRemovedBodyLeavesNothing() {
    const OpenedFile read = opened(withVoxels());
    const auto document = read.kind->make(read);
    const BodyId ids[] = {1};
    document->commit("Remove", removeBodiesEdit(bodiesOf(*read.content), ids));
    const Container after = valueOf(readContainer(valueOf(containerBytes(
                                        *read.kind, document->file(), *document->snapshot(), {}, Compression::Fast))))
                                .container;
    QVERIFY((*after.manifest)["document"]["bodies"].empty());
    QCOMPARE((*after.manifest)["document"]["next_body"].get<int>(), 2);
    QVERIFY(after.blobs.empty());
  }

  void longMeshesAreCutIntoBlobs() {
    TriangleSoup soup;
    for (int i = 0; i < 70'000; ++i) soup.points.emplace_back(i, i % 7, i % 11);
    for (std::uint32_t i = 0; i + 2 < 70'000; ++i) soup.triangles.push_back({i, i + 1, i + 2});
    const OpenedFile file = shelfWith(with({}, body("scan", std::make_shared<const MeshGeometry>(soup))));
    Container container;
    file.kind->save(*file.content, container);
    QVERIFY(container.blobs.contains("shelf/bodies/0001/points/0001"));
    // Without one of them the rest is there.
    container.blobs.erase("shelf/bodies/0001/triangles/0001");
    std::vector<Error> damage;
    const BodySet read = valueOf(readBodies(container, "shelf", damage, {}));
    QCOMPARE(damage.size(), std::size_t{1});
    QCOMPARE(damage[0].code, ArchiveError::EntryDamaged);
    QCOMPARE(read.withId(1)->geometry->surface()->triangles.size(), std::size_t{65'536});
  }
};

HANDWHEEL_TEST(BodyBlobsTest)
#include "BodyBlobsTest.moc"

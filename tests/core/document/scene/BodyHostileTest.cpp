// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Shelf.h"
#include "TestClass.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <set>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using nlohmann::json;

struct Read {
  BodySet bodies;
  std::vector<Error> damage;
};

Read readList(const json& list, const Container& blobs = {}) {
  Container container = blobs;
  (*container.manifest)["document"]["bodies"] = list;
  Read result;
  result.bodies = valueOf(readBodies(container, "shelf", result.damage, {}));
  return result;
}

json entry(const std::string& name) {
  return {{"name", name},
          {"pose", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}},
          {"geometry", {{"kind", "primitive"}, {"shape", "sphere"}, {"dimensions", {5.0}}}}};
}

// Returns true if the invariants of every opened document hold.
bool isSound(const BodySet& bodies) {
  std::set<std::string> names;
  std::set<BodyId> ids;
  for (const BodyPointer& each : bodies) {
    if (!each->geometry || !isRigid(each->pose) || !isBodyName(each->name)) return false;
    if (each->id == 0 || each->id >= bodies.freeId()) return false;
    for (const Vec3& p : each->geometry->surface()->points) {
      if (!p.allFinite()) return false;
    }
    names.insert(each->name);
    ids.insert(each->id);
  }
  return names.size() == bodies.size() && ids.size() == bodies.size();
}

// Something that does not belong there.
json anyWrong() {
  return *rc::gen::element<json>(nullptr, true, -1, 1e300, "", "\u0007", std::string(300, 'a'), json::array(),
                                 json::object(), json::array({1, 2, 3}), 4294967295u, 18446744073709551615u,
                                 json::array({1e300, nullptr, "x"}));
}

void spoil(json& value) {
  if (value.is_structured() && !value.empty() && *rc::gen::inRange(0, 4) > 0) {
    auto at = value.begin();
    std::advance(at, *rc::gen::inRange<long>(0, long(value.size())));
    if (*rc::gen::inRange(0, 5) == 0)
      value.erase(at);
    else
      spoil(*at);
    return;
  }
  value = anyWrong();
}

}  // namespace

class BodyHostileTest : public QObject {
  Q_OBJECT

 private slots:
  void anyDamageLeavesASoundDocument() {
    QVERIFY(rc::check("spoilt files", [] {
      BodySet bodies;
      for (int i = *rc::gen::inRange(1, 4); i > 0; --i) bodies = with(bodies, anyBody(bodies));
      Container container;
      ShelfKind().save(*shelf(bodies), container);
      for (int i = *rc::gen::inRange(1, 4); i > 0; --i) spoil((*container.manifest)["document"]);
      for (auto& [name, bytes] : container.blobs) {
        const int what = *rc::gen::inRange(0, 4);
        if (what == 0) bytes.resize(bytes.size() / 2);
        if (what == 1) bytes.assign(bytes.size(), *rc::gen::element('\xff', '\x7f', '\0'));
      }
      std::vector<Error> damage;
      const auto read = readBodies(container, "shelf", damage, {});
      RC_ASSERT(read.hasValue());
      RC_ASSERT(isSound(*read));
    }));
  }

  void namesAndNumbersAreMended() {
    const Read read = readList({{"0001", entry("vice")},
                                {"1", entry("vice")},
                                {"0003", entry("")},
                                {"x", entry("y")},
                                {"99999999999999999999", entry("far")},
                                {"4294967295", entry("last")}});
    QCOMPARE(read.bodies.size(), std::size_t{6});
    QVERIFY(isSound(read.bodies));
    QVERIFY(read.damage.empty());
    QVERIFY(read.bodies.withName("vice") && read.bodies.withName("vice 2") && read.bodies.withName("body 3"));
    QVERIFY(read.bodies.freeId() < 20);
  }

  void lists() {
    for (const json& wrong : {json(1), json::array({1, 2}), json("x"), json(true)}) {
      const Read read = readList(wrong);
      QVERIFY(read.bodies.empty() && read.damage.size() == 1);
    }
    const Read nested = readList({{"0001", entry("a")}, {"0001/points", entry("b")}});
    QCOMPARE(nested.bodies.size(), std::size_t{1});
    QCOMPARE(nested.damage.size(), std::size_t{1});
    const Read mixed = readList({{"0001", 5}, {"0002", entry("a")}, {"0003", nullptr}});
    QCOMPARE(mixed.bodies.size(), std::size_t{1});
    QCOMPARE(mixed.damage.size(), std::size_t{2});
  }

  void poses() {
    json far = entry("a");
    far["pose"] = {1, 0, 0, 1e300, 0, 1, 0, 0, 0, 0, 1, 0};
    json mirrored = entry("b");
    mirrored["pose"] = {-1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0};
    json text = entry("c");
    text["pose"] = {1, 0, 0, "1", 0, 1, 0, 0, 0, 0, 1, 0};
    json rough = entry("d");
    rough["pose"] = {0.866, -0.5, 0, 1, 0.5, 0.866, 0, 2, 0, 0, 1, 3};
    json roughAtOrigin = entry("e");  // its rotation in few digits is the identity
    roughAtOrigin["pose"] = {1.00001, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    const Read read =
        readList({{"0001", far}, {"0002", mirrored}, {"0003", text}, {"0004", rough}, {"0005", roughAtOrigin}});
    QVERIFY(isSound(read.bodies));
    QCOMPARE(read.damage.size(), std::size_t{3});
    QVERIFY(read.bodies.withName("e")->pose.matrix() == Pose::Identity().matrix());
    QCOMPARE(read.bodies.withName("d")->pose.translation(), Vec3(1, 2, 3));
  }

  void tooManyBodies() {
    json list = json::object();
    for (std::size_t i = 1; i <= BodySet::kMost + 5; ++i) list[std::to_string(i)] = entry(std::to_string(i));
    const Read read = readList(list);
    QCOMPARE(read.bodies.size(), BodySet::kMost);
    QCOMPARE(read.damage.size(), std::size_t{1});
    QCOMPARE(read.damage[0].code, ErrorCode::FileTooLarge);
  }

  // A few bytes for each body that would make half a million triangles.
  void tooManyTriangles() {
    json list = json::object();
    Container blobs;
    for (int i = 1; i <= 100; ++i) {
      const std::string key = "00" + std::to_string(1000 + i);
      const auto profile = ProfileCurve::polyline({{1e5, 0.0}, {1e5, 1e4}});
      Container one;
      ShelfKind().save(*shelf(with({}, body("a", valueOf(RevolvedGeometry::make(*profile, 1e-4))))), one);
      list[key] = (*one.manifest)["document"]["bodies"]["0001"];
      for (const auto& [name, bytes] : one.blobs) {
        std::string moved = name;
        blobs.blobs[moved.replace(moved.find("0001"), 4, key)] = bytes;
      }
    }
    const Read read = readList(list, blobs);
    QCOMPARE(read.bodies.size(), std::size_t{100});
    QVERIFY(read.bodies.triangleCount() > 0 && read.bodies.triangleCount() <= BodySet::kMostTriangles);
    QCOMPARE(read.damage.size(), std::size_t{1});
    QCOMPARE(read.damage[0].code, ErrorCode::FileTooLarge);
    // Bodies that cannot be shown are not lost, either.
    Container again;
    ShelfKind().save(*shelf(read.bodies), again);
    QCOMPARE((*again.manifest)["document"]["bodies"].size(), std::size_t{100});
    // And no edit makes such a document.
    const BodyPointer largest =
        *std::max_element(read.bodies.begin(), read.bodies.end(), [](const BodyPointer& a, const BodyPointer& b) {
          return a->geometry->surface()->triangles.size() < b->geometry->surface()->triangles.size();
        });
    BodySet bodies;
    while (bodies.triangleCount() + largest->geometry->surface()->triangles.size() <= BodySet::kMostTriangles)
      bodies = with(bodies, body(freeBodyName(bodies, "a"), largest->geometry));
    const auto refused = addBodyEdit(bodies, body("one more", largest->geometry));
    QCOMPARE(refused.error().code, BodyError::TooManyTriangles);
    QVERIFY(addBodyEdit(bodies, body("small", valueOf(PrimitiveGeometry::make(Primitive::Cone, {0.5, 1000})))));
  }

  void countsThatAreNotThere() {
    json mesh = entry("a");
    mesh["geometry"] = {{"kind", "mesh"}, {"points", 18446744073709551615u}, {"triangles", 18446744073709551615u}};
    json profile = entry("b");
    profile["geometry"] = {{"kind", "revolution"}, {"poles", 18446744073709551615u}, {"degree", 2}, {"chord", 0.01}};
    const Read read = readList({{"0001", mesh}, {"0002", profile}});
    QVERIFY(isSound(read.bodies));
    QCOMPARE(read.bodies.size(), std::size_t{2});
    QVERIFY(!read.bodies.withName("a")->geometry->isKnown() && !read.bodies.withName("b")->geometry->isKnown());
    QCOMPARE(read.damage.size(), std::size_t{2});
  }
};

HANDWHEEL_TEST(BodyHostileTest)
#include "BodyHostileTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/CellBlobs.h"

#include "Cells.h"
#include "TestClass.h"
#include "document/container/ArchiveErrors.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

bool sameSoups(const CellRobot& a, const CellRobot& b) {
  for (std::size_t i = 0; i < a.surfaces.size(); ++i) {
    if (!a.surfaces[i] != !b.surfaces[i]) return false;
    if (!a.surfaces[i]) continue;
    if (a.surfaces[i]->points != b.surfaces[i]->points || a.surfaces[i]->triangles != b.surfaces[i]->triangles)
      return false;
  }
  return a.surfaces.size() == b.surfaces.size();
}

}  // namespace

class CellBlobsTest : public QObject {
  Q_OBJECT

 private slots:
  void saveAndLoad();
  void loadsWithoutThePackage();
  void lostBlobs();
  void hostileManifests();
  void pointsWithoutTriangles();

 private:
  ArmPackage m_package;
};

void CellBlobsTest::saveAndLoad() {
  const RobotCellSnapshot cell = cellIn(importOrThrow(m_package.urdf()));
  QVERIFY(rc::check("save and load", [&] {
    const auto moved =
        withJoints(cell, values({*rc::gen::inRange(0, 1001) / 1.0, *rc::gen::inRange(-200, 201) / 100.0}));
    std::vector<Error> damage;
    // Through the bytes of a file, so that every number is written and read.
    const auto bytes = writeContainer(saved(*moved), Compression::Fast);
    RC_ASSERT(bytes.hasValue());
    const auto read = readContainer(*bytes);
    RC_ASSERT(read.hasValue());
    const auto again = loaded(read->container, damage);
    RC_ASSERT(again != nullptr);
    RC_ASSERT(damage.empty());
    RC_ASSERT(again->joints == moved->joints);
    RC_ASSERT(again->source == moved->source);
    RC_ASSERT(again->robot->description == moved->robot->description);
    RC_ASSERT(sameSoups(*again->robot, *moved->robot));
  }));
}

void CellBlobsTest::loadsWithoutThePackage() {
  Container container;
  {
    const ArmPackage elsewhere;
    container = saved(*importOrThrow(elsewhere.urdf()).content);
  }
  std::vector<Error> damage;
  const auto cell = loaded(container, damage);
  QVERIFY(cell && damage.empty());
  QVERIFY(cell->robot->surfaces[0] && cell->robot->surfaces[1]);
}

void CellBlobsTest::lostBlobs() {
  const OpenedFile opened = importOrThrow(m_package.urdf());
  const Container whole = saved(*opened.content);
  for (const auto& [name, bytes] : whole.blobs) {
    for (const bool shortened : {false, true}) {
      Container part = whole;
      if (shortened)
        part.blobs[name].resize(bytes.size() / 2);
      else
        part.blobs.erase(name);
      std::vector<Error> damage;
      const auto cell = loaded(part, damage);
      if (name == "cell/robot.urdf") {
        QVERIFY(!cell);
      } else {
        QVERIFY2(cell && !damage.empty(), name.c_str());
        QCOMPARE(damage[0].code, ArchiveError::EntryDamaged);
      }
    }
  }
  // An index beyond the points, a coordinate that is no number, and one that is too far away.
  const std::pair<const char*, std::string> kWrong[] = {
      {"triangles/0000", "\xff\xff\xff\xff"}, {"points/0000", "\xff\xff\xff\xff"}, {"points/0000", "\xff\xff\x7f\x7f"}};
  for (const auto& [suffix, number] : kWrong) {
    Container wrong = whole;
    std::string& blob = wrong.blobs.at("cell/surfaces/0001/" + std::string(suffix));
    std::copy(number.begin(), number.end(), blob.begin());
    std::vector<Error> damage;
    const auto cell = loaded(wrong, damage);
    QVERIFY(cell && cell->robot->surfaces[1] && damage.size() == 1);
    QVERIFY(cell->robot->surfaces[1]->triangles.size() < 12);
    for (const Vec3& p : cell->robot->surfaces[1]->points) QVERIFY(p.allFinite() && p.norm() < 1e9);
  }
}

void CellBlobsTest::hostileManifests() {
  const Container whole = saved(*importOrThrow(m_package.urdf()).content);
  const nlohmann::json kJoints[] = {nullptr, 7, {1, 2}, {{"turn", "x"}}, {{"turn", nullptr}}, {{"turn", {1}}}};
  for (const nlohmann::json& joints : kJoints) {
    Container wrong = whole;
    (*wrong.manifest)["document"]["joints"] = joints;
    std::vector<Error> damage;
    const auto cell = loaded(wrong, damage);
    QVERIFY(cell);
    QCOMPARE(cell->joints, values({0, 0}));
  }
  Container outside = whole;
  (*outside.manifest)["document"]["joints"] = {{"turn", 1e300}, {"slide", -5}, {"none", 3}};
  std::vector<Error> damage;
  QCOMPARE(loaded(outside, damage)->joints, values({0, 2}));
  const nlohmann::json kSurfaces[] = {nullptr,
                                      3,
                                      nlohmann::json::array(),
                                      {nullptr, 5},
                                      {nullptr, {{"points", -1}, {"triangles", 1e30}}},
                                      {nullptr, {{"points", 4'000'000'000u}, {"triangles", 4'000'000'000u}}}};
  for (const nlohmann::json& surfaces : kSurfaces) {
    Container wrong = whole;
    (*wrong.manifest)["document"]["surfaces"] = surfaces;
    std::vector<Error> found;
    const auto cell = loaded(wrong, found);
    QVERIFY(cell && !found.empty());
  }
  Container empty;
  QVERIFY(!loaded(empty, damage));
  empty.blobs["cell/robot.urdf"] = kArmUrdf;
  QVERIFY(loaded(empty, damage));
}

// One triangle and many points, placed ten thousand times.
void CellBlobsTest::pointsWithoutTriangles() {
  std::string visuals;
  for (int i = 0; i < 10'000; ++i) visuals += "<visual><geometry><mesh filename='x.stl'/></geometry></visual>";
  Container container;
  container.blobs["cell/robot.urdf"] = "<robot><link name='a'>" + visuals + "</link></robot>";
  container.blobs["cell/surfaces/0000/points/0000"] = std::string(65'536 * 12, '\0');
  container.blobs["cell/surfaces/0000/triangles/0000"] = toBlob(std::vector<std::uint32_t>{0, 1, 2});
  (*container.manifest)["document"]["surfaces"].push_back({{"points", 65'536u}, {"triangles", 1u}});
  std::vector<Error> damage;
  const auto cell = loaded(container, damage);
  QVERIFY(cell && kKind.display(*cell).parts.empty());
  QCOMPARE(damage.size(), std::size_t{1});
  QCOMPARE(damage[0].code, ErrorCode::FileTooLarge);
}

HANDWHEEL_TEST(CellBlobsTest)
#include "CellBlobsTest.moc"

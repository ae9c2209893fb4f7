// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/proof/RestingPairs.h"

#include "../Cells.h"
#include "TestClass.h"
#include "document/cell/CellScene.h"

#include <QTest>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The third link lies on the first at rest, with two joints in between; 20 mm above it where the slide is at 20 mm.
const std::string kFolded = R"(<robot name='folded'><link name='base'/>
  <link name='upper'><collision><origin xyz='0.2 0 0'/><geometry><box size='0.4 0.04 0.04'/></geometry></collision></link>
  <link name='elbow'><collision><geometry><sphere radius='0.03'/></geometry></collision></link>
  <link name='fore'><collision><origin xyz='-0.2 0 0.02'/><geometry><box size='0.3 0.04 0.03'/></geometry></collision></link>
  <joint name='j1' type='revolute'><parent link='base'/><child link='upper'/><axis xyz='0 0 1'/>
    <limit lower='-3' upper='3' velocity='1' effort='1'/></joint>
  <joint name='j2' type='revolute'><parent link='upper'/><child link='elbow'/><origin xyz='0.4 0 0'/><axis xyz='0 0 1'/>
    <limit lower='-3' upper='3' velocity='1' effort='1'/></joint>
  <joint name='j3' type='prismatic'><parent link='elbow'/><child link='fore'/><axis xyz='0 0 1'/>
    <limit lower='0' upper='0.3' velocity='1' effort='1'/></joint></robot>)";

using Pairs = std::set<std::pair<std::string, std::string>>;
const Pairs kPair{{"upper", "fore"}};

bool meets(const RobotCellSnapshot& cell) {
  CollisionMeshes meshes;
  const Result<CellScene> scene = sceneOf(cell, meshes);
  return scene && !scene->scene.isFree(scene->planned(values({0.0, 0.0, 0.0})), 0.0, 0.0);
}

}  // namespace

// Pairs of links that touch at rest are left out only after they were shown.
class RestingPairsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { write(file(), kFolded); }

  // They are in the list of pairs that may touch, and a note names them. Who forbids them has them checked.
  void shownWhenRead() {
    const OpenedFile opened = importOrThrow(file());
    const RobotCellSnapshot& cell = cellIn(opened);
    QVERIFY(cell.plans->allowed == kPair);
    QCOMPARE(opened.file.notes.size(), std::size_t{1});
    QVERIFY((opened.file.notes[0].arguments == std::vector<std::string>{"upper – fore"}));
    QVERIFY(!meets(cell));
    auto checked = std::make_shared<RobotCellSnapshot>(cell);
    checked->plans = std::make_shared<const CellPlans>();
    QVERIFY(meets(*checked));
    // The saved file keeps this.
    std::vector<Error> damage;
    const auto again = loaded(saved(*checked), damage);
    QVERIFY(again && again->areRestingPairsKnown && again->plans->allowed.empty() && meets(*again));
  }

  // Files of former versions did not list them: they do when they are opened, and say so.
  void formerFiles() {
    Container container = saved(*importOrThrow(file()).content);
    (*container.manifest)["document"].erase("resting_pairs_known");
    container.blobs.erase("cell/plans.json");
    std::vector<Error> damage;
    const auto read = loaded(container, damage);
    QVERIFY(read && !read->areRestingPairsKnown && read->plans->allowed.empty());
    std::vector<Note> notes;
    const SnapshotPointer opened = kKind.withCheckedLinks(read, {}, notes, {});
    const auto& cell = static_cast<const RobotCellSnapshot&>(*opened);
    QVERIFY(cell.areRestingPairsKnown && cell.plans->allowed == kPair && notes.size() == 1);
  }

  // Links that only touch where the arm is folded are checked.
  void notAtRest() {
    std::string urdf = kFolded;
    const std::string low = "<origin xyz='-0.2 0 0.02'/>";
    urdf.replace(urdf.find(low), low.size(), "<origin xyz='0.2 0 0.02'/>");  // stretched at rest
    write(m_folder.filePath("stretched.urdf"), urdf);
    const OpenedFile opened = importOrThrow(m_folder.filePath("stretched.urdf"));
    QVERIFY(cellIn(opened).plans->allowed.empty() && opened.file.notes.empty());
    CollisionMeshes meshes;
    const Result<CellScene> scene = sceneOf(cellIn(opened), meshes);
    QVERIFY(scene && !scene->scene.isFree(scene->planned(values({0.0, 3.0, 0.0})), 0.0, 0.0));
  }

 private:
  QString file() const { return m_folder.filePath("folded.urdf"); }
  QTemporaryDir m_folder;
};

HANDWHEEL_TEST(RestingPairsTest)
#include "RestingPairsTest.moc"

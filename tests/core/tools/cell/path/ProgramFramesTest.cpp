// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/ProgramFrames.h"

#include "../ArmCell.h"
#include "TestClass.h"
#include "document/cell/path/OutdatedReasons.h"
#include "document/cell/path/PathBasis.h"
#include "document/cell/path/PathDigests.h"
#include "robot/program/PathFile.h"
#include "tools/cell/path/PathExport.h"
#include "tools/cell/path/PlanOperation.h"

#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// Frames of programs that are opened as paths: they become frames of the cell, or are found there.
class ProgramFramesTest : public QObject {
  Q_OBJECT

  static Pose fixture() { return poseOf({400.0, 50.0, 290.0}, {0.1, -0.2, 0.7}); }
  // A program of the cell's robot with two motions in this frame.
  static std::string written(ArmCell& cell, const char* post, const std::string& frame, const Pose& pose,
                             bool declares = true) {
    RobotProgram program;
    program.name = "seam";
    program.robot = "irb120";
    program.arm = cell.scene()->armFromBase();
    program.isBaseOfController = true;
    program.frame = pose;
    program.frameName = frame;
    program.declaresFrame = declares;
    program.motions = {{ProgramMotion::Kind::Joint, ArmValues::Constant(6, 0.5), 0.5, 0.0, {}},
                       {ProgramMotion::Kind::Linear, ArmValues::Constant(6, 0.55), 50.0, 0.0, {}}};
    return postCalled(post)->write(program);
  }
  static Result<ProgramPath> opened(ArmCell& cell, const char* post, const std::string& text) {
    return pathFromProgram(*cell.scene(), cell.content(), *postCalled(post), text);
  }
  static bool isAt(const Pose& a, const Pose& b) { return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() < 1e-4; }
  static CellPlacement placementOf(const RobotCellSnapshot& cell) {
    return {*cell.plans, cell.bodies, cell.robot->model, cell.joints};
  }

 private slots:
  void languages_data() {
    QTest::addColumn<QByteArray>("post");
    for (const char* post : {"rapid", "krl", "fanuc", "urscript", "csv", "json"})
      QTest::newRow(post) << QByteArray(post);
  }

  // Written and opened: the frame of the cell by its name, and the same waypoints.
  void languages() {
    QFETCH(const QByteArray, post);
    ArmCell cell;
    const auto read = opened(cell, post, written(cell, post, "fixture 1", fixture()));
    QVERIFY(read.hasValue());
    QCOMPARE(read->path.waypoints.size(), std::size_t{2});
    for (int i = 0; i < 2; ++i) {
      const ArmValues wanted = ArmValues::Constant(6, i == 0 ? 0.5 : 0.55);
      const ArmValues found = cell.scene()->planned(read->path.waypoints[i].joints);
      QVERIFY((found - wanted).cwiseAbs().maxCoeff() < 1e-4);
    }
    QCOMPARE(read->frames.size(), std::size_t{1});
    QVERIFY(isAt(read->frames[0].pose, fixture()));
    CellPlans plans;
    plans.frames = {{"fixture 1", fixture()}};
    RobotCellSnapshot content = cell.content();
    content.plans = std::make_shared<const CellPlans>(plans);
    const TakenFrames taken = takeFrames(read->frames, placementOf(content), plans);
    QVERIFY(taken.made.empty() && taken.used == std::vector<std::string>{"fixture 1"});
    QCOMPARE(plans.frames.size(), std::size_t{1});
    // Without a frame there is none.
    const auto plain = opened(cell, post, written(cell, post, "", Pose::Identity()));
    QVERIFY(plain.hasValue() && plain->frames.empty());
  }

  // A module that names a frame of the cell without its data is in that.
  void declaredElsewhere() {
    ArmCell cell;
    const std::string text = written(cell, "rapid", "fixture 1", fixture(), false);
    QVERIFY(!opened(cell, "rapid", text).hasValue());
    CellPlans plans;
    plans.frames = {{"fixture 1", fixture()}};
    cell.plan(plans);
    const auto read = opened(cell, "rapid", text);
    QVERIFY(read.hasValue());
    QCOMPARE(read->frames.size(), std::size_t{1});
    QVERIFY(isAt(read->frames[0].pose, fixture()));
    const ArmValues found = cell.scene()->planned(read->path.waypoints[1].joints);
    QVERIFY((found - ArmValues::Constant(6, 0.55)).cwiseAbs().maxCoeff() < 1e-4);
  }

  // At another pose a new one is made, once; the one that is there stays as it is.
  void anotherPose() {
    ArmCell cell;
    const RobotCellSnapshot content = cell.content();
    const Pose moved = fixture() * Eigen::Translation3d(0.0, 0.0, 1.0);
    CellPlans plans;
    const CellPlacement placement = placementOf(content);
    QCOMPARE(takeFrames({{"fixture", fixture()}}, placement, plans).made, std::vector<std::string>{"fixture"});
    QCOMPARE(takeFrames({{"fixture", moved}}, placement, plans).made, std::vector<std::string>{"fixture 2"});
    QCOMPARE(takeFrames({{"fixture", moved}}, placement, plans).used, std::vector<std::string>{"fixture 2"});
    QCOMPARE(takeFrames({{"FIXTURE", fixture()}}, placement, plans).used, std::vector<std::string>{"fixture"});
    QCOMPARE(plans.frames.size(), std::size_t{2});
    QVERIFY(isAt(plans.frame("fixture")->pose, fixture()) && isAt(plans.frame("fixture 2")->pose, moved));
    // Another name at the same pose is another frame.
    QCOMPARE(takeFrames({{"jig", fixture()}}, placement, plans).made, std::vector<std::string>{"jig"});
    while (plans.frames.size() < CellPlans::kMostFrames)
      plans.frames.push_back({"f" + std::to_string(plans.frames.size()), Pose::Identity()});
    const TakenFrames full = takeFrames({{"more", moved}, {"jig", fixture()}}, placement, plans);
    QCOMPARE(full.leftOut, std::vector<std::string>{"more"});
    QCOMPARE(full.used, std::vector<std::string>{"jig"});
    QCOMPARE(plans.frames.size(), CellPlans::kMostFrames);
  }

  // One that a body carries is used where it is now.
  void carriedByABody() {
    ArmCell cell;
    const BodyId box = cell.addBox({20, 20, 20}, {400.0, 50.0, 0.0});
    CellPlans plans;
    plans.frames = {{"fixture", poseOf({0.0, 0.0, 290.0}, {0.1, -0.2, 0.7}), box}};
    const RobotCellSnapshot content = cell.content();
    QCOMPARE(takeFrames({{"fixture", fixture()}}, placementOf(content), plans).used,
             std::vector<std::string>{"fixture"});
  }

  // A program means places in its frame: where that is moved by 10 mm, by itself or with its body, the path is outdated
  // and its places are planned 10 mm further on; joint values and places in the base stay.
  void movedFrames_data() {
    QTest::addColumn<QByteArray>("post");
    QTest::addColumn<bool>("isOnBody");
    for (const char* post : {"rapid", "krl", "fanuc", "csv", "json"}) {
      QTest::addRow("%s", post) << QByteArray(post) << false;
      QTest::addRow("%s on a body", post) << QByteArray(post) << true;
    }
  }
  void movedFrames() {
    QFETCH(const QByteArray, post);
    QFETCH(const bool, isOnBody);
    ArmCell cell;
    const BodyId box = cell.addBox({20, 20, 20}, {1500.0, 50.0, 0.0});
    CellPlans plans = *cell.document().plans();
    if (isOnBody)
      plans.frames = {{"jig", poseOf({1500.0, 50.0, 0.0}, Vec3::Zero()).inverse(Eigen::Isometry) * fixture(), box}};
    Result<ProgramPath> read = opened(cell, post, written(cell, post, "jig", fixture()));
    QVERIFY(read.hasValue());
    read->path.name = "seam";
    takeProgram(std::move(read).value(), cell.document().robot(), placementOf(cell.content()), plans);
    cell.plan(plans);
    const auto outdated = [&] {
      const RobotCellSnapshot now = cell.content();
      return outdatedReasonsOf(*now.robot, placementOf(now), now.plans->paths[0]);
    };
    QVERIFY(!outdated().isAny());
    const std::vector<Waypoint> before = plans.paths[0].waypoints;
    QVERIFY(before[1].frame && before[1].frame->name == "jig");
    const bool isTable = post == "csv" || post == "json";  // these have the pose of each place
    QCOMPARE(before[0].frame.has_value(), isTable);
    const PathDigests then(std::make_shared<const RobotCellSnapshot>(cell.content()));
    const BasisDigests digests = then.of(plans.paths[0]);
    const PathBasis basis = basisOf(cell.content(), plans.paths[0]);
    const RobotModel& robot = cell.document().robot().model;
    const auto stored = pathFrom(toJson(robot, plans.paths[0]), robot, cell.document().joints());
    QVERIFY(stored && *stored == plans.paths[0]);

    const Vec3 by(10.0, 0.0, 0.0);
    if (isOnBody) {
      Body moved = *cell.document().bodies().withId(box);
      moved.pose.pretranslate(by);
      cell.document().commit("Move", std::move(changeBodyEdit(cell.document().bodies(), moved)).value());
    } else {
      plans.frames[0].pose.pretranslate(by);
      cell.plan(plans);
    }
    QVERIFY((outdated() == OutdatedReasons{.frames = {"jig"}}));
    const PathDigests now(std::make_shared<const RobotCellSnapshot>(cell.content()), &then);
    const BasisChange wanted = isOnBody ? BasisChange::Bodies : BasisChange::Targets;
    QVERIFY(changeBetween(digests, now.of(plans.paths[0])) == wanted);
    QVERIFY(changeSince(basis, cell.content(), plans.paths[0]) == wanted);

    const auto again = plannedThrough(*cell.scene(), *cell.document().plans(), before, {});
    QVERIFY2(again.hasValue(), again.hasValue() ? "" : again.error().code->id);
    const Waypoint &first = again->path.waypoints.front(), &last = again->path.waypoints.back();
    const CellRobot& arm = cell.document().robot();
    const auto toolAt = [&](const Waypoint& waypoint) { return toolPose(arm, plans, waypoint.joints); };
    QVERIFY((toolAt(last).translation() - toolAt(before[1]).translation() - by).norm() < 1e-3);
    const Vec3 firstBy = isTable ? by : Vec3(Vec3::Zero());
    QVERIFY((toolAt(first).translation() - toolAt(before[0]).translation() - firstBy).norm() < 1e-3);
    plans = *cell.document().plans();
    plans.paths[0].waypoints = again->path.waypoints;
    cell.plan(plans);
    QVERIFY(!outdated().isAny());
  }

  // Joint motions to poses are in the frame, too, where the configuration of the program decides on the joint values.
  void posesOfJointMotions() {
    const std::pair<const char*, const char*> all[] = {
        {"rapid",
         "MODULE m\nTASK PERS wobjdata jig:=[FALSE,TRUE,\"\",[[300,-200,200],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];\n"
         "CONST robtarget p1:=[[50,100,200],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
         "CONST robtarget p2:=[[50,120,200],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
         "PROC main()\nMoveJ p1,v100,fine,tool0\\WObj:=jig;\nMoveJ "
         "p2,v100,fine,tool0\\WObj:=jig;\nENDPROC\nENDMODULE\n"},
        {"krl",
         "DEF m()\n; $BASE is the frame jig\n$BASE={X 300,Y -200,Z 200,A 0,B 0,C 0}\n$TOOL={X 0,Y 0,Z 0,A 0,B 0,C 0}\n"
         "PTP {X 50,Y 100,Z 200,A 0,B 90,C 0}\nPTP {X 50,Y 120,Z 200,A 0,B 90,C 0}\nEND\n"}};
    for (const auto& [post, text] : all) {
      ArmCell cell(std::string_view(post) == "krl" ? "kr6r900" : "irb120");
      CellPlans plans;
      Result<ProgramPath> read = opened(cell, post, text);
      QVERIFY2(read.hasValue(), read ? "" : read.error().code->id);
      takeProgram(std::move(read).value(), cell.document().robot(), placementOf(cell.content()), plans);
      for (const Waypoint& waypoint : plans.paths[0].waypoints) QVERIFY2(waypoint.frame, post);
    }
  }

  // The frame is known by its new name, and removed it does not count any more.
  void renamedFrames() {
    ArmCell cell;
    CellPlans plans;
    Result<ProgramPath> read = opened(cell, "krl", written(cell, "krl", "jig", fixture()));
    takeProgram(std::move(read).value(), cell.document().robot(), placementOf(cell.content()), plans);
    cell.plan(withFrameRenamed(plans, "jig", "table"));
    const RobotCellSnapshot renamed = cell.content();
    QCOMPARE(renamed.plans->paths[0].waypoints[1].frame->name, std::string("table"));
    const CellPlans removed = withoutFrame("table", placementOf(renamed));
    QVERIFY(!removed.paths[0].waypoints[1].frame);
  }

  // The base, frames without a name, and what is no pose make none; the same frame of many motions makes one.
  void whatIsNone() {
    const Pose base = poseOf({0.0, 4000.0, 0.0}, {0.0, 0.0, 1.0});
    ParsedMotion named{.frame = fixture(), .frameName = "F"}, unnamed{.frame = fixture()}, inBase = named,
                                                                                           broken = named, far = named;
    inBase.frame = Pose::Identity();
    broken.frame->translation().x() = std::nan("");
    far.frame->translation().x() = 1e300;
    const auto frames = framesOf({named, unnamed, inBase, broken, far, ParsedMotion(), named}, base);
    QCOMPARE(frames.size(), std::size_t{1});
    QVERIFY(isAt(frames[0].pose, base * fixture()));
    QVERIFY(framesOf({}, base).empty());
  }

  // Names that cells cannot have become such ones; of several that programs call alike the one with the very name is
  // numbered on.
  void names() {
    for (const std::string& name : {std::string(1'000'000, 'x'), std::string("a\nb"), std::string(" jig ")}) {
      const auto frames = framesOf({ParsedMotion{.frame = fixture(), .frameName = name}}, Pose::Identity());
      QCOMPARE(frames.size(), std::size_t{1});
      QVERIFY(isBodyName(frames[0].name) && frames[0].name.size() <= 60);
    }
    ArmCell cell;
    const RobotCellSnapshot content = cell.content();
    const Pose moved = fixture() * Eigen::Translation3d(0.0, 0.0, 1.0);
    CellPlans plans;
    plans.frames = {{"fixture 1", Pose::Identity()}, {"fixture_1", fixture()}};
    QCOMPARE(takeFrames({{"fixture_1", moved}}, placementOf(content), plans).made,
             std::vector<std::string>{"fixture_1 2"});
  }

  // A name that is in a program once is not kept whole by each of its motions.
  void aHugeName() {
    ArmCell cell;
    RobotProgram read;
    read.arm = cell.scene()->armFromBase();
    const std::pair<const char*, const char*> all[] = {
        {"csv", "# frame,"}, {"json", "frame_name"}, {"krl", "$BASE is"}};
    for (const auto& [post, before] : all) {
      std::string text = written(cell, post, "fixture", fixture());
      const std::size_t at = text.find("fixture", text.find(before));
      QVERIFY2(at != text.npos, post);
      const auto motions = postCalled(post)->read(text.replace(at, 7, std::string(100'000, 'x')), read);
      QVERIFY2(motions.hasValue() && motions->size() == 2, post);
      for (const ParsedMotion& motion : *motions) {
        QVERIFY2(motion.frame && motion.frameName.starts_with("xxx"), post);
        QVERIFY2(motion.frameName.size() <= 200, post);
      }
    }
  }
};

HANDWHEEL_TEST(ProgramFramesTest)
#include "ProgramFramesTest.moc"

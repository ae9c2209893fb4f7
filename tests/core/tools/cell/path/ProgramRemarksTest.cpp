// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/ProgramRemarks.h"

#include "../ArmCell.h"
#include "TestClass.h"
#include "base/Units.h"
#include "robot/posts/PostErrors.h"

#include <QTest>
#include <numeric>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr const char* kNowhere = ",[9E9,9E9,9E9,9E9,9E9,9E9]]";

Pose toolOfLength(double length) {
  return Pose(Eigen::Translation3d(0.0, 0.0, length));
}

}  // namespace

// Remarks on programs that are opened as paths.
class ProgramRemarksTest : public QObject {
  Q_OBJECT

  static Result<ProgramPath> opened(ArmCell& cell, const char* post, const std::string& text) {
    return pathFromProgram(*cell.scene(), cell.content(), *postCalled(post), text);
  }
  static QString remarksOn(ArmCell& cell, const char* post, const std::string& text) {
    const auto read = opened(cell, post, text);
    return read ? programRemarks(*read, cell.content().plans->tool).join(QLatin1Char('\n'))
                : QStringLiteral("not read");
  }

 private slots:
  void tools_data() {
    QTest::addColumn<QByteArray>("post");
    QTest::addColumn<QByteArray>("text");  // with the tool for @T, in mm, or @M, in m
    const std::string joints = std::string("[[10,0,0,0,30,0]") + kNowhere;
    QTest::newRow("rapid") << QByteArray("rapid")
                           << QByteArray::fromStdString(
                                  "PERS tooldata grip:=[TRUE,[[0,0,@T],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];\n"
                                  "MoveAbsJ " +
                                  joints + ",v100,fine,grip;\n");
    QTest::newRow("krl") << QByteArray("krl")
                         << QByteArray("$TOOL={X 0,Y 0,Z @T,A 0,B 0,C 0}\nPTP {A1 0,A2 0,A3 0,A4 0,A5 30,A6 0}\n");
    QTest::newRow("urscript") << QByteArray("urscript")
                              << QByteArray("set_tcp(p[0,0,@M,0,0,0])\nmovej([0,0,0,0,0.5,0])\n");
  }
  // Both are named where they differ by more than what programs round.
  void tools() {
    QFETCH(const QByteArray, post);
    QFETCH(QByteArray, text);
    ArmCell cell;
    CellPlans plans;
    plans.tool = toolOfLength(120.0);
    cell.plan(plans);
    const auto reported = [&](double length) {
      QByteArray program = text;
      program.replace("@T", QByteArray::number(length)).replace("@M", QByteArray::number(1e-3 * length, 'f', 6));
      return remarksOn(cell, post.constData(), program.toStdString());
    };
    QCOMPARE(reported(120.0), QString());
    QCOMPARE(reported(120.01), QString());
    const QString other = reported(150.0);
    QVERIFY2(other.contains("0, 0, 150 mm") && other.contains("0, 0, 120 mm"), qPrintable(other));
  }

  // A turn of the tool is a difference, too, and a program that names no tool has none.
  void turnedTools() {
    ArmCell cell;
    CellPlans plans;
    plans.tool = Pose(Eigen::Translation3d(0.0, 0.0, 120.0) * Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitZ()));
    cell.plan(plans);
    const std::string joints = std::string("MoveAbsJ [[10,0,0,0,30,0]") + kNowhere + ",v100,fine,grip;\n";
    const std::string turned =
        remarksOn(cell, "rapid",
                  "PERS tooldata grip:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];\n" + joints)
            .toStdString();
    QVERIFY2(turned.find("0, 0, 120 mm, turned by 0, 0, 90") != turned.npos, turned.c_str());
    QCOMPARE(remarksOn(cell, "rapid", joints), QString());  // its data are at the controller
    QCOMPARE(remarksOn(cell, "krl", "PTP {A1 0,A2 0,A3 0,A4 0,A5 30,A6 0}\n"), QString());
    QCOMPARE(remarksOn(cell, "urscript", "movej([0,0,0,0,0.5,0])\n"), QString());
  }

  // A description for ROS has its base turned by half a turn against the controller's, which it has as the link "base":
  // the same program is the same joint values as with the built-in robot. Without that link poses are refused.
  void controllersBase() {
    ArmCell builtIn("ur5");
    const std::string text =
        "table = p[0.1,0.2,0,0,0,0.3]\nmovej([0.3,-1.2,1.5,-1.6,-1.4,0.2])\n"
        "movel(p[-0.35,-0.35,0.4,0.5,3,0.2])\nmovel(pose_trans(table,p[-0.4,-0.5,0.4,0.5,3,0.2]))\n";
    const auto wanted = opened(builtIn, "urscript", text);
    QVERIFY(wanted.hasValue());
    RobotCellSnapshot cell = builtIn.content();
    cell.plans = std::make_shared<const CellPlans>();
    auto robot = std::make_shared<CellRobot>(*cell.robot);
    RobotModel& model = robot->model;
    const Pose half(Eigen::AngleAxisd(M_PI, Vec3::UnitZ()));
    model.name = robot->arms[0].title = "ur5_robot";
    model.links[model.root].name = "base_link";
    for (Joint& joint : model.joints) {
      if (joint.parent == model.root) joint.origin = half * joint.origin;
    }
    cell.robot = robot;
    const auto read = [&](const std::string& program) -> Result<ProgramPath> {
      CollisionMeshes meshes;
      const Result<CellScene> scene = sceneOf(cell, meshes);
      if (!scene) return scene.error();
      return pathFromProgram(*scene, cell, *postCalled("urscript"), program);
    };
    const auto refused = read(text);
    QVERIFY(!refused.hasValue());
    QVERIFY(refused.error().code == PostError::BaseUnknown);
    QCOMPARE(refused.error().position.value, std::uint64_t{3});
    QVERIFY(read("movej([0.3,-1.2,1.5,-1.6,-1.4,0.2])\nmovel([0.4,-1.2,1.5,-1.6,-1.4,0.2])\n").hasValue());
    const auto link = static_cast<std::uint32_t>(model.links.size());
    const auto joint = static_cast<std::uint32_t>(model.joints.size());
    model.links.push_back({.name = "base", .parentJoint = joint, .visuals = {}, .collisions = {}});
    model.joints.push_back(
        {.name = "base_link-base", .parent = model.root, .child = link, .origin = half, .limits = {}});
    model.order.push_back(joint);
    const auto same = read(text);
    QVERIFY(same.hasValue());
    QCOMPARE(same->path.waypoints.size(), std::size_t{3});
    for (std::size_t i = 0; i < 3; ++i)
      QVERIFY((same->path.waypoints[i].joints - wanted->path.waypoints[i].joints).cwiseAbs().maxCoeff() < 1e-5);
    // Its frame is in the cell where the program has it: half a turn about z.
    QCOMPARE(same->frames.size(), std::size_t{1});
    QVERIFY((same->frames[0].pose.translation() - Vec3(-100, -200, 0)).norm() < 1e-6);
  }

  // Places that a program names keep their names as far as its language has them, and have them in the next program.
  void namesOfWaypoints_data() {
    QTest::addColumn<QByteArray>("post");
    QTest::addColumn<QByteArray>("second");
    for (const auto& [post, second] : {std::pair("rapid", "seam_end"), std::pair("fanuc", "seam_end"),
                                       std::pair("csv", "seam_end"), std::pair("json", "seam end")})
      QTest::newRow(post) << QByteArray(post) << QByteArray(second);
  }
  void namesOfWaypoints() {
    QFETCH(const QByteArray, post);
    QFETCH(const QByteArray, second);
    ArmCell cell;
    RobotProgram program;
    program.name = "path";
    program.robot = "irb120";
    program.arm = cell.scene()->armFromBase();
    program.isBaseOfController = true;
    program.motions = {{ProgramMotion::Kind::Joint, ArmValues::Constant(6, 0.5), 0.5, 0.0, "start"},
                       {ProgramMotion::Kind::Linear, ArmValues::Constant(6, 0.55), 50.0, 0.0, "seam end"},
                       {ProgramMotion::Kind::Joint, ArmValues::Constant(6, 0.6), 0.5, 0.0, {}}};
    const auto read = opened(cell, post.constData(), postCalled(post.toStdString())->write(program));
    QVERIFY(read.hasValue());
    QCOMPARE(read->path.waypoints.size(), std::size_t{3});
    QCOMPARE(read->path.waypoints[0].name, std::string("start"));
    QCOMPARE(read->path.waypoints[1].name, second.toStdString());
    QCOMPARE(read->path.waypoints[2].name, std::string());
  }

  // Names that a person gave, in the spelling of the declaration or of the motion; what cells cannot have as a name is
  // none.
  void otherNamesOfWaypoints() {
    ArmCell cell;
    const auto nameIn = [&](const char* post, const std::string& text) {
      const auto read = opened(cell, post, text);
      return read && !read->path.waypoints.empty() ? read->path.waypoints[0].name : std::string("not read");
    };
    const std::string declared = std::string("CONST jointtarget p10:=[[10,0,0,0,30,0]") + kNowhere + ";\n";
    QCOMPARE(nameIn("rapid", declared + "MoveAbsJ p10,v100,fine,tool0;\n"), std::string("p10"));
    QCOMPARE(nameIn("rapid", declared + "MoveAbsJ P10,v100,fine,tool0;\n"), std::string("P10"));
    const auto fanuc = [](const std::string& remark) {
      return "/MN\n 1:J P[1" + remark +
             "] 50% FINE ;\n/POS\nP[1]{\n GP1:\n UF : 0, UT : 1,\n J1= 0 deg, J2= 0 deg, "
             "J3= 0 deg,\n J4= 0 deg, J5= 30 deg, J6= 0 deg\n};\n/END\n";
    };
    QCOMPARE(nameIn("fanuc", fanuc("")), std::string());
    QCOMPARE(nameIn("fanuc", fanuc(":above part")), std::string("above part"));
    QCOMPARE(nameIn("fanuc", fanuc(": ")), std::string());
    const std::string huge = nameIn("fanuc", fanuc(":" + std::string(100'000, 'x')));
    QVERIFY(huge.size() <= 60 && huge.starts_with("xxx"));
  }

  // A joint motion to a pose: in the configuration that it names, even if another is nearer; without one in the
  // nearest, and its line is reported, once.
  void openConfigurationsOfPrograms() {
    ArmCell cell;
    const SerialArm arm = cell.scene()->armFromBase();
    ArmValues near(6), far(6);
    near << 0.5, 0.3, 0.2, 1.4, 1.0, 0.0;
    far << 0.5, 0.3, 0.2, 1.4 - M_PI, -1.0, M_PI;  // the wrist turned over
    const Pose tip = arm.tipPose(near);
    QVERIFY(tip.isApprox(arm.tipPose(far), 1e-9));
    const Eigen::Quaterniond turn(tip.linear());
    const auto listed = [](std::initializer_list<double> numbers) {
      QStringList texts;
      for (const double number : numbers) texts += QString::number(number, 'f', 12);
      return "[" + texts.join(QLatin1Char(',')).toStdString() + "]";
    };
    const std::string pose = listed({tip.translation().x(), tip.translation().y(), tip.translation().z()}) + "," +
                             listed({turn.w(), turn.x(), turn.y(), turn.z()});
    const auto program = [&](const std::string& configuration) {
      return std::string("PROC main()\nMoveAbsJ [[25,17,11,70,50,0]") + kNowhere + ",v100,fine,tool0;\nMoveJ [" + pose +
             "," + configuration + kNowhere + ",v100,fine,tool0;\nENDPROC\n";
    };
    const auto endsAt = [&](const std::string& configuration, const ArmValues& wanted) {
      const auto read = opened(cell, "rapid", program(configuration));
      return read.hasValue() && read->path.waypoints.size() == 2 &&
             (cell.scene()->planned(read->path.waypoints[1].joints) - wanted).cwiseAbs().maxCoeff() < 1e-5;
    };
    QVERIFY(endsAt("[0,0,0,0]", near));
    QVERIFY(endsAt("[0,-2,2,1]", far));
    QVERIFY(endsAt("[9E9,9E9,9E9,9E9]", near));
    QVERIFY(!opened(cell, "rapid", program("[0,0,0,1]")).hasValue());
    // A line keeps the configuration in which it begins. If its own configuration is another one, a controller stops.
    const auto line = [&](const std::string& configuration, const std::string& before = {}) {
      std::string text = program(configuration);
      text.replace(text.find("MoveJ"), 5, before + "MoveL");
      return opened(cell, "rapid", text);
    };
    const auto comesNear = [&](const Result<ProgramPath>& read) {
      return read.hasValue() && read->path.waypoints.size() == 2 &&
             (cell.scene()->planned(read->path.waypoints[1].joints) - near).cwiseAbs().maxCoeff() < 1e-5;
    };
    QVERIFY(comesNear(line("[0,0,0,0]")));
    QVERIFY(comesNear(line("[9E9,9E9,9E9,9E9]")));
    QVERIFY(comesNear(line("[0,-2,2,1]", "ConfL\\Off; ")));
    const auto refused = line("[0,-2,2,1]");
    QVERIFY(!refused.hasValue());
    QVERIFY(refused.error().code == PostError::ConfigurationDiffers);
    QCOMPARE(refused.error().position.value, std::uint64_t{3});
    QVERIFY(!line("[0,-2,2,1]", "ConfL\\Off; ConfL\\On; ").hasValue());
    // The first motion of a program begins at its end, and thus in the named configuration.
    std::string first = program("[0,-2,2,1]");
    first.erase(first.find("MoveAbsJ"), first.find("MoveJ") - first.find("MoveAbsJ"));
    const auto begins = opened(cell, "rapid", first.replace(first.find("MoveJ"), 5, "MoveL"));
    QVERIFY(begins.hasValue());
    QVERIFY((cell.scene()->planned(begins->path.waypoints[0].joints) - far).cwiseAbs().maxCoeff() < 1e-5);
    QCOMPARE(remarksOn(cell, "rapid", program("[0,-2,2,1]")), QString());
    const QString reported = remarksOn(cell, "rapid", program("[9E9,9E9,9E9,9E9]"));
    QVERIFY2(reported.contains(": 3."), qPrintable(reported));
    ProgramPath many;
    many.openConfigurations.resize(1000);
    std::iota(many.openConfigurations.begin(), many.openConfigurations.end(), std::size_t{1});
    QVERIFY(programRemarks(many, Pose::Identity()).join(QString()).contains(": 1, 2, 3, 4, 5, …."));
    QVERIFY(programRemarks(ProgramPath(), Pose::Identity()).isEmpty());
  }

  // Remarks on parts of a program that its path leaves out, and on external axes, which the cell does not have.
  void partsThatAreLeftOut() {
    ArmCell cell;
    const auto program = [](const std::string& axes, const std::string& handler) {
      return "PROC main()\nMoveAbsJ [[25,17,11,70,50,0],[" + axes + ",9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\n" +
             handler + "ENDPROC\n";
    };
    QCOMPARE(remarksOn(cell, "rapid", program("9E9", "")), QString());
    const QString reported = remarksOn(cell, "rapid", program("1500", "ERROR\nRETRY;\n"));
    QVERIFY2(reported.contains(": 3 (") && reported.contains("[1500,9E9"), qPrintable(reported));
    const auto read = opened(cell, "rapid", program("1500", ""));
    QVERIFY(read.hasValue() && read->path.language == "rapid");
    const RobotModel& model = cell.scene()->robot->model;
    const auto again = pathFrom(toJson(model, read->path), model, cell.scene()->others);
    QVERIFY(again.hasValue() && again->head == read->path.head);
  }
};

HANDWHEEL_TEST(ProgramRemarksTest)
#include "ProgramRemarksTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/FaceMateTool.h"

#include "../ToolEvents.h"
#include "ArmCell.h"
#include "TestClass.h"

#include <rapidcheck.h>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Presses on a point along a direction.
PointerEvent press(const Vec3& point, const Vec3& direction) {
  PointerEvent event;
  event.kind = Kind::Press;
  event.button = PointerButton::First;
  event.ray = {point - 500.0 * direction.normalized(), direction.normalized()};
  return event;
}

Vec3 anyVector(double most) {
  const auto number = [&] { return *rc::gen::inRange(-1000, 1001) / 1000.0 * most; };
  return {number(), number(), number()};
}

}  // namespace

// A body is laid with a face of it on a face of another: a small box beside a table.
class FaceMateToolTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    m_cell = std::make_unique<ArmCell>();
    m_selection.clear();
    m_box = m_cell->addBox({40, 30, 20}, {700, 0, 50}, {0.3, -0.2, 0.9});
    m_table = m_cell->addBox({400, 600, 100}, {0, 900, 50});
    m_steps = m_cell->steps();
  }

  // The lower face of the box, wherever that looks, on the top of the table, middle on middle.
  void middlesOfFaces() {
    FaceMateTool tool = make();
    clickBox(tool, {7, -4, -10}, Vec3::UnitZ());
    QCOMPARE(m_selection.body(), std::optional(m_box));
    QVERIFY(!isEnabled(tool, "commit"));
    clickTable(tool, {130, 1050, 100});
    QVERIFY(isEnabled(tool, "commit") && tool.preview().replaced);
    QCOMPARE(m_cell->steps(), m_steps);
    QCOMPARE(tool.perform("commit"), ToolReply::Used);
    QCOMPARE(m_cell->steps(), m_steps + 1);
    QVERIFY((pose().translation() - Vec3(0, 900, 110)).norm() < 1e-9);
    QVERIFY(pose().linear().col(2).isApprox(Vec3::UnitZ(), 1e-9));
    m_cell->document().history()->undo();
    QVERIFY(pose().isApprox(poseOf({700, 0, 50}, {0.3, -0.2, 0.9}), 1e-12));
  }

  // The points that were clicked, 2 mm apart, turned.
  void pointsOffsetAndTurn() {
    FaceMateTool tool = make();
    tool.setSetting("meeting", 1.0);
    clickBox(tool, {20, 6, -3}, -Vec3::UnitX());
    clickTable(tool, {-50, 800, 100});
    const Eigen::Matrix3d straight = shown(tool).linear();
    tool.setSetting("offset", 2.0);
    tool.setSetting("angle", 0.7);
    tool.perform("commit");
    QVERIFY((pose() * Vec3(20, 6, -3) - Vec3(-50, 800, 102)).norm() < 1e-9);
    QVERIFY((pose().linear() * Vec3::UnitX() + Vec3::UnitZ()).norm() < 1e-9);
    const Eigen::AngleAxisd turned(Eigen::Matrix3d(pose().linear() * straight.transpose()));
    QVERIFY(std::abs(turned.angle() - 0.7) < 1e-9 && turned.axis().isApprox(Vec3::UnitZ(), 1e-9));
  }

  // Step by step back; the other body never moves.
  void anotherFace() {
    FaceMateTool tool = make();
    clickBox(tool, {0, 0, -10}, Vec3::UnitZ());
    clickBox(tool, {0, 15, 0}, -Vec3::UnitY());  // Another face of the same body replaces the first
    clickTable(tool, {0, 900, 100});
    QCOMPARE(tool.perform("revert"), ToolReply::Used);
    QVERIFY(!isEnabled(tool, "commit"));
    clickTable(tool, {0, 900, 100});
    tool.perform("commit");
    QVERIFY((pose().linear() * Vec3::UnitY() + Vec3::UnitZ()).norm() < 1e-9);
    QVERIFY((pose().translation() - Vec3(0, 900, 115)).norm() < 1e-9);
    QVERIFY(m_cell->document().bodies().withId(m_table)->pose.isApprox(poseOf({0, 900, 50}, Vec3::Zero()), 1e-12));
    QCOMPARE(tool.perform("revert"), ToolReply::Finished);
  }

  // The normal of the face under the pointer is shown until that leaves; a changed document ends what was chosen.
  void hoveredAndChanged() {
    FaceMateTool tool = make();
    const auto hoverTable = [&](Kind kind) {
      PointerEvent event = press({0, 900, 100}, -Vec3::UnitZ());
      event.kind = kind;
      event.button = PointerButton::None;
      m_hit = RobotCellPick{"body." + std::to_string(m_table), {0, 900, 100}};
      return tool.pointer(event);
    };
    QCOMPARE(hoverTable(Kind::Hover), ToolReply::Used);
    QCOMPARE(tool.preview().lines.size(), std::size_t{1});
    const std::vector<Vec3> line = tool.preview().lines.front();
    QVERIFY((line[1] - line[0]).normalized().isApprox(Vec3::UnitZ(), 1e-9));
    hoverTable(Kind::Leave);
    QVERIFY(tool.preview().lines.empty());
    QCOMPARE(hoverTable(Kind::Release), ToolReply::Ignored);
    m_hit.reset();
    QCOMPARE(tool.pointer(press({0, 0, 900}, -Vec3::UnitZ())), ToolReply::Ignored);  // the camera's
    clickBox(tool, {0, 0, -10}, Vec3::UnitZ());
    clickTable(tool, {0, 900, 100});
    tool.documentChanged();
    QVERIFY(!isEnabled(tool, "commit") && !tool.preview().replaced);
    QCOMPARE(tool.perform("commit"), ToolReply::Ignored);
    QCOMPARE(tool.perform("revert"), ToolReply::Finished);
    for (const ToolKey& key : FaceMateTool::keys()) QVERIFY(actionNamed(tool.actions(), key.action));
  }

  // Typed values are previewed and kept within their limits: turns of one revolution at most.
  void settings() {
    FaceMateTool tool = make();
    const auto shown = [&](const char* id) { return std::get<double>(propertyNamed(tool.settings(), id)->value); };
    for (const char* const id : {"meeting", "offset", "angle"}) QCOMPARE(shown(id), 0.0);
    tool.setSetting("meeting", 1.0);
    tool.setSetting("offset", -2.5);
    tool.setSetting("angle", 100.0);
    QCOMPARE(shown("meeting"), 1.0);
    QCOMPARE(shown("offset"), -2.5);
    QCOMPARE(shown("angle"), 2.0 * M_PI);
    tool.setSetting("meeting", 7.0);  // there is no such choice
    QCOMPARE(shown("meeting"), 1.0);
  }

  // The robot stands where it stands: a face of it can only be the second.
  void theRobotIsNotPlaced() {
    FaceMateTool tool = make();
    const DisplayPart base = m_cell->document().kind().display(*m_cell->document().snapshot()).parts.front();
    const TriangleSoup& soup = *base.soup;
    const Triangle& t = soup.triangles.front();
    const Vec3 point = base.pose * ((soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]) / 3.0);
    m_hit = RobotCellPick{base.name, point};
    QCOMPARE(tool.pointer(press(point, -Vec3::UnitZ())), ToolReply::Used);
    QVERIFY(m_selection.empty());
    clickBox(tool, {0, 0, -10}, Vec3::UnitZ());
    m_hit = RobotCellPick{base.name, point};
    tool.pointer(press(point, -Vec3::UnitZ()));
    QVERIFY(isEnabled(tool, "commit"));
  }

  // Any face comes to any other: the points meet, the normals are opposed, the motion is rigid.
  void bringingTogetherIsRigid() {
    QVERIFY(rc::check([] {
      const Vec3 normal = anyVector(1.0), onto = anyVector(1.0);
      RC_PRE(normal.norm() > 0.1 && onto.norm() > 0.1);
      const Vec3 n = normal.normalized(), m = onto.normalized(), p = anyVector(800.0), q = anyVector(800.0);
      const double offset = anyVector(50.0).x();
      const Pose motion = bringingTogether(p, n, q, m, offset, anyVector(3.0).x());
      RC_ASSERT(isRigid(motion));
      RC_ASSERT((motion * p - q - offset * m).norm() < 1e-8);
      RC_ASSERT((motion.linear() * n + m).norm() < 1e-8);
    }));
    // Also if their normals are equal already, or opposed.
    for (const double side : {1.0, -1.0}) {
      const Pose motion = bringingTogether(Vec3::Zero(), Vec3::UnitZ(), Vec3::Zero(), side * Vec3::UnitZ(), 0.0, 0.0);
      QVERIFY(isRigid(motion) && (motion.linear() * Vec3::UnitZ() + side * Vec3::UnitZ()).norm() < 1e-12);
    }
  }

  // A flat piece ends where the surface bends: the middle of the top of an L of two boxes side by side is its own.
  void middleOfAnL() {
    // Two squares of 10 mm with a common edge and a third one beside, one corner cut: by triangles.
    auto soup = std::make_shared<TriangleSoup>();
    soup->points = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {20, 0, 0}, {20, 10, 0}, {0, 0, -10}, {10, 0, -10}};
    soup->triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}, {0, 6, 1}, {6, 7, 1}};
    const DisplayPart part{.name = "p", .soup = soup, .pose = poseOf({100, 0, 0}, {0, 0, M_PI / 2})};
    const auto face = faceAt(part, part.pose * Vec3(3, 2, 0), true);
    QVERIFY(face && (face->middle - part.pose * Vec3(10, 5, 0)).norm() < 1e-9);
    QVERIFY((face->normal - Vec3::UnitZ()).norm() < 1e-9);
    QVERIFY(!faceAt(part, part.pose * Vec3(3, 2, 5), true));
  }

  // For very many triangles, too: those of a plane, not of the step beside it.
  void middleOfManyTriangles() {
    constexpr std::uint32_t kCells = 120;
    auto soup = std::make_shared<TriangleSoup>();
    for (std::uint32_t y = 0; y <= kCells; ++y) {
      for (std::uint32_t x = 0; x <= kCells; ++x) soup->points.emplace_back(x, y, 0);
    }
    for (std::uint32_t y = 0; y < kCells; ++y) {
      for (std::uint32_t x = 0; x < kCells; ++x) {
        const std::uint32_t a = y * (kCells + 1) + x, b = a + kCells + 1;
        soup->triangles.push_back({a, a + 1, b});
        soup->triangles.push_back({a + 1, b + 1, b});
      }
    }
    const auto first = static_cast<std::uint32_t>(soup->points.size());
    for (const Vec3& step : {Vec3(120, 0, 50), Vec3(220, 0, 50), Vec3(120, 120, 50)}) soup->points.push_back(step);
    soup->triangles.push_back({first, first + 1, first + 2});
    const auto face = faceAt({.name = "p", .soup = soup}, {3.3, 2.2, 0.0}, true);
    QVERIFY(face && (face->middle - Vec3(60, 60, 0)).norm() < 1e-6);
  }

 private:
  FaceMateTool make() {
    return FaceMateTool(m_cell->document(), m_selection, {[this](const Ray&) { return m_hit; }, {}});
  }
  Pose pose() const { return m_cell->document().bodies().withId(m_box)->pose; }
  Pose shown(const FaceMateTool& tool) const {
    const std::string name = "body." + std::to_string(m_box);
    const auto model = tool.preview().replaced;
    for (const DisplayPart& part : model->parts) {
      if (part.name == name) return part.pose;
    }
    return Pose::Identity();
  }
  // point, direction: in the frame of the box.
  void clickBox(FaceMateTool& tool, const Vec3& point, const Vec3& direction) {
    m_hit = RobotCellPick{"body." + std::to_string(m_box), pose() * point};
    QCOMPARE(tool.pointer(press(pose() * point, pose().linear() * direction)), ToolReply::Used);
  }
  void clickTable(FaceMateTool& tool, const Vec3& point) {
    m_hit = RobotCellPick{"body." + std::to_string(m_table), point};
    QCOMPARE(tool.pointer(press(point, -Vec3::UnitZ())), ToolReply::Used);
  }

  std::unique_ptr<ArmCell> m_cell;
  BodySelection m_selection;
  BodyId m_box = 0, m_table = 0;
  std::optional<RobotCellPick> m_hit;
  int m_steps = 0;
};

HANDWHEEL_TEST(FaceMateToolTest)
#include "FaceMateToolTest.moc"

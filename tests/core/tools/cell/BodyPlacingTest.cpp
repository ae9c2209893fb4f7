// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ArmCell.h"
#include "TestClass.h"
#include "document/cell/CellDisplay.h"
#include "tools/cell/BodyPlacing.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

Box boxAbout(const Vec3& middle, double side) {
  return {middle - Vec3::Constant(0.5 * side), middle + Vec3::Constant(0.5 * side)};
}

}  // namespace

// Poses of bodies that are added to a cell.
class BodyPlacingTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    m_cell = std::make_unique<ArmCell>();
    const CellRobot& robot = m_cell->document().robot();
    m_robots = displayOf(robot, restValues(robot.model)).bounds();
  }

  // In front of all, in the middle of the plane of x and z, on the floor; of one that is moved it does not matter where
  // it is.
  void besideAll() {
    const Box own = boxAbout({-40, 70, 5}, 30);
    const Vec3 alone = displacementBeside(own, m_robots, m_cell->content());
    QVERIFY(own.min().x() + alone.x() >= m_robots.max().x() && own.min().x() + alone.x() < m_robots.max().x() + 1.0);
    QCOMPARE(own.center().y() + alone.y(), 0.0);
    QCOMPARE(own.min().z() + alone.z(), 0.0);
    const BodyId body = m_cell->addBox({100, 100, 100}, {3000, 0, 0});
    const Vec3 behind = displacementBeside(own, m_robots, m_cell->content());
    QVERIFY(own.min().x() + behind.x() >= 3050.0 && own.min().x() + behind.x() < 3051.0);
    QVERIFY(displacementBeside(own, m_robots, m_cell->content(), body) == alone);
    QVERIFY(displacementBeside(own, Box(), cellWithoutBodies(*m_cell)).x() == 0.0);
  }

  // An object that only touches is not inside, nor is one that contains the robot.
  void insideOthers() {
    const auto isInside = [&](const Box& own) { return isInsideOthers(own, m_robots, m_cell->content()); };
    const CellRobot& robot = m_cell->document().robot();
    for (const DisplayPart& link : displayOf(robot, m_cell->document().joints()).parts)
      QVERIFY(isInside(boxAbout(DisplayModel{{link}}.bounds().center(), 2)));
    QVERIFY(!isInside(boxAbout({0, 0, m_robots.min().z() - 10}, 20)));
    QVERIFY(!isInside(boxAbout({0, 2000, 20}, 20)));
    QVERIFY(!isInside(boxAbout({0, 0, 0}, 1e5)));
    QVERIFY(!isInside(Box()));
    m_cell->addBox({100, 100, 100}, {0, 2000, 50});
    QVERIFY(isInside(boxAbout({0, 2000, 20}, 20)));
    QVERIFY(!isInside(boxAbout({0, 2000, 110}, 20)));  // on top of it
    QVERIFY(isInside(boxAbout({0, 2000, 109.9}, 20)));
    m_cell->addBox({9000, 9000, 9000}, {0, 9000, 0});  // a room
    QVERIFY(!isInside(boxAbout({0, 9000, 20}, 20)));
  }

  // The bounds of a square that is turned by 45° about z are wider by the square root of 2.
  void bounds() {
    const BodyId body = m_cell->addBox({20, 20, 6}, {100, 0, 3}, {0, 0, M_PI / 4.0});
    const Box box = boundsOf(*m_cell->document().bodies().withId(body));
    QVERIFY(std::abs(box.sizes().x() - 20.0 * std::sqrt(2.0)) < 1e-9 && std::abs(box.sizes().z() - 6.0) < 1e-9);
    QVERIFY(std::abs(box.min().z()) < 1e-9 && std::abs(box.center().x() - 100.0) < 1e-9);
  }

 private:
  static RobotCellSnapshot cellWithoutBodies(ArmCell& cell) {
    RobotCellSnapshot content = cell.content();
    content.bodies = BodySet();
    return content;
  }

  std::unique_ptr<ArmCell> m_cell;
  Box m_robots;
};

HANDWHEEL_TEST(BodyPlacingTest)
#include "BodyPlacingTest.moc"

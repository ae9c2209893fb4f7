// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/IkSolutionsTool.h"

#include "../ToolEvents.h"
#include "ArmCell.h"
#include "TestClass.h"

#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

IkSolutionsTool toolFor(ArmCell& cell) {
  return IkSolutionsTool(cell.document(), {[&cell] { return cell.scene(); }, {}});
}

std::size_t rowsOf(const IkSolutionsTool& tool) {
  return propertyNamed(tool.settings(), "way")->choices.size();
}

PointerEvent ofDevice(PointerButton button) {
  PointerEvent event;
  event.kind = Kind::Press;
  event.button = button;
  event.device = Pose::Identity();
  return event;
}

}  // namespace

// The tool by which a person chooses among the solutions of the inverse kinematics.
class IkSolutionsToolTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    m_cell = std::make_unique<ArmCell>();
    m_cell->stand({0.3, 0.4, 0.2, 0.5, 0.8, -0.3});
  }

  // The tool stays where it is, the joints do not; one step, undone.
  void anotherSolutionIsOneStep() {
    IkSolutionsTool tool = toolFor(*m_cell);
    QVERIFY(rowsOf(tool) >= 2);
    QVERIFY(!isEnabled(tool, "commit"));  // it stands like that
    QVERIFY(!tool.preview().replaced);
    const Pose before = m_cell->tool();
    const JointValues stood = m_cell->document().joints();
    const int steps = m_cell->steps();
    tool.perform("next");
    QVERIFY(tool.preview().replaced);
    QCOMPARE(m_cell->steps(), steps);
    QVERIFY(isEnabled(tool, "commit"));
    QCOMPARE(tool.perform("commit"), ToolReply::Used);
    tool.documentChanged();
    QCOMPARE(m_cell->steps(), steps + 1);
    QVERIFY((m_cell->document().joints() - stood).cwiseAbs().maxCoeff() > 0.1);
    QVERIFY(m_cell->tool().isApprox(before, 1e-9));
    QCOMPARE(tool.chosen(), std::size_t{0});
    QVERIFY(!isEnabled(tool, "commit"));
    m_cell->document().history()->undo();
    QVERIFY(m_cell->document().joints() == stood);
  }

  // The last action of a full round leads back to the first; backwards to the last.
  void allInTurn() {
    IkSolutionsTool tool = toolFor(*m_cell);
    const std::size_t count = rowsOf(tool);
    for (std::size_t i = 0; i < count; ++i) {
      QCOMPARE(tool.chosen(), i);
      tool.perform("next");
    }
    QCOMPARE(tool.chosen(), std::size_t{0});
    tool.perform("previous");
    QCOMPARE(tool.chosen(), count - 1);
    tool.setSetting("way", 1.0);
    QCOMPARE(tool.chosen(), std::size_t{1});
  }

  void aTypedPose() {
    IkSolutionsTool tool = toolFor(*m_cell);
    const Vec3 before = m_cell->tool().translation();
    tool.setSetting("z", before.z() - 20.0);
    QVERIFY(isEnabled(tool, "commit"));
    tool.perform("commit");
    tool.documentChanged();
    QVERIFY((m_cell->tool().translation() - before + Vec3(0.0, 0.0, 20.0)).norm() < 1e-6);
    // Out of reach: it says so, and goes back to where it is.
    tool.setSetting("x", 1e4);
    QVERIFY(!isEnabled(tool, "commit"));
    QVERIFY(!propertyNamed(tool.settings(), "way")->problem.empty());
    QCOMPARE(tool.perform("revert"), ToolReply::Used);
    QVERIFY(tool.pose().isApprox(m_cell->tool(), 1e-12));
    QCOMPARE(tool.perform("revert"), ToolReply::Finished);
  }

  // An invalid solution is shown and cannot be chosen.
  void beyondLimits() {
    IkSolutionsTool tool = toolFor(*m_cell);
    const std::vector<CellIkSolution> solutions =
        ikSolutionsTo(*m_cell->scene(), *m_cell->document().plans(), m_cell->tool(),
                      m_cell->scene()->planned(m_cell->document().joints()));
    bool isAny = false;
    for (std::size_t i = 0; i < solutions.size(); ++i) {
      tool.setSetting("way", static_cast<double>(i));
      if (solutions[i].isWithinLimits()) continue;
      isAny = true;
      QVERIFY(tool.preview().replaced);
      QVERIFY(!isEnabled(tool, "commit"));
      QCOMPARE(tool.perform("commit"), ToolReply::Ignored);
    }
    QVERIFY(isAny);  // else this shows nothing
  }

  // The obstacle of a solution is named in its row.
  void whatCollidesIsSaid() {
    IkSolutionsTool tool = toolFor(*m_cell);
    tool.perform("next");
    const auto shown = tool.preview().replaced;
    QVERIFY(shown);
    // A box where the third link of that solution is, and not of the first.
    const std::string solution = propertyNamed(tool.settings(), "way")->choices[1];
    QVERIFY(!solution.empty());
    m_cell->addBox({30, 30, 30}, shown->parts[3].pose.translation());
    tool.documentChanged();
    tool.perform("next");
    const std::string row = propertyNamed(tool.settings(), "way")->choices[1];
    QVERIFY2(row.find("box1") != row.npos, row.c_str());
  }

  void theDeviceHasTwoButtons() {
    IkSolutionsTool tool = toolFor(*m_cell);
    const int steps = m_cell->steps();
    QCOMPARE(tool.pointer(ofDevice(PointerButton::First)), ToolReply::Used);
    QCOMPARE(tool.chosen(), std::size_t{1});
    QCOMPARE(tool.pointer(ofDevice(PointerButton::Second)), ToolReply::Used);
    QCOMPARE(m_cell->steps(), steps + 1);
    QCOMPARE(tool.pointer(above(Kind::Press, 0, 0)), ToolReply::Ignored);  // the camera's
  }

 private:
  std::unique_ptr<ArmCell> m_cell;
};

HANDWHEEL_TEST(IkSolutionsToolTest)
#include "IkSolutionsToolTest.moc"

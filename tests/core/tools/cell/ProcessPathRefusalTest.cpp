// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ArmCell.h"
#include "TestClass.h"
#include "document/cell/CellErrors.h"
#include "document/scene/BodyErrors.h"
#include "tools/cell/ProcessPathOperation.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

// Reasons why there is no path along a curve of a block before the arm.
class ProcessPathRefusalTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    m_cell = std::make_unique<ArmCell>();
    m_cell->stand({0.0, 0.5, 0.3, 0.0, 0.77, 0.0});
    m_block = m_cell->addBox({100, 100, 60}, {350, 0, 230});
  }

  void whatIsAsked() { QVERIFY(planned(edge()).hasValue()); }

  // A part is called by its name, and stands.
  void theParts() {
    const auto called = [&](const char* name) {
      OperationValues values(processPathOperation());
      values.setValid("part", std::string(name));
      return partCalled(values, *m_cell->scene());
    };
    QVERIFY(called("box1") && (*called("box1"))->id == m_block);
    QVERIFY(called("nothing").error().code == BodyError::BodyMissing);
    RobotCellDocument& document = m_cell->document();
    const double flange = 1.0 + document.robot().arms[0].flange;  // after "nothing"
    QVERIFY(document.setProperty("body." + std::to_string(m_block) + ".carrier", flange).hasValue());
    QVERIFY(called("box1").error().code == CellError::PartCarried);
    QCOMPARE(called("box1").error().arguments, std::vector<std::string>{"box1"});
  }

  // The points of a drawn curve are numbers by threes, which the surface connects.
  void drawnCurves() {
    OperationValues values = edge();
    values.setValid("along", static_cast<double>(kAlongDrawn));
    values.setValid("near", std::vector<double>{340.0, 0.0, 260.0});
    QVERIFY(planned(values).error().code == ErrorCode::NumberMalformed);  // none is given
    const std::pair<const char*, const char*> malformed[] = {
        {"360,0", "360,0"}, {"360,0,260;380", "360,0,260;380"}, {"360,left,260", "left"}, {"360,1e300,260", "1e300"}};
    for (const auto& [text, named] : malformed) {
      values.setValid("through", std::string(text));
      const auto refused = planned(values);
      QVERIFY2(!refused && refused.error().code == ErrorCode::NumberMalformed, text);
      QCOMPARE(refused.error().arguments, std::vector<std::string>{named});
    }
    values.setValid("through", std::string("360, 0, 260; 370 10 260"));
    QVERIFY(planned(values).hasValue());
  }

  // No curve is on a body without a surface, nor across one that is elsewhere.
  void noCurve() {
    OperationValues values = edge();
    values.setValid("near", std::vector<double>{350.0, 400.0, 260.0});
    values.setValid("along", 2.0);  // a section across y
    const auto none = planned(values);
    QVERIFY(!none && none.error().code == CellError::TrackMissing);
    QCOMPARE(none.error().arguments, std::vector<std::string>{"box1"});
  }

  // The first point that the arm cannot reach, with its position: a millimetre from the edge.
  void outOfReach() {
    m_block = m_cell->addBox({100, 100, 60}, {2000, 0, 230});
    OperationValues values = edge();
    values.setValid("near", std::vector<double>{2000.0, -50.0, 260.0});
    const Error error = refusal(values);
    QVERIFY(error.code == CellError::TrackOutOfReach);
    QCOMPARE(error.arguments.size(), std::size_t{5});
    QCOMPARE(error.arguments[0], std::string("1"));
    QVERIFY(std::abs(std::stod(error.arguments[2]) - 2000.0) < 100.0);
  }

  // The obstacle at a point is named.
  void blocked() {
    m_cell->addBox({300, 300, 40}, {350, 0, 300});
    const Error error = refusal(edge());
    QVERIFY(error.code == CellError::TrackBlocked);
    QCOMPARE(error.arguments.size(), std::size_t{7});
    QCOMPARE(error.arguments[6], std::string("box2"));
  }

  void cancelled() {
    JobState state;
    state.cancelled = true;
    const auto none = planned(edge(), Progress(state));
    QVERIFY(!none && none.error().code == ErrorCode::Cancelled);
  }

  // Its start and goal must exist.
  void ends() {
    for (const char* const end : {"from", "to"}) {
      OperationValues values = edge();
      values.setValid(end, std::string("gone"));
      const Error error = refusal(values);
      QVERIFY2(error.code == CellError::WaypointMissing, end);
      QCOMPARE(error.arguments, std::vector<std::string>{"gone"});
    }
  }

 private:
  static OperationValues edge() {
    OperationValues values(processPathOperation());
    values.setValid("part", std::string("box1"));
    values.setValid("near", std::vector<double>{350.0, -50.0, 260.0});
    values.setValid("length", 40.0);
    values.setValid("standoff", 20.0);
    values.setValid("tilt", 0.2);
    return values;
  }
  Result<PlannedPath> planned(const OperationValues& values, Progress progress = {}) {
    const Body body = *m_cell->document().bodies().withId(m_block);
    const auto surface = std::make_shared<const PartSurface>(*body.geometry->surface());
    return processPath(*m_cell->scene(), m_cell->content(), values, surface, body, progress, {});
  }
  Error refusal(const OperationValues& values) {
    const auto made = planned(values);
    return made ? Error{} : made.error();
  }

  std::unique_ptr<ArmCell> m_cell;
  BodyId m_block = 0;
};

HANDWHEEL_TEST(ProcessPathRefusalTest)
#include "ProcessPathRefusalTest.moc"

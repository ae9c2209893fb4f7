// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/DecimateTool.h"

#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/measure/MeshFidelity.h"
#include "mesh/simplify/DecimationFidelity.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

const ToolAction& commitOf(const std::vector<ToolAction>& actions) {
  return *std::find_if(actions.begin(), actions.end(), [](const ToolAction& a) { return a.id == "commit"; });
}

double valueOf(const Tool& tool, const char* id) {
  for (const Property& property : tool.settings()) {
    if (property.id == id) return std::get<double>(property.value);
  }
  return NAN;
}

}  // namespace

class DecimateToolTest : public QObject {
  Q_OBJECT

 private slots:
  void toACount();
  void withinADistance();
  void distanceThatWasChosen();
  void whatCannotBe();
  void afterUndo();
  void quadric();
};

void DecimateToolTest::toACount() {
  const auto document = test::meshDocument(test::icosphere(4));
  DecimateTool tool(*document, immediateServices(*document));
  QCOMPARE(valueOf(tool, "faces"), 5120.0 / 2.0);
  tool.setSetting("faces", 499.6);
  QCOMPARE(valueOf(tool, "faces"), 500.0);
  const HalfEdgeMesh before = document->mesh();
  QCOMPARE(tool.perform("commit"), ToolReply::Used);
  QCOMPARE(document->mesh().liveFaceCount(), std::size_t(500));
  QCOMPARE(validate(document->mesh()), std::string());
  QCOMPARE(document->history()->count(), 1);
  document->history()->undo();
  QVERIFY(test::sameMesh(document->mesh(), before));
}

// Every vertex of a ball of radius 1 stays on it up to the distance.
void DecimateToolTest::withinADistance() {
  const auto document = test::meshDocument(test::icosphere(4));
  DecimateTool tool(*document, immediateServices(*document));
  tool.setSetting("goal", 1.0);
  tool.setSetting("error", 0.02);
  QVERIFY(std::isnan(valueOf(tool, "faces")));  // only what matters is offered
  tool.perform("commit");
  QVERIFY(document->mesh().liveFaceCount() < 2000);
  for (const test::Coordinates& p : test::allCoordinates(document->mesh().compact().soup)) {
    QVERIFY(std::abs(std::hypot(p[0], p[1], p[2]) - 1.0) <= 0.02 + 0.005);  // the ball's own chords take 0.004
  }
}

// A share of the diagonal, from the fidelity of the document.
void DecimateToolTest::distanceThatWasChosen() {
  const auto document = test::meshDocument(test::cube());
  for (const double share : {1e-3, 1e-4, 1e-2}) {
    FidelityValues values;
    QVERIFY(values.set(decimationErrorSetting(), share));
    document->setFidelity(share == 1e-3 ? FidelityValues() : values);
    DecimateTool tool(*document, immediateServices(*document));
    tool.setSetting("goal", 1.0);
    QVERIFY(std::abs(valueOf(tool, "error") - share * std::sqrt(3.0)) < 1e-12);
  }
}

void DecimateToolTest::whatCannotBe() {
  const auto document = test::meshDocument(test::cube());
  DecimateTool tool(*document, immediateServices(*document));
  tool.setSetting("faces", 12.0);
  QVERIFY(!commitOf(tool.actions()).enabled);
  tool.setSetting("faces", NAN);
  tool.setSetting("faces", true);
  tool.setSetting("nothing of the kind", 1.0);
  QCOMPARE(valueOf(tool, "faces"), 12.0);
  tool.setSetting("faces", -5.0);
  QCOMPARE(valueOf(tool, "faces"), 4.0);
  QCOMPARE(tool.perform("revert"), ToolReply::Finished);
}

void DecimateToolTest::afterUndo() {
  const auto document = test::meshDocument(test::icosphere(3));
  DecimateTool tool(*document, immediateServices(*document));
  tool.perform("commit");
  tool.documentChanged();
  QVERIFY(valueOf(tool, "faces") < static_cast<double>(document->mesh().liveFaceCount()));
}

// It bounds no distance and looks at no crossings, so these are not offered, nor in its step.
void DecimateToolTest::quadric() {
  const auto document = test::meshDocument(test::icosphere(3));
  FidelityValues values;
  QVERIFY(values.set(decimationMethodSetting(), 1.0));
  document->setFidelity(values);
  DecimateTool tool(*document, immediateServices(*document));
  QCOMPARE(valueOf(tool, "method"), 1.0);
  tool.setSetting("goal", 1.0);
  for (const char* id : {"goal", "error"}) QVERIFY(std::isnan(valueOf(tool, id)));
  tool.setSetting("faces", 300.0);
  tool.perform("commit");
  QCOMPARE(document->mesh().liveFaceCount(), std::size_t(300));
  QCOMPARE(validate(document->mesh()), std::string());
}

HANDWHEEL_TEST(DecimateToolTest)
#include "DecimateToolTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/TransformTool.h"

#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>
#include <cmath>
#include <numbers>

using namespace handwheel;

namespace {

constexpr NumberType kTransformToolNumbers = NumberType::Float64;

std::unique_ptr<MeshDocument> box(const Vec3& corner) {
  return test::meshDocument(test::cube(2.0, corner), "/scans/part.stl", kTransformToolNumbers);
}

bool isNear(const Vec3& a, const Vec3& b, double size = 1.0) {
  return (a - b).norm() <= 1e-12 * (size + a.norm());
}

}  // namespace

class TransformToolTest : public QObject {
  Q_OBJECT

 private slots:
  void inTurn();
  void unitOfTheFile();
  void committedAndUndone();
  void standards();
  void previewIsTheBox();
  void mistakes();
};

// A quarter turn about z, then the move: of the cube's corner that was lowest, by hand.
void TransformToolTest::inTurn() {
  const auto document = box({10, 0, 0});  // centre (11, 1, 1)
  TransformTool tool(*document, immediateServices(*document));
  tool.setSetting("turn_z", 0.5 * std::numbers::pi);
  tool.setSetting("scale", 3.0);
  tool.setSetting("move_y", 5.0);
  QVERIFY(isNear(tool.placement() * Vec3(10, 0, 0), Vec3(11 + 3, 1 - 3 + 5, 1 - 3)));
  QVERIFY(isNear(tool.placement() * Vec3(11, 1, 1), Vec3(11, 6, 1)));
}

// Inches are scaled about the origin: a coordinate of 2 means 2 inches.
void TransformToolTest::unitOfTheFile() {
  const auto document = box({10, 0, 0});
  TransformTool tool(*document, immediateServices(*document));
  tool.setSetting("unit", 3.0);
  QVERIFY(isNear(tool.placement() * Vec3(12, 2, 0), Vec3(12 * 25.4, 2 * 25.4, 0), 300));
}

void TransformToolTest::committedAndUndone() {
  QVERIFY(rc::check("there and back", [] {
    const auto document = box({1, 2, 3});
    TransformTool tool(*document, immediateServices(*document));
    const auto number = [](int most) { return *rc::gen::inRange(-most, most) / 100.0; };
    for (const char* id : {"move_x", "move_y", "move_z"}) tool.setSetting(id, number(100000));
    for (const char* id : {"turn_x", "turn_y", "turn_z"}) tool.setSetting(id, number(300));
    tool.setSetting("scale", 0.01 + std::abs(number(1000)));
    const Eigen::Affine3d by = tool.placement();
    const HalfEdgeMesh before = document->mesh();
    tool.perform("commit");
    const HalfEdgeMesh after = document->mesh();
    RC_ASSERT(validate(after).empty());
    for (Vertex v = 0; v < before.vertexSlots(); ++v)
      RC_ASSERT(isNear(after.position(v), by * before.position(v), 1000.0));
    RC_ASSERT(tool.preview().lines.empty());  // its numbers are used up
    document->history()->undo();
    RC_ASSERT(test::sameMesh(document->mesh(), before));
    document->history()->redo();
    RC_ASSERT(test::sameMesh(document->mesh(), after));
  }));
}

void TransformToolTest::standards() {
  const auto document = box({10, 20, 30});
  TransformTool tool(*document, immediateServices(*document));
  tool.perform("corner");
  QVERIFY(isNear(document->defects().box.min(), Vec3::Zero()));
  QVERIFY(isNear(document->defects().box.max(), Vec3::Constant(2.0)));
  tool.perform("centre");
  QVERIFY(isNear(document->defects().box.min(), Vec3::Constant(-1.0)));
  tool.perform("flat");
  QVERIFY(std::abs(document->defects().box.min().z()) < 1e-12);
  tool.perform("axes");
  QVERIFY(document->defects().box.center().norm() < 1e-9);
  QCOMPARE(document->history()->count(), document->history()->index());
}

void TransformToolTest::previewIsTheBox() {
  const auto document = box({0, 0, 0});
  TransformTool tool(*document, immediateServices(*document));
  QVERIFY(tool.preview().lines.empty());
  tool.setSetting("move_x", 7.0);
  const auto lines = tool.preview().lines;
  QCOMPARE(lines.size(), std::size_t(12));
  Box shown;
  for (const auto& line : lines) {
    QVERIFY(std::abs((line[1] - line[0]).norm() - 2.0) < 1e-12);
    for (const Vec3& p : line) shown.extend(p);
  }
  QVERIFY(isNear(shown.min(), Vec3(7, 0, 0)));
  QCOMPARE(tool.perform("revert"), ToolReply::Used);  // first the numbers, then the tool
  QCOMPARE(tool.perform("revert"), ToolReply::Finished);
}

void TransformToolTest::mistakes() {
  const auto document = box({0, 0, 0});
  TransformTool tool(*document, immediateServices(*document));
  for (const PropertyValue& value : {PropertyValue(NAN), PropertyValue(std::string("far"))})
    tool.setSetting("scale", value);
  tool.setSetting("unit", 17.0);
  QVERIFY(tool.placement().isApprox(Eigen::Affine3d::Identity()));
  tool.setSetting("scale", 0.0);  // brought up to what does not flatten
  QVERIFY(tool.placement().linear().determinant() > 0.0);
  QCOMPARE(tool.perform("no such thing"), ToolReply::Ignored);
}

HANDWHEEL_TEST(TransformToolTest)
#include "TransformToolTest.moc"

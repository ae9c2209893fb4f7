// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/SelectTool.h"

#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "ToolEvents.h"
#include "WaitingServices.h"
#include "mesh/MeshValidator.h"
#include "proximity/ClosestPoint.h"

#include <QTest>

using namespace handwheel;
using test::kControl;
using test::Kind;
using test::kNoModifiers;
using test::kShift;

class SelectToolTest : public QObject {
  Q_OBJECT

 private slots:
  void clicks();
  void clickOnNothingClears();
  void turningTheCameraDoesNotClear();
  void clicksAtAHole();
  void doubleClickTakesThePart();
  void brushCoversADisc();
  void brushAddsAndRemoves();
  void brushStrokeIsOneStep();
  void brushInPixels();
  void lassoSeesOrGoesThrough();
  void connectedAndAngle();
  void hoverShowsWhatAClickWouldSelect();
  void actionsOnTheSelection();
  void previousAndNext();
  void deleteIsOneEdit();
  void selectingIsNoEdit();
  void escLeavesStepByStep();
  void secondButton();
  void selectFromAList();
  void jobsComeLater();
  void lateJobsAreDropped();
  void oldHierarchy();
  void noHierarchy();
};

namespace {

// Two plates of 10 × 10 squares over each other, corners on whole numbers, facing up. The upper one has the faces from
// 200 on.
TriangleSoup plates() {
  const auto plate = [](double z) {
    return test::grid(11, 11, false, false, [=](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, z); });
  };
  TriangleSoup soup = plate(0.0);
  test::append(soup, plate(5.0));
  return soup;
}

struct Bench {
  std::unique_ptr<MeshDocument> document;
  SelectTool tool;

  explicit Bench(const TriangleSoup& soup, double mode = 0)
      : document(test::meshDocument(soup)), tool(*document, immediateServices(*document)) {
    tool.setSetting("mode", mode);
  }
  std::vector<Face> faces() const { return tool.selection().faces.faces(); }
  std::size_t count() const { return tool.selection().faces.count(); }
  void click(double x, double y, Modifiers modifiers = {}) {
    tool.pointer(test::above(Kind::Press, x, y, modifiers));
    tool.pointer(test::above(Kind::Release, x, y, modifiers));
  }
  void stroke(const std::vector<Eigen::Vector2d>& way, Modifiers modifiers = {}) {
    tool.pointer(test::above(Kind::Press, way[0].x(), way[0].y(), modifiers));
    for (const auto& p : way) tool.pointer(test::above(Kind::Drag, p.x(), p.y(), modifiers));
    tool.pointer(test::above(Kind::Release, way.back().x(), way.back().y(), modifiers));
  }
};

// The two faces of the upper plate's square are upper(x, y) and the next.
Face upper(int x, int y) {
  return static_cast<Face>(200 + 2 * (10 * x + y));
}

constexpr double kClick = 0, kBrush = 1, kLasso = 2, kConnected = 3, kAngle = 4;

}  // namespace

void SelectToolTest::clicks() {
  Bench b(plates());
  const Face first = upper(3, 4) + 1, second = upper(7, 2);  // above the diagonal, below it
  b.click(3.2, 4.8);
  QCOMPARE(b.faces(), std::vector<Face>{first});
  b.click(7.8, 2.2);
  QCOMPARE(b.faces(), std::vector<Face>{second});
  b.click(3.2, 4.8, kShift);
  QCOMPARE(b.faces(), (std::vector<Face>{first, second}));
  b.click(7.8, 2.2, kControl);
  QCOMPARE(b.faces(), std::vector<Face>{first});
  b.click(7.8, 2.2, kControl);
  b.click(20, 20, kControl);
  b.click(20, 20, kShift);
  QCOMPARE(b.faces(), std::vector<Face>{first});
  QVERIFY(b.tool.preview().selected == (FaceSelection{first}));
}

void SelectToolTest::clickOnNothingClears() {
  Bench b(plates());
  b.click(3.2, 4.8);
  QCOMPARE(b.tool.pointer(test::above(Kind::Press, 20, 20)), ToolReply::Ignored);  // the camera may turn
  QCOMPARE(b.tool.pointer(test::above(Kind::Release, 20, 20)), ToolReply::Used);
  QCOMPARE(b.count(), std::size_t(0));
}

void SelectToolTest::turningTheCameraDoesNotClear() {
  Bench b(plates());
  b.click(3.2, 4.8);
  b.tool.pointer(test::above(Kind::Press, 20, 20));
  QCOMPARE(b.tool.pointer(test::above(Kind::Drag, 22, 20)), ToolReply::Ignored);
  QCOMPARE(b.tool.pointer(test::above(Kind::Release, 22, 20)), ToolReply::Ignored);
  QCOMPARE(b.count(), std::size_t(1));
}

void SelectToolTest::clicksAtAHole() {
  Bench b(test::sphereWithoutCap(3));
  const Vertex key = keyOf(b.document->mesh(), b.document->defects().loops.at(0));
  b.click(0, 0);
  QVERIFY(b.tool.selection() == (MeshSelection{{}, {key}}));
  QCOMPARE(b.tool.preview().lines.size(), std::size_t(1));
  b.click(0.7, 0, kShift);
  QCOMPARE(b.count(), std::size_t(1));
  b.click(0.01, 0.01, kControl);
  QVERIFY(b.tool.selection().loops.empty() && b.count() == 1);
  b.tool.pointer(test::above(Kind::Hover, 0, 0));
  QCOMPARE(b.tool.preview().lines.size(), std::size_t(1));
  b.tool.pointer(test::above(Kind::Leave, 0, 0));
  QVERIFY(b.tool.preview().lines.empty());
}

void SelectToolTest::doubleClickTakesThePart() {
  Bench b(plates());
  b.click(3.2, 4.8);
  b.tool.pointer(test::above(Kind::DoubleClick, 3.2, 4.8));
  b.tool.pointer(test::above(Kind::Release, 3.2, 4.8));
  QCOMPARE(b.count(), std::size_t(200));
  QCOMPARE(b.faces().front(), Face(200));
}

void SelectToolTest::brushCoversADisc() {
  Bench b(plates(), kBrush);
  b.tool.setSetting("brush_unit", 0.0);
  b.tool.setSetting("brush_length", 2.3);
  QCOMPARE(b.tool.pointer(test::above(Kind::Press, 20, 20)), ToolReply::Ignored);
  b.stroke({{4.6, 5.1}});
  const HalfEdgeMesh& mesh = b.document->mesh();
  for (Face f = 0; f < 400; ++f) {
    const auto [p, q, r] = mesh.points(f);
    const Vec3 centre(4.6, 5.1, 5.0);
    const bool meets = f >= 200 && (closestOnTriangle(centre, p, q, r) - centre).norm() <= 2.3;
    QCOMPARE(b.tool.selection().faces.contains(f), meets);
  }
}

void SelectToolTest::brushAddsAndRemoves() {
  Bench b(plates(), kBrush);
  b.tool.setSetting("brush_unit", 0.0);
  b.tool.setSetting("brush_length", 1e-3);
  b.stroke({{0.5, 0.2}, {9.5, 0.2}});
  const FaceSelection row = b.tool.selection().faces;
  QVERIFY(row.count() >= 10 && row.contains(upper(0, 0)) && row.contains(upper(9, 0)));
  b.stroke({{0.5, 3.2}, {9.5, 3.2}}, kShift);
  QCOMPARE(b.count(), 2 * row.count());
  b.stroke({{0.5, 0.2}, {9.5, 0.2}}, kControl);
  QCOMPARE(b.count(), row.count());
  QVERIFY(!b.tool.selection().faces.contains(upper(5, 0)));
  b.stroke({{0.5, 0.2}, {9.5, 0.2}});
  QVERIFY(b.tool.selection().faces == row);
}

void SelectToolTest::brushStrokeIsOneStep() {
  Bench b(plates(), kBrush);
  b.stroke({{1, 1}});
  const MeshSelection before = b.tool.selection();
  b.tool.pointer(test::above(Kind::Press, 5, 5));
  b.tool.pointer(test::above(Kind::Drag, 8, 5));
  QVERIFY(!(b.tool.selection() == before));  // one sees it grow
  QVERIFY(b.tool.preview().circle && b.tool.preview().circle->first.isApprox(Vec3(8, 5, 5)));
  QCOMPARE(b.tool.perform("revert"), ToolReply::Used);
  QVERIFY(b.tool.selection() == before);
  b.stroke({{5, 5}, {8, 5}, {8, 8}});
  QVERIFY(!(b.tool.selection() == before));
  b.tool.perform("previous");
  QVERIFY(b.tool.selection() == before);
}

void SelectToolTest::brushInPixels() {
  Bench b(plates(), kBrush);
  b.tool.setSetting("brush_pixels", 100.0);
  b.tool.pointer(test::above(Kind::Hover, 5, 5));
  QCOMPARE(b.tool.preview().circle->second, 1.0);
  b.tool.perform("larger");
  b.tool.pointer(test::above(Kind::Hover, 5, 5));
  QVERIFY(b.tool.preview().circle->second > 1.0);
  b.tool.perform("smaller");
  b.tool.pointer(test::above(Kind::Hover, 5, 5));
  QCOMPARE(b.tool.preview().circle->second, 1.0);
  PointerEvent near = test::above(Kind::Hover, 5, 5);
  near.eye = Vec3(5, 5, 55);  // 50 above the plate; a pixel is 0.01 at 100
  near.ray.origin = *near.eye;
  near.focus = 100.0;
  b.tool.pointer(near);
  QCOMPARE(b.tool.preview().circle->second, 0.5);
  QVERIFY(test::isEnabled(b.tool, "larger"));
  b.tool.setSetting("mode", kClick);
  QVERIFY(!test::isEnabled(b.tool, "larger"));
}

void SelectToolTest::lassoSeesOrGoesThrough() {
  Bench b(plates(), kLasso);
  const std::vector<Eigen::Vector2d> around = {{1.5, 1.5}, {6.5, 1.5}, {6.5, 4.5}, {1.5, 4.5}};
  b.stroke(around);
  std::vector<Face> expected;
  for (int x = 2; x < 6; ++x)
    for (int y = 2; y < 4; ++y) expected.insert(expected.end(), {upper(x, y), upper(x, y) + 1});
  QCOMPARE(b.faces(), expected);
  b.tool.setSetting("through", true);
  b.stroke(around);
  QCOMPARE(b.count(), 2 * expected.size());
  b.stroke({{0.5, 0.5}, {4.5, 0.5}, {4.5, 9.5}, {0.5, 9.5}}, kControl);
  QCOMPARE(b.count(), 2 * 2 * 2 * 2u);  // the squares x = 4, 5 stay
  b.tool.pointer(test::above(Kind::Press, 0, 0));
  b.tool.pointer(test::above(Kind::Drag, 5, 0));
  b.tool.pointer(test::above(Kind::Drag, 5, 5));
  QCOMPARE(b.tool.preview().lines.at(0).size(), std::size_t(4));
  QVERIFY(b.tool.preview().lines[0][2].isApprox(Vec3(5, 5, 5)));
}

void SelectToolTest::connectedAndAngle() {
  Bench b(plates(), kConnected);
  b.click(3.2, 4.8);
  QCOMPARE(b.count(), std::size_t(200));
  Bench cube(test::cube(), kAngle);
  cube.click(0.5, 0.4);
  QCOMPARE(cube.count(), std::size_t(2));
  cube.tool.setSetting("angle", 1.58);
  cube.click(0.5, 0.4);
  QCOMPARE(cube.count(), std::size_t(12));
}

void SelectToolTest::hoverShowsWhatAClickWouldSelect() {
  Bench b(plates(), kClick);
  b.tool.pointer(test::above(Kind::Hover, 3.2, 4.8));
  QCOMPARE(b.tool.preview().highlighted, std::vector<std::uint32_t>{upper(3, 4) + 1});
  b.tool.setSetting("mode", kConnected);
  QVERIFY(b.tool.preview().highlighted.empty());
  b.tool.pointer(test::above(Kind::Hover, 3.2, 4.8));
  QCOMPARE(b.tool.preview().highlighted.size(), std::size_t(200));
  b.tool.pointer(test::above(Kind::Hover, 20, 20));
  QVERIFY(b.tool.preview().highlighted.empty());
  QCOMPARE(b.count(), std::size_t(0));
  Bench large(test::torus(200, 60), kConnected);  // 24 000 faces: too many to show on the way
  large.tool.pointer(test::above(Kind::Hover, 2.0, 0.1));
  QCOMPARE(large.tool.preview().highlighted.size(), std::size_t(1));
}

void SelectToolTest::actionsOnTheSelection() {
  Bench b(plates());
  for (const char* id : {"grow", "shrink", "delete", "previous", "next"}) QVERIFY(!test::isEnabled(b.tool, id));
  b.tool.perform("all");
  QCOMPARE(b.count(), std::size_t(400));
  b.tool.perform("invert");
  QCOMPARE(b.count(), std::size_t(0));
  b.click(5.3, 5.7);
  b.tool.perform("grow");
  QCOMPARE(b.count(), std::size_t(13));  // all that touch a triangle of a grid cut one way
  b.tool.perform("shrink");
  QCOMPARE(b.faces(), std::vector<Face>{upper(5, 5) + 1});
  b.tool.perform("invert");
  QCOMPARE(b.count(), std::size_t(399));
  QCOMPARE(b.tool.perform("unknown"), ToolReply::Ignored);
}

void SelectToolTest::previousAndNext() {
  Bench b(plates());
  b.click(3.2, 4.8);
  const MeshSelection one = b.tool.selection();
  b.tool.perform("grow");
  b.tool.perform("previous");
  QVERIFY(b.tool.selection() == one);
  QVERIFY(test::isEnabled(b.tool, "next"));
  b.tool.perform("next");
  QCOMPARE(b.count(), std::size_t(13));
  b.tool.perform("previous");
  b.tool.perform("previous");
  QVERIFY(b.tool.selection().empty());
}

void SelectToolTest::deleteIsOneEdit() {
  Bench b(plates());
  QObject::connect(b.document.get(), &Document::changed, [&] { b.tool.documentChanged(); });
  const HalfEdgeMesh before = b.document->mesh();
  b.click(5.3, 5.7);
  b.tool.perform("grow");
  const MeshSelection selected = b.tool.selection();
  QCOMPARE(b.tool.perform("delete"), ToolReply::Used);
  QCOMPARE(b.document->history()->count(), 1);
  QCOMPARE(b.document->history()->text(0), QString("Delete faces"));
  QCOMPARE(validate(b.document->mesh()), std::string());
  for (Face f = 0; f < 400; ++f) QCOMPARE(b.document->mesh().isLive(f), !selected.faces.contains(f));
  QCOMPARE(b.document->defects().loops.size(), std::size_t(3));
  QVERIFY(b.tool.selection().empty());
  b.document->history()->undo();
  QVERIFY(test::sameMesh(b.document->mesh(), before));
  b.tool.perform("previous");
  QVERIFY(b.tool.selection() == selected);
}

void SelectToolTest::selectingIsNoEdit() {
  Bench b(plates(), kBrush);
  const auto revision = b.document->revision();
  b.stroke({{5, 5}, {8, 5}});
  for (const char* id : {"all", "invert", "grow", "shrink", "previous", "next", "revert"}) b.tool.perform(id);
  QCOMPARE(b.document->history()->count(), 0);
  QCOMPARE(b.document->revision(), revision);
}

void SelectToolTest::escLeavesStepByStep() {
  Bench b(plates());
  b.click(3.2, 4.8);
  b.tool.pointer(test::above(Kind::Press, 5.2, 5.8));
  QCOMPARE(b.tool.perform("revert"), ToolReply::Used);
  QCOMPARE(b.tool.pointer(test::above(Kind::Release, 5.2, 5.8)), ToolReply::Ignored);
  QCOMPARE(b.faces(), std::vector<Face>{upper(3, 4) + 1});
  QCOMPARE(b.tool.perform("revert"), ToolReply::Used);
  QVERIFY(b.tool.selection().empty());
  QCOMPARE(b.tool.perform("revert"), ToolReply::Finished);
  b.click(3.2, 4.8);
  QCOMPARE(b.tool.perform("commit"), ToolReply::Finished);
  QCOMPARE(b.count(), std::size_t(1));  // for the next tool
}

void SelectToolTest::secondButton() {
  Bench b(plates());
  PointerEvent event = test::above(Kind::Press, 5, 5);
  event.button = PointerButton::Second;
  QCOMPARE(b.tool.pointer(event), ToolReply::Ignored);  // of the mouse: the camera's, or a menu's
  event.device = Pose::Identity();
  QCOMPARE(b.tool.pointer(event), ToolReply::Finished);
}

void SelectToolTest::selectFromAList() {
  Bench b(plates());
  int updates = 0;
  b.tool.whenUpdated([&] { ++updates; });
  b.tool.select({{1, 2, 7777}, {55}});
  QVERIFY(b.tool.selection() == (MeshSelection{{1, 2}, {}}));
  QCOMPARE(updates, 1);
  b.tool.perform("previous");
  QVERIFY(b.tool.selection().empty());
}

void SelectToolTest::jobsComeLater() {
  Bench b(plates());
  test::WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(b.document->mesh());
  SelectTool tool(*b.document, waiting.services());
  int updates = 0;
  tool.whenUpdated([&] { ++updates; });
  tool.setSetting("mode", kConnected);
  tool.pointer(test::above(Kind::Press, 3.2, 4.8));
  tool.pointer(test::above(Kind::Release, 3.2, 4.8));
  QVERIFY(tool.selection().empty());
  const auto finish = waiting.work();
  QVERIFY(tool.selection().empty());
  finish();
  QCOMPARE(tool.selection().faces.count(), std::size_t(200));
  QCOMPARE(updates, 1);

  tool.perform("delete");
  QCOMPARE(waiting.changes.size(), std::size_t(1));
  QCOMPARE(b.document->history()->count(), 0);
  HalfEdgeMesh later = b.document->mesh();  // the change can be made on another version
  later.removeFace(300);
  waiting.changes.front().apply(later);
  QCOMPARE(later.liveFaceCount(), std::size_t(200));
  QCOMPARE(validate(later), std::string());
}

void SelectToolTest::lateJobsAreDropped() {
  Bench b(plates());
  test::WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(b.document->mesh());
  auto tool = std::make_unique<SelectTool>(*b.document, waiting.services());
  tool->setSetting("mode", kConnected);
  const auto click = [&](double x) {
    tool->pointer(test::above(Kind::Press, x, 4.8));
    tool->pointer(test::above(Kind::Release, x, 4.8));
  };
  click(3.2);
  auto first = waiting.work();
  click(3.2);  // takes its place
  QCOMPARE(waiting.cancelled, 1);
  first();
  QVERIFY(tool->selection().empty());
  auto second = waiting.work();
  QCOMPARE(tool->perform("revert"), ToolReply::Used);
  QCOMPARE(waiting.cancelled, 2);
  second();
  QVERIFY(tool->selection().empty());
  click(3.2);
  auto third = waiting.work();
  tool->documentChanged();
  third();
  QVERIFY(tool->selection().empty());
  click(3.2);
  auto fourth = waiting.work();
  tool.reset();
  QCOMPARE(waiting.cancelled, 4);
  fourth();  // finds nobody
}

// Until a hierarchy of the present mesh is there, one cannot select what is gone.
void SelectToolTest::oldHierarchy() {
  Bench b(plates());
  test::WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(b.document->mesh());
  SelectTool tool(*b.document, waiting.services());
  HalfEdgeMesh mesh = b.document->mesh();
  removeFaces(mesh, FaceSelection{upper(3, 4), upper(3, 4) + 1});
  b.document->commit("Edit", inspected(mesh));
  tool.documentChanged();
  for (const double mode : {kClick, kBrush, kLasso, kConnected, kAngle}) {
    tool.setSetting("mode", mode);
    tool.setSetting("through", true);
    for (const auto& event : {test::above(Kind::Press, 3.2, 4.8), test::above(Kind::Drag, 9.9, 4.8),
                              test::above(Kind::Drag, 9.9, 9.9), test::above(Kind::Release, 0.2, 9.9)})
      tool.pointer(event);
    while (!waiting.jobs.empty()) waiting.work()();
    tool.selection().faces.forEach([&](Face f) { QVERIFY(b.document->mesh().isLive(f)); });
  }
}

void SelectToolTest::noHierarchy() {
  Bench b(plates());
  test::WaitingServices waiting;
  SelectTool tool(*b.document, waiting.services());
  for (const double mode : {kClick, kBrush, kLasso, kConnected, kAngle}) {
    tool.setSetting("mode", mode);
    for (const Kind kind : {Kind::Hover, Kind::Press, Kind::Drag, Kind::Release, Kind::DoubleClick, Kind::Leave})
      tool.pointer(test::above(kind, 3.2, 4.8));
  }
  QVERIFY(tool.selection().empty());
  tool.perform("all");
  QCOMPARE(tool.selection().faces.count(), std::size_t(400));
}

QTEST_GUILESS_MAIN(SelectToolTest)
#include "SelectToolTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "ToolEvents.h"
#include "mesh/selection/RegionGrowing.h"
#include "tools/mesh/SelectTool.h"

#include <QElapsedTimer>
#include <QTest>

using namespace handwheel;
using test::Kind;

// Measures the time of selecting on a million faces. The times are only printed; the selections are checked.
class SelectCostTest : public QObject {
  Q_OBJECT

 private slots:
  void onAMillionFaces();
};

namespace {

class Report {
 public:
  // The longest of several calls.
  template <class Call>
  void tell(const char* what, int times, Call call) {
    double longest = 0.0, sum = 0.0;
    for (int i = 0; i < times; ++i) {
      QElapsedTimer timer;
      timer.start();
      call(i);
      const double taken = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
      longest = std::max(longest, taken);
      sum += taken;
    }
    qInfo("%-48s mean %8.3f ms, longest %8.3f ms", what, sum / times, longest);
  }
};

}  // namespace

void SelectCostTest::onAMillionFaces() {
  const double large = 100.0, small = 40.0;
  const auto document = test::meshDocument(test::torus(1000, 500, large, small));
  const HalfEdgeMesh& mesh = document->mesh();
  QCOMPARE(mesh.faceSlots(), std::size_t(1'000'000));
  Report report;
  std::shared_ptr<const FaceHierarchy> faces;
  report.tell("hierarchy", 1, [&](int) { faces = std::make_shared<FaceHierarchy>(mesh); });
  MeshServices services = immediateServices(*document);
  services.faces = [&] { return faces; };
  SelectTool tool(*document, services);
  const auto along = [&](Kind kind, int i) {
    const double u = 0.005 * i;
    return test::above(kind, large * std::cos(u), large * std::sin(u));
  };

  report.tell("hover, click mode", 500, [&](int i) { tool.pointer(along(Kind::Hover, i)); });
  tool.setSetting("mode", 1.0);
  tool.setSetting("brush_unit", 0.0);
  tool.setSetting("brush_length", 5.0);
  report.tell("brush of 5 mm: press", 1, [&](int) { tool.pointer(along(Kind::Press, 0)); });
  // An annulus of about 10 mm width and 500 · 0.5 mm length, in triangles of 0.16 mm² at the top of the torus.
  report.tell("brush of 5 mm: drag by 0.5 mm", 500, [&](int i) { tool.pointer(along(Kind::Drag, i)); });
  report.tell("preview()", 100, [&](int) { tool.preview(); });
  tool.pointer(along(Kind::Release, 500));
  const double area = 10.0 * 250.0;
  QVERIFY(std::abs(tool.selection().faces.count() / (area / (M_PI * M_PI * 4 * large * small / 1e6)) - 1.0) < 0.1);
  report.tell("brush of 5 mm: drag by 20 mm", 20, [&](int i) {
    if (i == 0) tool.pointer(along(Kind::Press, 0));
    tool.pointer(along(Kind::Drag, 40 * i));
  });
  tool.perform("revert");

  const auto around = [&](double half) {
    tool.pointer(test::above(Kind::Press, -half, -half));
    for (int i = 1; i < 400; ++i) {
      const double t = 2.0 * half * (i % 100) / 100.0 - half;
      const double x[] = {t, half, -t, -half}, y[] = {-half, t, half, -t};
      tool.pointer(test::above(Kind::Drag, x[i / 100], y[i / 100]));
    }
    tool.pointer(test::above(Kind::Release, -half, -half + 0.1));
  };
  tool.setSetting("mode", 2.0);
  tool.setSetting("through", true);
  report.tell("lasso around all, through", 3, [&](int) { around(150.0); });
  QCOMPARE(tool.selection().faces.count(), std::size_t(1'000'000));
  tool.setSetting("through", false);
  report.tell("lasso around all, what is visible", 1, [&](int) { around(150.0); });
  QVERIFY(std::abs(double(tool.selection().faces.count()) - 500'000.0) < 3'000.0);  // the upper half
  report.tell("lasso around its middle, what is visible", 3, [&](int) { around(73.0); });

  tool.setSetting("mode", 3.0);
  report.tell("connected: all", 3, [&](int) {
    tool.pointer(along(Kind::Press, 0));
    tool.pointer(along(Kind::Release, 0));
  });
  QCOMPARE(tool.selection().faces.count(), std::size_t(1'000'000));
  report.tell("hover, too many to show", 100, [&](int i) { tool.pointer(along(Kind::Hover, i)); });
  tool.setSetting("mode", 4.0);
  tool.setSetting("angle", 0.5);
  report.tell("angle: all", 1, [&](int) {
    tool.pointer(along(Kind::Press, 0));
    tool.pointer(along(Kind::Release, 0));
  });
  QCOMPARE(tool.selection().faces.count(), std::size_t(1'000'000));
  report.tell("shrink all", 1, [&](int) { tool.perform("shrink"); });
  report.tell("invert", 3, [&](int) { tool.perform("invert"); });
  report.tell("all", 3, [&](int) { tool.perform("all"); });
  HalfEdgeMesh changed = mesh;
  report.tell("delete 1000 faces (on a worker)", 1,
              [&](int) { removeFaces(changed, FaceSelection::where(1000, [](Face) { return true; })); });
  QCOMPARE(changed.liveFaceCount(), std::size_t(999'000));
  report.tell("document changed", 1, [&](int) { tool.documentChanged(); });
}

HANDWHEEL_TEST(SelectCostTest)
#include "SelectCostTest.moc"

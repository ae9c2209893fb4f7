// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FillServices.h"
#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "ToolEvents.h"
#include "mesh/selection/RegionGrowing.h"
#include "mesh/structure/MeshValidator.h"
#include "tools/ToolRunner.h"
#include "tools/mesh/MakeFaceTool.h"
#include "tools/mesh/MeshPreview.h"
#include "tools/mesh/SelectTool.h"
#include "tools/mesh/boundary/BoundaryTool.h"
#include "tools/mesh/sculpt/SculptTool.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;
using test::Kind;

// Tests tools with random inputs in random order.
class ToolSessionsTest : public QObject {
  Q_OBJECT

 private slots:
  void randomSessions();
  void sessionsOnOddModels_data();
  void sessionsOnOddModels();
};

namespace {

class Session {
 public:
  Session(const TriangleSoup& soup, unsigned seed) : m_random(seed), m_document(test::meshDocument(soup)) {
    const Box box = m_document->defects().box;
    if (!box.isEmpty()) {
      m_middle = box.center();
      m_size = std::max(box.diagonal().norm(), 1e-300);
    }
    m_failed = QObject::connect(&m_runner, &ToolRunner::failed, [this](const QString& why) { m_problem = why; });
  }

  // The first thing that is wrong, or nothing.
  std::string run(int steps) {
    QUndoStack& history = *m_document->history();
    history.setIndex(0);  // before opening has turned faces over, which is a step
    const HalfEdgeMesh before = m_document->mesh();
    history.setIndex(history.count());
    for (int i = 0; i < steps; ++i) {
      step();
      if (const std::string problem = check(); !problem.empty()) return "step " + std::to_string(i) + ": " + problem;
    }
    m_runner.stop();
    history.setIndex(history.count());
    const HalfEdgeMesh after = m_document->mesh();
    history.setIndex(0);
    if (!test::sameMesh(m_document->mesh(), before)) return "undo does not lead back";
    history.setIndex(history.count());
    if (!test::sameMesh(m_document->mesh(), after)) return "redo does not lead forth";
    return {};
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : m_random() % n; }
  double number() {
    constexpr double kOdd[] = {
        0.0, 1e-300, 1e300, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
    if (below(40) == 0) return kOdd[below(std::size(kOdd))];
    return std::uniform_real_distribution<double>(-1.0, 1.0)(m_random);
  }
  Vec3 vector() { return {number(), number(), number()}; }

  void step() {
    if (!m_runner.tool()) return start();
    switch (below(12)) {
      case 0:
      case 4:
        return perform();
      case 1:
        return set();
      case 2:
        if (below(2))
          m_document->history()->undo();
        else
          m_document->history()->redo();
        return;
      case 3:
        if (below(6) == 0) start();
        return;
      default:
        return point();
    }
  }

  void start() {
    m_fill = nullptr;
    m_select = nullptr;
    const std::size_t which = below(6);
    m_mayPointerEdit = which >= 3;
    if (which == 3) {
      m_runner.start(std::make_unique<BoundaryTool>(*m_document, immediateServices(*m_document)), *m_document);
    } else if (which == 4) {
      m_runner.start(std::make_unique<MakeFaceTool>(*m_document, immediateServices(*m_document)), *m_document);
    } else if (which == 5) {
      const auto n = static_cast<Face>(m_document->mesh().faceSlots());
      const FaceSelection patch =
          below(3) == 0 || n == 0 ? FaceSelection() : FaceSelection{static_cast<Face>(below(n))};
      m_runner.start(std::make_unique<SculptTool>(*m_document, immediateServices(*m_document),
                                                  grownByRing(m_document->mesh(), patch)),
                     *m_document);
    } else if (which == 0) {
      auto tool = std::make_unique<FillHoleTool>(*m_document, test::fillServices(*m_document, m_fill));
      m_fill = tool.get();
      m_runner.start(std::move(tool), *m_document);
    } else {
      const HalfEdgeMesh& mesh = m_document->mesh();
      const auto some =
          FaceSelection::where(mesh.faceSlots(), [&](Face f) { return mesh.isLive(f) && below(10) == 0; });
      auto tool = std::make_unique<SelectTool>(*m_document, immediateServices(*m_document), MeshSelection{some, {}});
      m_select = tool.get();
      m_runner.start(std::move(tool), *m_document);
    }
  }

  void point() {
    PointerEvent event;
    event.kind = static_cast<Kind>(below(6));
    if (below(3) != 0) event.kind = m_isDown ? (below(4) ? Kind::Drag : Kind::Release) : Kind::Press;
    m_isDown = event.kind == Kind::Press || event.kind == Kind::Drag;
    event.button = below(8) == 0 ? static_cast<PointerButton>(below(3)) : PointerButton::First;
    event.modifiers = {below(4) == 0, below(4) == 0, false};
    const Vec3 target = below(3) ? m_middle + 0.4 * m_size * vector() : borderPoint();
    event.ray.origin = m_isPerspective ? m_eye : Vec3(target - 5.0 * m_size * Vec3(0.1, 0.2, -1.0));
    event.ray.direction = (target - event.ray.origin).normalized();
    if (below(60) == 0) event.ray.direction = vector();
    if (m_isPerspective) event.eye = m_eye;
    event.pixel = 0.005 * m_size;
    event.focus = m_isPerspective ? 4.0 * m_size : 0.0;
    if (!m_isDown && below(10) == 0) {
      m_isPerspective = !m_isPerspective;
      m_eye = m_middle + 4.0 * m_size * Vec3(below(2) ? 0.3 : 1.0, 0.1, below(2) ? 1.0 : -0.4);
    }
    const std::uint64_t revision = m_document->revision();
    m_runner.pointer(event);
    if (!m_mayPointerEdit && m_document->revision() != revision) m_problem = "the pointer changed the document";
  }

  // Returns a border point that the tools for edges can grab.
  Vec3 borderPoint() {
    const auto& loops = m_document->defects().loops;
    if (loops.empty()) return m_middle;
    const auto& loop = loops[below(loops.size())].halfEdges;
    return m_document->mesh().position(m_document->mesh().from(loop[below(loop.size())]));
  }

  void perform() {
    const std::vector<ToolAction> actions = m_runner.tool()->actions();
    const std::string declared = actions[below(actions.size())].id;
    std::string wanted = declared;
    if (below(2) && !m_mayPointerEdit)
      wanted = m_select ? "delete" : below(3) ? "commit" : "next";  // edits are more frequent
    // Deleting all would end the fun too soon.
    if (wanted == "delete" && m_select && 2 * m_select->selection().faces.count() > m_document->mesh().liveFaceCount())
      return;
    m_runner.perform(below(2) ? wanted : declared);
  }

  void set() {
    const std::vector<Property> settings = m_runner.tool()->settings();
    const Property& property = settings[below(settings.size())];
    const std::size_t kind = below(20);
    if (kind == 0) return m_runner.setSetting(property.id, number());
    if (kind == 1) return m_runner.setSetting(property.id, std::string("?"));
    if (!property.choices.empty()) return m_runner.setSetting(property.id, double(below(property.choices.size())));
    if (std::holds_alternative<bool>(property.value)) return m_runner.setSetting(property.id, below(2) == 0);
    m_runner.setSetting(property.id,
                        std::abs(number()) * (property.quantity == Quantity::Number ? 40.0 : 0.1 * m_size));
  }

  std::string check() {
    if (!m_problem.isNull()) return m_problem.toStdString();
    const HalfEdgeMesh& mesh = m_document->mesh();
    if (m_document->revision() != m_checked) {
      if (const std::string broken = validate(mesh); !broken.empty()) return broken;
      m_checked = m_document->revision();
    }
    if (!m_runner.tool()) return {};
    const MeshPreview preview = meshPreviewOf(m_runner.tool()->preview());
    const auto isLive = [&](Face f) { return f < mesh.faceSlots() && mesh.isLive(f); };
    bool live = true;
    for (const FaceSelection* shown : {&preview.highlighted, &preview.selected})
      shown->forEach([&](Face f) { live = live && isLive(f); });
    return live ? "" : "a face is shown that is not there";
  }

  std::mt19937 m_random;
  std::unique_ptr<MeshDocument> m_document;
  FillHoleTool* m_fill = nullptr;
  SelectTool* m_select = nullptr;
  bool m_mayPointerEdit = false;
  ToolRunner m_runner;
  QMetaObject::Connection m_failed;
  QString m_problem;
  std::uint64_t m_checked = 0;
  Vec3 m_middle = Vec3::Zero(), m_eye = Vec3(0, 0, 5);
  double m_size = 1.0;
  bool m_isDown = false, m_isPerspective = false;
};

}  // namespace

void ToolSessionsTest::randomSessions() {
  QVERIFY(rc::check([] {
    const auto seed = *rc::gen::arbitrary<unsigned>();
    const TriangleSoup soup = *rc::gen::element(test::sphereWithHoles(2, 4, 0.4), test::torus(12, 8), test::disc(12, 4),
                                                test::moebiusStrip(16, 3), test::cylinder(12, 5, 1.0, 3.0, false));
    RC_ASSERT(Session(soup, seed).run(150) == "");
  }));
}

void ToolSessionsTest::sessionsOnOddModels_data() {
  QTest::addColumn<TriangleSoup>("soup");
  std::mt19937 random(7);
  QTest::newRow("empty") << TriangleSoup();
  QTest::newRow("one triangle") << TriangleSoup{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()}, {{0, 1, 2}}};
  QTest::newRow("folded triangle") << TriangleSoup{{Vec3::Zero(), Vec3::UnitX()}, {{0, 1, 1}, {0, 0, 0}}};
  QTest::newRow("random soup") << test::randomSoup(random, 60, 4);
  QTest::newRow("blocks") << test::randomBlocks(random, 20, 3);
  QTest::newRow("far") << test::moved(test::sphereWithHoles(2, 4, 0.4), Vec3(1e7, -1e7, 1e7));
  QTest::newRow("tiny") << test::moved(test::sphereWithHoles(2, 4, 0.4), Vec3::Zero(), 1e-6);
  QTest::newRow("huge") << test::moved(test::sphereWithHoles(2, 4, 0.4), Vec3::Zero(), 1e6);
  QTest::newRow("gigantic") << test::moved(test::torus(9, 6), Vec3::Zero(), 1e140);
  TriangleSoup needles = test::cube();
  for (std::size_t f = 0; f < 12; ++f) test::addNeedles(needles, f, int(f % 3), {0.1, 0.5, 0.501});
  QTest::newRow("needles") << needles;
}

void ToolSessionsTest::sessionsOnOddModels() {
  QFETCH(TriangleSoup, soup);
  for (unsigned seed = 0; seed < 40; ++seed) QCOMPARE(Session(soup, seed).run(150), std::string());
}

HANDWHEEL_TEST(ToolSessionsTest)
#include "ToolSessionsTest.moc"

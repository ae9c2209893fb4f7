// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshShapes.h"
#include "ScriptWork.h"
#include "TestClass.h"
#include "ToolEvents.h"
#include "tools/mesh/ManualMeshChanges.h"
#include "tools/mesh/Placement.h"
#include "tools/mesh/ScriptErrors.h"
#include "tools/mesh/sculpt/SculptTool.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;
using test::Kind;
using test::Work;

namespace {

// Somebody at work, who changes their mind now and then. They fill with our own triangulations only: on a sphere, whose
// points are all on one sphere, those of the library are not the very same in every run (about one in a thousand).
class Worker {
 public:
  Worker(Work& work, unsigned seed) : m_work(work), m_random(seed) {}
  void doSomething() {
    QUndoStack& history = *m_work.document->history();
    switch (below(11)) {
      case 0:
      case 1:
        return history.undo();
      case 2:
        return history.redo();
      case 3:
        return commit(deleteChange({randomFace(), randomFace(), randomFace()}, "Delete"));
      case 4:
        return commit(placementChange(randomPlacement()));
      case 5:
        return commit(decimateChange({.faces = 9 * mesh().liveFaceCount() / 10, .avoidIntersections = below(2) == 0}));
      case 6:
        return commit(below(2) ? bridgeChange({openEdge(), openEdge()}) : joinChange({openEdge(), openEdge()}));
      case 7:
        return sculpt();
      default:
        return onALoop();
    }
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : m_random() % n; }
  double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(m_random); }
  const HalfEdgeMesh& mesh() const { return m_work.document->mesh(); }
  Face randomFace() { return static_cast<Face>(below(mesh().faceSlots())); }
  void commit(const MeshChange& change) { m_work.services().commit(change); }

  Placement randomPlacement() {
    Placement placement;
    placement.shift = {number(), 1e3 * number(), 0.0};
    placement.turn = {number(), 0.0, 3.0 * number()};
    placement.scale = 1.0 + 0.1 * number();
    return placement;
  }
  HalfEdge openEdge() {
    const auto& loops = m_work.document->defects().loops;
    if (loops.empty()) return 0;
    const auto& edges = loops[below(loops.size())].halfEdges;
    return edges[below(edges.size())];
  }
  void onALoop() {
    const auto& loops = m_work.document->defects().loops;
    if (loops.empty()) return;
    const std::size_t id = below(loops.size());
    const std::size_t change = below(4);
    if (change == 0) return m_work.document->setKeptOpen(loops[id], !m_work.document->isKeptOpen(loops[id]));
    if (change == 1) return commit(smoothEdgeChange(m_work.key(id), {}));
    if (change == 2) {
      const Vertex v = mesh().from(loops[id].halfEdges[0]);
      return commit(pullChange(v, mesh().position(v) + 0.01 * Vec3(number(), number(), number())));
    }
    FillOptions options;
    constexpr FillMethod kOurs[] = {FillMethod::Ear, FillMethod::Area, FillMethod::Dihedral};
    options.method = kOurs[below(3)];
    options.tryOthers = false;
    m_work.fill(id, options);
  }
  void sculpt() {
    SculptTool tool(*m_work.document, m_work.services(), {randomFace(), randomFace()});
    if (below(2)) tool.perform("whole");
    if (below(2)) tool.perform("noise");
    tool.setSetting("brush", static_cast<double>(below(4)));
    const Vec3 middle = m_work.document->defects().box.center();
    for (const Kind kind : {Kind::Press, Kind::Drag, Kind::Drag, Kind::Release})
      tool.pointer(test::above(kind, middle.x() + 0.3 * number(), middle.y() + 0.3 * number()));
  }

  Work& m_work;
  std::mt19937 m_random;
};

}  // namespace

class MeshScriptSequencesTest : public QObject {
  Q_OBJECT

 private slots:
  void sequences();
  void hostile();
};

// However somebody worked, and whatever they took back: the steps that are left make the same file.
void MeshScriptSequencesTest::sequences() {
  const bool holds = rc::check("sequences", [](unsigned seed) {
    Work work(test::sphereWithHoles(2, 3, 0.35));
    Worker worker(work, seed);
    for (int i = 0; i < 12; ++i) worker.doSomething();
    const std::string problem = test::replayed(work.soup, *work.document);
    RC_ASSERT(problem == std::string());
  });
  QVERIFY(holds);
}

// Lines that nobody wrote: an error, or a step that leaves a sound mesh.
void MeshScriptSequencesTest::hostile() {
  const std::string lines[] = {
      "place --unit in --scale 1.5 --turn 10,20,30 --move 1,2,3",
      "flat",
      "delete 1-20,33",
      "fill 0 --fill minimal --continuity curvature --density 0.5 --piece-edges 40 --bridges 0:7 --ears 1,1,1,2",
      "keep-open 0,v3",
      "repair --open-sheets keep --max-hole 9 --remove-debris --near-weld 1e-3",
      "back 1 --fill ear",
      "cut-and-close 0",
      "debris 7,9",
      "near-vertices 3:4,5:9 --near-weld 0.1",
      "cut-crossings 3:9 --numbers single",
      "decimate --faces 100 --error 0.5 --keep-borders --keep-creases 30 --no-crossings",
      "bridge 3,99",
      "join 30,60",
      "face 1,2,3",
      "pull 3 0.1,0.2,0.3",
      "smooth-edge 0 --wavelength 9 --uneven",
      "stroke drag 3:0,0,1 --by 0,0,0.1 --radius 0.5 --borders --patch 1-9 --level 0",
      "stroke inflate 3:0,0,1 4:0.1,0,1 --radius 0.2 --strength -0.5",
      "subdivide --patch 3,9",
      "smooth-noise --patch 2-30 --angle 20 --borders",
      "smooth-noise --patch 2-30 --method laplace --passes 3",
      "subdivide-mesh --method butterfly --times 2",
      "level-back --patch 3 --finest 1",
      "unit cm"};
  const std::string pieces[] = {"0",          "9",  "-",           ",",     ":",          " ",
                                "v",          "--", "=",           "1e308", "-1",         "nan",
                                "4294967295", "\t", "--patch 1-9", "\xff",  "--finest 1", "--numbers double"};
  std::mt19937 random(7);
  const auto below = [&random](std::size_t n) { return n == 0 ? 0 : random() % n; };
  const TriangleSoup soup = test::sphereWithHoles(2, 3, 0.35);
  auto document = test::meshDocument(soup);
  std::size_t done = 0, refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string line = lines[below(std::size(lines))];
    for (std::size_t k = below(4); k > 0; --k) {
      const std::size_t at = below(line.size() + 1);
      line = line.substr(0, at) + pieces[below(std::size(pieces))] + line.substr(std::min(line.size(), at + below(3)));
    }
    const auto outcome = applyScriptLine(*document, line);
    (outcome ? done : refused) += 1;
    const std::string broken = validate(document->mesh());
    if (!broken.empty()) QFAIL((line + ": " + broken).c_str());
    if (!outcome) QCOMPARE(outcome.error().code, ScriptError::Malformed);
    if (i % 20 == 0) document = test::meshDocument(soup);
  }
  QVERIFY(done > 300 && refused > 300);
}

HANDWHEEL_TEST(MeshScriptSequencesTest)
#include "MeshScriptSequencesTest.moc"

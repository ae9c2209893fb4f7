// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/openmesh/OpenMeshCopy.h"

#include "DoubledEdges.h"
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>
#include <OpenMesh/Tools/Smoother/JacobiLaplaceSmootherT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>
#include <OpenMesh/Tools/Utils/MeshCheckerT.hh>

#include <QTest>
#include <functional>
#include <sstream>

using namespace handwheel;

class OpenMeshCopyTest : public QObject {
  Q_OBJECT

 private slots:
  void emptyAndSmall();
  void extremeCoordinates();
  void hubsTakeLinearTime();
  void refusals_data();
  void refusals();
  void cancelled();
  void littleWorkBetweenPolls();
  void changesComeBack();
  void anyMeshReturns();
};

namespace {

HalfEdgeMesh takenMesh(const TriangleSoup& soup) {
  return buildMesh(soup).mesh;
}

// By OpenMesh's own checker.
std::string checkedByOpenMesh(OpenMeshCopy& copy) {
  std::ostringstream text;
  using Checker = OpenMesh::Utils::MeshCheckerT<OpenMeshSurface>;
  return Checker(copy.surface()).check(Checker::CHECK_ALL, text) ? std::string() : text.str();
}

bool comesBackAlike(const HalfEdgeMesh& mesh) {
  OpenMeshCopy copy;
  HalfEdgeMesh after = mesh;
  return copy.take(mesh) == OpenMeshRefusal::None && checkedByOpenMesh(copy).empty() && copy.bringBack(after) &&
         test::sameMesh(mesh, after);
}

// Returns true if OpenMesh cannot represent a mesh, by counting: an edge consists of two opposite half-edges, or an
// open one.
bool isRefusable(const HalfEdgeMesh& mesh) {
  std::map<std::pair<Vertex, Vertex>, int> edges;
  std::map<std::set<Vertex>, std::set<Face>> facesAt;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    if (!mesh.isProper(f)) return true;
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h)
      if (!mesh.hasOpposite(h) || h < mesh.opposite(h)) ++edges[std::minmax(mesh.from(h), mesh.to(h))];
    facesAt[{mesh.triangle(f).begin(), mesh.triangle(f).end()}].insert(f);
  }
  return std::any_of(edges.begin(), edges.end(), [](const auto& e) { return e.second > 1; }) ||
         std::any_of(facesAt.begin(), facesAt.end(), [](const auto& f) { return f.second.size() > 1; });
}

// Counts what an algorithm reads of a surface, and how much of it between two polls at most.
class CountingSurface : public OpenMeshSurface {
 public:
  template <class... Arguments>
  decltype(auto) property(Arguments&&... arguments) {
    count();
    return OpenMeshSurface::property(std::forward<Arguments>(arguments)...);
  }
  template <class Handle>
  auto next_halfedge_handle(Handle h) const {
    count();
    return OpenMeshSurface::next_halfedge_handle(h);
  }
  template <class Handle>
  auto to_vertex_handle(Handle h) const {
    count();
    return OpenMeshSurface::to_vertex_handle(h);
  }
  template <class Handle>
  bool is_boundary(Handle h) const {
    count();
    return OpenMeshSurface::is_boundary(h);
  }

  void countFor(JobState& job) {
    m_job = &job;
    poll(Progress(job));
  }
  std::size_t reads() const { return m_reads; }
  std::size_t mostBetweenPolls() const { return m_most; }

 private:
  void count() const {
    const std::uint32_t polls = m_job ? m_job->polls.load() : 0;
    m_sincePoll = polls == m_polls ? m_sincePoll + 1 : 0;
    m_polls = polls;
    m_most = std::max(m_most, m_sincePoll);
    ++m_reads;
  }

  JobState* m_job = nullptr;
  mutable std::uint32_t m_polls = 0;
  mutable std::size_t m_reads = 0, m_sincePoll = 0, m_most = 0;
};

struct PollCount {
  std::size_t reads, mostBetweenPolls;
};

PollCount countPolls(const TriangleSoup& soup, const std::function<void(CountingSurface&)>& run) {
  CountingSurface surface;
  for (const Vec3& p : soup.points) surface.add_vertex(openMeshPoint(p));
  for (const Triangle& t : soup.triangles)
    surface.add_face(OpenMesh::VertexHandle(int(t[0])), OpenMesh::VertexHandle(int(t[1])),
                     OpenMesh::VertexHandle(int(t[2])));
  JobState job;
  surface.countFor(job);
  run(surface);
  return {surface.reads(), surface.mostBetweenPolls()};
}

template <class Scheme>
void subdivideOnce(CountingSurface& surface) {
  Scheme scheme;
  scheme(surface, 1);
}

void smoothOnce(CountingSurface& surface, bool isBending) {
  using Smoother = OpenMesh::Smoother::JacobiLaplaceSmootherT<CountingSurface>;
  Smoother smoother(surface);
  smoother.initialize(Smoother::Tangential_and_Normal, isBending ? Smoother::C1 : Smoother::C0);
  smoother.smooth(1);
}

}  // namespace

void OpenMeshCopyTest::emptyAndSmall() {
  QVERIFY(comesBackAlike({}));
  QVERIFY(comesBackAlike(takenMesh({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}})));
  QVERIFY(comesBackAlike(takenMesh(test::tetrahedron())));
  HalfEdgeMesh unused = takenMesh(test::cube());  // dead slots and vertices without faces
  unused.addVertex(Vec3(7, 8, 9));
  unused.removeFace(3);
  unused.removeFace(11);
  QVERIFY(comesBackAlike(unused));
}

void OpenMeshCopyTest::extremeCoordinates() {
  TriangleSoup s = test::tetrahedron();
  constexpr double kMost = std::numeric_limits<double>::max(), kLeast = std::numeric_limits<double>::denorm_min();
  s.points = {Vec3(kMost, -kMost, 0.0), Vec3(-kMost, kLeast, -kLeast), Vec3(1.0, 1.0 + 0x1p-52, 1e-300),
              Vec3(-1e308, 0.1, 1.0 / 3.0)};
  QVERIFY(comesBackAlike(takenMesh(s)));
  HalfEdgeMesh negativeZero = takenMesh(test::cube());
  negativeZero.setPosition(0, Vec3(-0.0, 0.0, -0.0));
  QVERIFY(comesBackAlike(negativeZero));
}

// 200,000 faces at each of two vertices: with the square of that, it would take an hour.
void OpenMeshCopyTest::hubsTakeLinearTime() {
  const HalfEdgeMesh mesh = takenMesh(test::cylinder(200'000, 1, 1.0, 1.0, true));
  OpenMeshCopy copy;  // OpenMesh's checker takes so many neighbours for a broken ring
  QCOMPARE(copy.take(mesh), OpenMeshRefusal::None);
  HalfEdgeMesh after = mesh;
  QVERIFY(copy.bringBack(after));
  QVERIFY(test::sameMesh(mesh, after));
}

void OpenMeshCopyTest::refusals_data() {
  QTest::addColumn<HalfEdgeMesh>("mesh");
  QTest::addColumn<OpenMeshRefusal>("refusal");
  TriangleSoup repeated = test::tetrahedron();
  repeated.triangles.push_back({1, 1, 2});
  QTest::newRow("repeated vertex") << takenMesh(repeated) << OpenMeshRefusal::Degenerate;
  HalfEdgeMesh pillow;
  for (int i = 0; i < 3; ++i) pillow.addVertex(Vec3(i == 1, i == 2, 0));
  pillow.addSlot({0, 1, 2}, {5, 4, 3});
  pillow.addSlot({0, 2, 1}, {2, 1, 0});
  QCOMPARE(validate(pillow), std::string());
  QTest::newRow("back to back") << pillow << OpenMeshRefusal::BackToBack;
  QCOMPARE(validate(test::doubledEdges()), std::string());
  QTest::newRow("doubled edges") << test::doubledEdges() << OpenMeshRefusal::DoubleEdge;
}

void OpenMeshCopyTest::refusals() {
  QFETCH(HalfEdgeMesh, mesh);
  QFETCH(OpenMeshRefusal, refusal);
  OpenMeshCopy copy;
  QVERIFY(isRefusable(mesh));
  QCOMPARE(copy.take(mesh), refusal);
  QCOMPARE(copy.surface().n_faces(), std::size_t{0});  // before anything is built
}

void OpenMeshCopyTest::cancelled() {
  const HalfEdgeMesh mesh = takenMesh(test::icosphere(2));
  OpenMeshCopy copy;
  QCOMPARE(copy.take(mesh), OpenMeshRefusal::None);
  copy.surface().set_point(OpenMesh::VertexHandle(0), {1, 2, 3});
  JobState job;
  job.cancelled = true;
  HalfEdgeMesh after = mesh;
  QVERIFY(!copy.bringBack(after, Progress(job)));
  QVERIFY(test::sameMesh(mesh, after));
}

// A loop that only reads and sets a number of each vertex is quick. All others poll.
void OpenMeshCopyTest::littleWorkBetweenPolls() {
  using namespace OpenMesh::Subdivider::Uniform;
  const TriangleSoup soup = test::torus(300, 200);
  const std::size_t most = 3 * soup.points.size();
  for (const auto& run : std::initializer_list<std::function<void(CountingSurface&)>>{
           subdivideOnce<LoopT<CountingSurface>>, subdivideOnce<Sqrt3T<CountingSurface>>,
           subdivideOnce<ModifiedButterflyT<CountingSurface>>, [](CountingSurface& s) { smoothOnce(s, false); },
           [](CountingSurface& s) { smoothOnce(s, true); }}) {
    const PollCount count = countPolls(soup, run);
    QVERIFY(count.reads > 3 * most);
    QVERIFY2(count.mostBetweenPolls <= most, qPrintable(QString::number(count.mostBetweenPolls)));
  }
}

// A face is split and an edge collapsed by OpenMesh: what stays has its number, what is new comes last.
void OpenMeshCopyTest::changesComeBack() {
  const HalfEdgeMesh before = takenMesh(test::icosphere(1));
  OpenMeshCopy copy;
  QCOMPARE(copy.take(before), OpenMeshRefusal::None);
  OpenMeshSurface& s = copy.surface();
  const auto middle = s.add_vertex({0, 0, 5});
  s.split(OpenMesh::FaceHandle(0), middle);
  HalfEdgeMesh mesh = before;
  QVERIFY(copy.bringBack(mesh));
  QCOMPARE(validate(mesh), std::string());
  QCOMPARE(mesh.faceSlots(), before.faceSlots() + 2);
  QCOMPARE(mesh.vertexSlots(), before.vertexSlots() + 1);
  QCOMPARE(mesh.position(Vertex(before.vertexSlots())), Vec3(0, 0, 5));
  for (Face f = 1; f < before.faceSlots(); ++f) QCOMPARE(mesh.triangle(f), before.triangle(f));
  const auto h = s.halfedge_handle(middle);
  QVERIFY(s.is_collapse_ok(h));
  s.collapse(h);
  QVERIFY(copy.bringBack(mesh = before));
  QCOMPARE(validate(mesh), std::string());
  QCOMPARE(mesh.liveFaceCount(), before.liveFaceCount());
  QCOMPARE(test::eulerCharacteristic(mesh), 2l);
}

void OpenMeshCopyTest::anyMeshReturns() {
  QVERIFY(rc::check("slot for slot and bit for bit, or refused", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const std::vector<TriangleSoup> shapes{test::bumpySphere(2),
                                           test::torus(20, 10),
                                           test::moebiusStrip(20, 4),
                                           test::kleinBottle(12, 8),
                                           test::sphereWithHoles(3, 4, 0.3),
                                           test::twoCubesSharingAnEdge(),
                                           test::boxWithInnerWall(),
                                           test::annulus(20, 4, 1.0, 2.0),
                                           test::randomBlocks(random, 12, 3),
                                           test::randomSoup(random, 60, 4)};
    TriangleSoup soup = *rc::gen::elementOf(shapes);
    const int scale = *rc::gen::inRange(-900, 900);
    for (Vec3& p : soup.points) p = Vec3(std::ldexp(p.x(), scale), std::ldexp(p.y(), scale), std::ldexp(p.z(), scale));
    HalfEdgeMesh mesh = takenMesh(soup);
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
      const Face f = Face(random() % mesh.faceSlots());
      if (mesh.isLive(f)) mesh.removeFace(f);
    }
    relink(mesh);  // a vertex may have lost the faces between two fans
    if (*rc::gen::arbitrary<bool>()) {
      for (Face f = 0; f < mesh.faceSlots(); ++f)
        if (mesh.isLive(f) && !mesh.isProper(f)) mesh.removeFace(f);
    }
    RC_ASSERT(validate(mesh) == std::string());
    if (isRefusable(mesh)) {
      OpenMeshCopy copy;
      RC_ASSERT(copy.take(mesh) != OpenMeshRefusal::None);
    } else {
      RC_ASSERT(comesBackAlike(mesh));
    }
  }));
}

HANDWHEEL_TEST(OpenMeshCopyTest)
#include "OpenMeshCopyTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/LargestDistance.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/simplify/Decimation.h"
#include "mesh/structure/MeshBuilder.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <QElapsedTimer>
#include <QTest>
#include <random>

using namespace handwheel;

// The bound is never below the distance of any point of either surface, and hardly above the largest.
class LargestDistanceTest : public QObject {
  Q_OBJECT

 private slots:
  void knownDistances();
  void coincidingSurfaces();
  void decimated_data();
  void decimated();
  void withinTheError();
  void nothingToMeasure();
};

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Surface>>>;

Kernel::Point_3 pointOf(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

// Returns the largest distance of samples of one surface from the other one, by CGAL: steps² / 2 on each triangle.
double sampledFrom(const TriangleSoup& a, const TriangleSoup& b, int steps) {
  Surface surface;
  for (const Triangle& t : b.triangles) {
    std::array<Surface::Vertex_index, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = surface.add_vertex(pointOf(b.points[t[k]]));
    surface.add_face(corners[0], corners[1], corners[2]);
  }
  const Tree tree(faces(surface).begin(), faces(surface).end(), surface);
  double largest = 0.0;
  for (const Triangle& t : a.triangles) {
    const Vec3 &p = a.points[t[0]], &q = a.points[t[1]], &r = a.points[t[2]];
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= steps - i; ++j) {
        const Vec3 at = p + (q - p) * i / steps + (r - p) * j / steps;
        largest = std::max(largest, tree.squared_distance(pointOf(at)));
      }
    }
  }
  return std::sqrt(largest);
}

// A distance and how far a point may be from the next sample.
struct Sampled {
  double distance = 0.0;
  double between = 0.0;
};

Sampled sampled(const HalfEdgeMesh& a, const HalfEdgeMesh& b) {
  const TriangleSoup first = a.compact().soup, second = b.compact().soup;
  Sampled result;
  const auto add = [&](const TriangleSoup& s, const TriangleSoup& other) {
    const int steps = std::max(3, static_cast<int>(std::sqrt(15'000.0 / static_cast<double>(s.triangles.size()))));
    result.distance = std::max(result.distance, sampledFrom(s, other, steps));
    for (const Triangle& t : s.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        result.between = std::max(result.between, (s.points[t[k]] - s.points[t[(k + 1) % 3]]).norm() / steps);
  };
  add(first, second);
  add(second, first);
  return result;
}

TriangleSoup flatSheet(std::uint32_t n, double height) {
  return test::grid(n + 1, n + 1, false, false,
                    [=](std::uint32_t i, std::uint32_t j) { return Vec3(double(i) / n, double(j) / n, height); });
}

TriangleSoup noisy(TriangleSoup s, double size) {
  std::mt19937 random(61);
  std::uniform_real_distribution<double> noise(-size, size);
  for (Vec3& p : s.points) p += Vec3(noise(random), noise(random), noise(random));
  return s;
}

double boundOf(const TriangleSoup& a, const TriangleSoup& b) {
  return largestDistance(buildMesh(a).mesh, buildMesh(b).mesh).value_or(-1.0);
}

}  // namespace

void LargestDistanceTest::knownDistances() {
  const auto isBound = [](double bound, double exact) {
    return bound >= exact && bound <= (1.0 + kLargestDistanceSlack) * exact * (1.0 + 1e-9);
  };
  QVERIFY(isBound(boundOf(flatSheet(7, 0.0), flatSheet(3, 0.25)), 0.25));
  // Pyramids of this height on a sheet, at a vertex of either mesh.
  TriangleSoup bumpy = flatSheet(8, 0.0);
  bumpy.points[4 * 9 + 4].z() = 0.0375;
  QVERIFY(isBound(boundOf(bumpy, flatSheet(5, 0.0)), 0.0375));
  QVERIFY(isBound(boundOf(flatSheet(5, 0.0), bumpy), 0.0375));
  // A triangle over a slot of 0.2: its corners and its middle are over the ground, the farthest point is over the
  // middle of the slot.
  TriangleSoup ground = flatSheet(1, 0.0);
  test::append(ground, test::moved(flatSheet(1, 0.0), Vec3(1.2, 0, 0)));
  TriangleSoup covered = ground;
  test::append(covered, {{Vec3(0.1, 0.1, 0), Vec3(2.1, 0.1, 0), Vec3(0.1, 0.9, 0)}, {{0, 1, 2}}});
  QVERIFY(isBound(boundOf(covered, ground), 0.1));
  // Two boxes, one inside the other: a corner of the outer one, √3 away.
  QVERIFY(isBound(boundOf(test::cube(4.0), test::cube(2.0, Vec3(1, 1, 1))), std::sqrt(3.0)));
  // Far from the origin, too: there coordinates have steps of 1.2e-10.
  const Vec3 far(1e6, -1e6, 1e6);
  QVERIFY(isBound(boundOf(test::moved(bumpy, far), test::moved(flatSheet(5, 0.0), far)), 0.0375 - 1e-9));
}

// Other triangles of the same planes: no distance but rounding.
void LargestDistanceTest::coincidingSurfaces() {
  QVERIFY(boundOf(flatSheet(40, 0.0), flatSheet(7, 0.0)) < 1e-14);
  QVERIFY(boundOf(flatSheet(150, 1.0), flatSheet(1, 1.0)) < 1e-14);
  const TriangleSoup ball = test::icosphere(4);
  QVERIFY(boundOf(ball, ball) < 1e-14);
}

void LargestDistanceTest::decimated_data() {
  QTest::addColumn<int>("shape");
  QTest::addColumn<int>("faces");
  QTest::addColumn<bool>("isQuadric");
  QTest::addColumn<bool>("keepBorders");
  const char* const shapes[] = {"noisy ball", "torus", "sheet", "bumpy ball", "random blocks"};
  for (int shape = 0; shape < 5; ++shape) {
    for (const bool isQuadric : {false, true}) {
      for (const int faces : {isQuadric ? 200 : 40}) {
        QTest::addRow("%s, %s, %d", shapes[shape], isQuadric ? "quadric" : "bounded", faces)
            << shape << faces << isQuadric << (shape == 2);
      }
    }
  }
}

void LargestDistanceTest::decimated() {
  QFETCH(int, shape);
  QFETCH(int, faces);
  QFETCH(bool, isQuadric);
  QFETCH(bool, keepBorders);
  std::mt19937 random(7);
  const TriangleSoup soup = shape == 0   ? noisy(test::icosphere(4), 0.02)
                            : shape == 1 ? test::torus(60, 30)
                            : shape == 2 ? noisy(flatSheet(30, 0.0), 0.01)
                            : shape == 3 ? test::bumpySphere(3)
                                         : test::randomBlocks(random, 60, 5);
  const HalfEdgeMesh before = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = before;
  const DecimationReport report =
      decimate(mesh, {.faces = std::size_t(faces),
                      .keepBorders = keepBorders,
                      .method = isQuadric ? DecimationMethod::Quadric : DecimationMethod::Bounded,
                      .measureDistance = true});
  if (report.refusal != OpenMeshRefusal::None) return;
  QVERIFY(report.largestDistance);
  const auto [found, between] = sampled(mesh, before);
  QVERIFY2(found <= *report.largestDistance, qPrintable(QString("%1 > %2").arg(found).arg(*report.largestDistance)));
  QVERIFY2(*report.largestDistance <= (1.0 + kLargestDistanceSlack) * (found + between) + 1e-12,
           qPrintable(QString("%1 << %2").arg(found).arg(*report.largestDistance)));
}

void LargestDistanceTest::withinTheError() {
  for (const double error : {1e-4, 0.01, 0.1}) {
    for (const TriangleSoup& soup :
         {noisy(test::icosphere(3), 0.02), test::torus(40, 20), noisy(flatSheet(20, 0), 0.01)}) {
      const HalfEdgeMesh before = buildMesh(soup).mesh;
      HalfEdgeMesh mesh = before;
      const DecimationReport report = decimate(mesh, {.error = error});
      QVERIFY(report.largestDistance && *report.largestDistance <= error);
      QVERIFY(sampled(mesh, before).distance <= *report.largestDistance + 1e-14);  // the rounding of the samples
    }
  }
}

void LargestDistanceTest::nothingToMeasure() {
  const HalfEdgeMesh cube = buildMesh(test::cube()).mesh;
  QVERIFY(!largestDistance(cube, HalfEdgeMesh()));
  QVERIFY(!largestDistance(HalfEdgeMesh(), cube));
  JobState job;
  job.cancelled = true;
  QVERIFY(!largestDistance(cube, cube, Progress(job)));
}

HANDWHEEL_TEST(LargestDistanceTest)
#include "LargestDistanceTest.moc"

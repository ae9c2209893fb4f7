// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/selection/Lasso.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>
#include <cmath>

using namespace handwheel;

class LassoTest : public QObject {
  Q_OBJECT

 private slots:
  void agreesWithLookingAtEach();
  void twoPlates();
  void onlyWholeFaces();
  void notBehindTheEye();
  void sameInEverySizeAndPosition();
  void degenerateFaces();
  void extremes();
  void endsEarly();
};

namespace {

// A viewer, by the plain formulas of a camera.
struct Camera {
  Vec3 position, forward, right, up;
  bool perspective;

  Eigen::Vector2d onScreen(const Vec3& p) const {
    const Vec3 r = p - position;
    const double depth = perspective ? r.dot(forward) : 1.0;
    return Eigen::Vector2d(r.dot(right) / depth, r.dot(up) / depth);
  }
  Ray rayAt(const Eigen::Vector2d& point) const {
    const Vec3 aside = point.x() * right + point.y() * up;
    return perspective ? Ray{position, (forward + aside).normalized()} : Ray{position + aside, forward};
  }
};

Camera cameraAt(const Vec3& position, const Vec3& target, bool perspective) {
  Camera camera{position, (target - position).normalized(), {}, {}, perspective};
  camera.right = camera.forward.cross(Vec3(0.3, 0.2, 0.9)).normalized();
  camera.up = camera.right.cross(camera.forward);
  return camera;
}

Lasso lassoOf(const Camera& camera, const std::vector<Eigen::Vector2d>& polygon, bool through) {
  Lasso lasso;
  for (const auto& p : polygon) lasso.rays.push_back(camera.rayAt(p));
  if (camera.perspective) lasso.eye = camera.position;
  lasso.through = through;
  return lasso;
}

bool encloses(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d a = polygon[i] - p, b = polygon[(i + 1) % polygon.size()] - p;
    sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::lround(sum / (2.0 * M_PI)) % 2 != 0;
}

// Tests by Cramer's rule if the line from p along the direction meets the triangle.
bool isCovered(const Vec3& p, const Vec3& direction, const TrianglePoints& t) {
  Eigen::Matrix3d m;
  m << t[1] - t[0], t[2] - t[0], -direction;
  const Vec3 x = m.inverse() * (p - t[0]);
  return x.x() >= 0.0 && x.y() >= 0.0 && x.x() + x.y() <= 1.0 && x.z() > 0.0;
}

bool isVisible(const HalfEdgeMesh& mesh, Face f, const Camera& camera) {
  const TrianglePoints t = mesh.points(f);
  const Vec3 centre = (t[0] + t[1] + t[2]) / 3.0;
  const Vec3 towardsViewer = camera.perspective ? Vec3(camera.position - centre) : Vec3(-camera.forward);
  if ((t[1] - t[0]).cross(t[2] - t[0]).dot(towardsViewer) < 0.0) return false;
  for (Face g = 0; g < mesh.faceSlots(); ++g)
    if (g != f && isCovered(centre, towardsViewer, mesh.points(g))) return false;
  return true;
}

HalfEdgeMesh twoPlates(double size, double gap) {
  const auto plate = [&](double z) {
    return test::grid(9, 9, false, false, [&](std::uint32_t i, std::uint32_t j) {
      return Vec3(size * (i / 8.0 - 0.5), size * (j / 8.0 - 0.5), z);
    });
  };
  TriangleSoup soup = plate(0.0);
  test::append(soup, plate(gap));
  return buildMesh(soup).mesh;
}

const std::vector<Eigen::Vector2d> kSquare = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

std::vector<Eigen::Vector2d> square(double half) {
  std::vector<Eigen::Vector2d> result = kSquare;
  for (auto& p : result) p *= half;
  return result;
}

}  // namespace

void LassoTest::agreesWithLookingAtEach() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const TriangleSoup soup =
        *rc::gen::element(test::bumpySphere(2), test::torus(16, 10), test::sphereWithHoles(2, 4, 0.4));
    const HalfEdgeMesh mesh = buildMesh(soup).mesh;
    const bool perspective = random() % 2, through = random() % 2;
    const Vec3 position = Vec3(unit(random), unit(random), unit(random)).normalized() * 6.0;
    const Camera camera = cameraAt(position, Vec3(unit(random), unit(random), 0.0) * 0.3, perspective);
    std::vector<Eigen::Vector2d> polygon(3 + random() % 12);
    for (auto& p : polygon) p = (perspective ? 0.6 : 3.0) * Eigen::Vector2d(unit(random), unit(random));
    const auto selected = facesInLasso(FaceHierarchy(mesh), lassoOf(camera, polygon, through));
    RC_ASSERT(selected.has_value());
    for (Face f = 0; f < mesh.faceSlots(); ++f) {
      const auto points = mesh.points(f);
      const bool inside = std::all_of(points.begin(), points.end(),
                                      [&](const Vec3& p) { return encloses(polygon, camera.onScreen(p)); });
      RC_ASSERT(selected->contains(f) == (inside && (through || isVisible(mesh, f, camera))));
    }
  }));
}

void LassoTest::twoPlates() {
  const HalfEdgeMesh mesh = ::twoPlates(8.0, 1.0);
  const FaceHierarchy faces(mesh);
  for (const bool perspective : {false, true}) {
    const Camera above = cameraAt(Vec3(0.01, 0.02, 100.0), Vec3(0.01, 0.02, 0.0), perspective);
    const Camera below = cameraAt(Vec3(0.01, 0.02, -100.0), Vec3(0.01, 0.02, 0.0), perspective);
    const auto polygon = square(perspective ? 0.1 : 10.0);
    QCOMPARE(facesInLasso(faces, lassoOf(above, polygon, true))->count(), std::size_t(256));
    const FaceSelection upper = *facesInLasso(faces, lassoOf(above, polygon, false));
    QCOMPARE(upper.count(), std::size_t(128));
    upper.forEach([](Face f) { QVERIFY(f >= 128); });
    // From below one sees backs only.
    QCOMPARE(facesInLasso(faces, lassoOf(below, polygon, true))->count(), std::size_t(256));
    QVERIFY(facesInLasso(faces, lassoOf(below, polygon, false))->empty());
  }
}

// A lasso that runs through the outer cells leaves them out.
void LassoTest::onlyWholeFaces() {
  const FaceHierarchy faces(::twoPlates(8.0, 1.0));
  const Camera above{Vec3(0, 0, 10), -Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY(), false};
  QCOMPARE(facesInLasso(faces, lassoOf(above, square(3.5), false))->count(), std::size_t(2 * 6 * 6));
  QCOMPARE(facesInLasso(faces, lassoOf(above, square(0.5), false))->count(), std::size_t(0));
}

void LassoTest::notBehindTheEye() {
  const FaceHierarchy faces(::twoPlates(8.0, 10.0));
  const Camera between{Vec3(0, 0, 5), -Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY(), true};
  const FaceSelection seen = *facesInLasso(faces, lassoOf(between, square(2.0), true));
  QCOMPARE(seen.count(), std::size_t(128));
  seen.forEach([](Face f) { QVERIFY(f < 128); });
  // Without perspective there is no eye to be behind.
  const Camera flat{between.position, between.forward, between.right, between.up, false};
  QCOMPARE(facesInLasso(faces, lassoOf(flat, square(9.0), true))->count(), std::size_t(256));
}

void LassoTest::sameInEverySizeAndPosition() {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    for (const double far : {0.0, 1e7}) {
      const Vec3 middle = far * scale * Vec3(1, 1, 1);
      TriangleSoup soup = ::twoPlates(8.0, 1.0).compact().soup;
      const FaceHierarchy faces(buildMesh(test::moved(soup, middle, scale)).mesh);
      for (const bool perspective : {false, true}) {
        const Camera camera = cameraAt(middle + scale * Vec3(0, 0, 100), middle, perspective);
        const auto polygon = square(perspective ? 0.1 : 10.0 * scale);
        QCOMPARE(facesInLasso(faces, lassoOf(camera, polygon, false))->count(), std::size_t(128));
      }
    }
  }
}

// A needle has no back; a folded face is inside when its corners are. Nothing but what hides them leaves them out.
void LassoTest::degenerateFaces() {
  TriangleSoup soup = test::cube();
  test::addNeedles(soup, 2, 0, {0.5});  // the side z = 1
  soup.triangles.push_back({4, 4, 5});
  const FaceHierarchy faces(buildMesh(soup).mesh);
  const Camera above = cameraAt(Vec3(0.5, 0.5, 9.0), Vec3(0.5, 0.5, 0.0), false);
  const FaceSelection seen = *facesInLasso(faces, lassoOf(above, square(3.0), false));
  for (const Face f : {2u, 3u, 12u, 13u, 14u}) QVERIFY(seen.contains(f));
  QVERIFY(!seen.contains(0) && !seen.contains(1));
  QCOMPARE(facesInLasso(faces, lassoOf(above, square(3.0), true))->count(), std::size_t(15));
}

void LassoTest::extremes() {
  const double nan = std::nan("");
  const FaceHierarchy faces(::twoPlates(8.0, 1.0));
  const Camera above = cameraAt(Vec3(0, 0, 100), Vec3(0, 0, 0), false);
  Lasso lasso = lassoOf(above, square(10.0), true);
  lasso.rays.push_back({Vec3(nan, 0, 0), Vec3::UnitX()});
  lasso.rays.push_back({Vec3(50, 0, 0), Vec3::Zero()});
  QCOMPARE(facesInLasso(faces, lasso)->count(), std::size_t(256));
  QVERIFY(facesInLasso(FaceHierarchy(HalfEdgeMesh()), lasso)->empty());
  lasso.eye = Vec3(nan, nan, nan);
  QVERIFY(facesInLasso(faces, lasso)->empty());
  lasso.eye = Vec3(0, 0, 100);
  lasso.rays = {{*lasso.eye, Vec3::UnitX()}, {*lasso.eye, -Vec3::UnitX()}, {*lasso.eye, Vec3::UnitZ()}};
  QVERIFY(facesInLasso(faces, lasso)->empty());  // no viewer sees these at once
  lasso.rays = {{*lasso.eye, Vec3::UnitX()}, {*lasso.eye, -Vec3::UnitX()}};
  QVERIFY(facesInLasso(faces, lasso)->empty());
  QVERIFY(facesInLasso(faces, {})->empty());
}

void LassoTest::endsEarly() {
  const FaceHierarchy faces(::twoPlates(8.0, 1.0));
  JobState state;
  state.cancelled = true;
  const Camera above = cameraAt(Vec3(0, 0, 100), Vec3(0, 0, 0), false);
  QVERIFY(!facesInLasso(faces, lassoOf(above, square(10.0), false), Progress(state)));
}

HANDWHEEL_TEST(LassoTest)
#include "LassoTest.moc"

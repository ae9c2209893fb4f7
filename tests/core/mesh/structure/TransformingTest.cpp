// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/Transforming.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class TransformingTest : public QObject {
  Q_OBJECT

 private slots:
  void inversesCancel();
  void volumeFollowsTheDeterminant();
  void turnedTwiceIsTheSame();
  void refusals();
  void units();
  void principalAxes();
  void principalAxesDoNotDependOnThePose();
  void standsOnItsLargestFace();
  void flatButNotToStandOn();
  void feetCountTogether();
  void sliversDoNotTiltTheFace();
  void nothingFlat();
  void box();
  void nothing();
};

namespace {

double number(double reach) {
  return reach * *rc::gen::inRange(-10000, 10001) / 10000.0;
}

Pose randomPose() {
  const Vec3 axis(number(1.0), number(1.0), number(1.0));
  const Vec3 direction = axis.norm() > 0.1 ? Vec3(axis.normalized()) : Vec3(Vec3::UnitX());
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(number(M_PI), direction).toRotationMatrix();
  pose.translation() = Vec3(number(100.0), number(100.0), number(100.0));
  return pose;
}

TriangleSoup soupOf(const HalfEdgeMesh& mesh) {
  return mesh.compact().soup;
}

void move(HalfEdgeMesh& mesh, const Pose& pose) {
  if (!transform(mesh, Eigen::Affine3d(pose))) qFatal("a pose is refused");
}

Box boxOf(const HalfEdgeMesh& mesh) {
  Box box;
  for (const Vec3& p : soupOf(mesh).points) box.extend(p);
  return box;
}

double largestGap(const HalfEdgeMesh& a, const HalfEdgeMesh& b) {
  double largest = 0.0;
  for (Vertex v = 0; v < a.vertexSlots(); ++v) largest = std::max(largest, (a.position(v) - b.position(v)).norm());
  return largest;
}

HalfEdgeMesh brick(const Vec3& size) {
  TriangleSoup soup = test::cube();
  for (Vec3& p : soup.points) p = p.cwiseProduct(size);
  return buildMesh(soup).mesh;
}

}  // namespace

void TransformingTest::inversesCancel() {
  const HalfEdgeMesh original = buildMesh(test::sphereWithHoles(2, 2, 0.4)).mesh;
  QVERIFY(rc::check("a transform and its inverse leave everything as it was", [&] {
    Eigen::Affine3d by(randomPose());
    const auto factor = [] { return (*rc::gen::arbitrary<bool>() ? -1.0 : 1.0) * (0.1 + std::abs(number(5.0))); };
    const double x = factor(), y = factor(), z = factor();
    by = by * Eigen::Scaling(x, y, z);
    HalfEdgeMesh mesh = original;
    RC_ASSERT(bool(transform(mesh, by)));
    RC_ASSERT(validate(mesh) == std::string());
    RC_ASSERT(test::countBorder(mesh) == test::countBorder(original));
    RC_ASSERT(bool(transform(mesh, by.inverse())));
    RC_ASSERT(validate(mesh) == std::string());
    RC_ASSERT(largestGap(mesh, original) < 1e-10);
    for (Face f = 0; f < mesh.faceSlots(); ++f) {
      RC_ASSERT(mesh.triangle(f) == original.triangle(f));
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) RC_ASSERT(mesh.opposite(h) == original.opposite(h));
    }
  }));
}

// Mirrored ones too still look outward.
void TransformingTest::volumeFollowsTheDeterminant() {
  const HalfEdgeMesh original = buildMesh(test::bumpySphere(2)).mesh;
  const double volume = test::volume(soupOf(original));
  QVERIFY(rc::check("volume times the determinant without its sign", [&] {
    HalfEdgeMesh mesh = original;
    Eigen::Affine3d by(randomPose());
    by.linear() += 0.5 * Eigen::Matrix3d::NullaryExpr([] { return number(1.0); });
    RC_PRE(std::abs(by.linear().determinant()) > 1e-3);
    RC_ASSERT(bool(transform(mesh, by)));
    // Coordinates are relative to the middle, so that a far position loses no digits.
    TriangleSoup soup = soupOf(mesh);
    for (Vec3& p : soup.points) p -= by.translation();
    RC_ASSERT(std::abs(test::volume(soup) - std::abs(by.linear().determinant()) * volume) < 1e-10);
    RC_ASSERT(test::countEdges(mesh).sound());
  }));
}

void TransformingTest::turnedTwiceIsTheSame() {
  for (const TriangleSoup& soup : {test::moebiusStrip(10, 3), test::torus(9, 7), test::twoCubesSharingAnEdge()}) {
    const HalfEdgeMesh original = buildMesh(soup).mesh;
    HalfEdgeMesh mesh = original;
    reverseOrientation(mesh);
    QCOMPARE(validate(mesh), std::string());
    QCOMPARE(test::countSeams(mesh), test::countSeams(original));
    QVERIFY(std::abs(test::volume(soupOf(mesh)) + test::volume(soupOf(original))) < 1e-12);
    reverseOrientation(mesh);
    QVERIFY(test::sameMesh(mesh, original));
  }
}

void TransformingTest::refusals() {
  const HalfEdgeMesh original = buildMesh(test::cube()).mesh;
  Eigen::Affine3d flat(Eigen::Scaling(1.0, 1.0, 0.0)), huge(Eigen::Scaling(1e200)), none = Eigen::Affine3d::Identity();
  none.translation().x() = std::numeric_limits<double>::quiet_NaN();
  Eigen::Affine3d far = Eigen::Affine3d::Identity();
  far.linear()(0, 0) = 1e308;
  far.linear()(0, 1) = 1e308;
  for (const Eigen::Affine3d& by : {flat, huge, none, far}) {
    HalfEdgeMesh mesh = original;
    const Status status = transform(mesh, by);
    QVERIFY(!status);
    QCOMPARE(status.error().code, ErrorCode::ValueOutOfRange);
    QVERIFY(test::sameMesh(mesh, original));
  }
}

void TransformingTest::units() {
  HalfEdgeMesh mesh = buildMesh(test::cube()).mesh;
  QVERIFY(bool(transform(mesh, Eigen::Affine3d(Eigen::Scaling(25.4)))));
  QVERIFY(std::abs(test::volume(soupOf(mesh)) - 25.4 * 25.4 * 25.4) < 1e-9);
}

// A brick's are its edges.
void TransformingTest::principalAxes() {
  QVERIFY(rc::check("a brick comes to lie along the axes, the longest side along x", [] {
    HalfEdgeMesh mesh = brick(Vec3(2.0, 7.0, 4.0));
    move(mesh, randomPose());
    const auto pose = ontoPrincipalAxes(mesh);
    RC_ASSERT(bool(pose));
    RC_ASSERT(std::abs(pose->linear().determinant() - 1.0) < 1e-12);
    move(mesh, *pose);
    RC_ASSERT((boxOf(mesh).min() + Vec3(3.5, 2.0, 1.0)).norm() < 1e-9);
    RC_ASSERT((boxOf(mesh).max() - Vec3(3.5, 2.0, 1.0)).norm() < 1e-9);
  }));
}

void TransformingTest::principalAxesDoNotDependOnThePose() {
  HalfEdgeMesh first = buildMesh(test::bumpySphere(3)).mesh;
  const HalfEdgeMesh original = first;
  move(first, *ontoPrincipalAxes(first));
  QVERIFY(rc::check("the same place from everywhere", [&] {
    HalfEdgeMesh mesh = original;
    move(mesh, randomPose());
    move(mesh, *ontoPrincipalAxes(mesh));
    RC_ASSERT(largestGap(mesh, first) < 1e-6);
  }));
}

void TransformingTest::standsOnItsLargestFace() {
  QVERIFY(rc::check("a brick lies on its largest side, wherever it was", [] {
    HalfEdgeMesh mesh = brick(Vec3(2.0, 7.0, 4.0));
    move(mesh, randomPose());
    const auto pose = ontoLargestFlatFace(mesh);
    RC_ASSERT(bool(pose));
    move(mesh, *pose);
    RC_ASSERT(std::abs(boxOf(mesh).min().z()) < 1e-9);
    RC_ASSERT(std::abs(boxOf(mesh).max().z() - 2.0) < 1e-9);
    RC_ASSERT(boxOf(mesh).center().head<2>().norm() < 1e-9);
    RC_ASSERT(test::volume(soupOf(mesh)) > 55.9);
  }));
}

// A bowl's inner floor is larger than the ring it stands on; but it cannot be stood on.
void TransformingTest::flatButNotToStandOn() {
  // A profile turned around z: foot ring, wall, rim, inner wall; the floor inside is closed by a fan.
  const std::vector<std::pair<double, double>> profile{{4.0, 0.0}, {5.0, 0.0}, {5.0, 3.0}, {4.9, 3.0}, {4.9, 1.0}};
  TriangleSoup bowl = test::grid(40, 5, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2.0 * M_PI * i / 40;
    return Vec3(profile[j].first * std::cos(u), profile[j].first * std::sin(u), profile[j].second);
  });
  const auto low = static_cast<std::uint32_t>(bowl.points.size()), floor = low + 1;
  bowl.points.insert(bowl.points.end(), {Vec3(0, 0, 0.5), Vec3(0, 0, 1.0)});  // below, a hollow cone
  for (std::uint32_t i = 0; i < 40; ++i) {
    const std::uint32_t a = 5 * i, b = 5 * ((i + 1) % 40);
    bowl.triangles.push_back({low, b, a});
    bowl.triangles.push_back({floor, a + 4, b + 4});
  }
  HalfEdgeMesh mesh = buildMesh(bowl).mesh;
  QVERIFY(test::countEdges(mesh).sound() && test::volume(bowl) > 0.0);
  Pose tilt = Pose::Identity();
  tilt.linear() = Eigen::AngleAxisd(1.0, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  move(mesh, tilt);
  const auto pose = ontoLargestFlatFace(mesh);
  QVERIFY(bool(pose));
  move(mesh, *pose);
  QCOMPARE(bowl.triangles.back()[0], floor);
  QVERIFY(std::abs(mesh.points(static_cast<Face>(bowl.triangles.size() - 1))[0].z() - 1.0) < 1e-9);
  QVERIFY(std::abs(boxOf(mesh).max().z() - 3.0) < 1e-9);
}

// The undersides of four feet, 16 together, are more than the top of 12.25; one alone is not.
void TransformingTest::feetCountTogether() {
  TriangleSoup table;
  for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(8, 0, 0), Vec3(0, 8, 0), Vec3(8, 8, 0)})
    test::append(table, test::cube(2.0, corner));
  test::append(table, test::cube(3.5, Vec3(3, 3, 0.5)));
  HalfEdgeMesh mesh = buildMesh(table).mesh;
  Pose tilt = Pose::Identity();
  tilt.linear() = Eigen::AngleAxisd(2.0, Vec3(3, 1, 2).normalized()).toRotationMatrix();
  move(mesh, tilt);
  const auto pose = ontoLargestFlatFace(mesh);
  QVERIFY(bool(pose));
  move(mesh, *pose);
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) QVERIFY(std::abs(mesh.position(v).z() - table.points[v].z()) < 1e-9);
}

// Single precision lifts one corner below a part of 100 mm by a hundred-thousandth of a millimetre; the sliver there
// comes first and is tilted by 0.008°, which over the part is ten times what a flat face may be off.
void TransformingTest::sliversDoNotTiltTheFace() {
  TriangleSoup part = test::cube();
  for (Vec3& p : part.points) {  // narrower above, so that it is on its underside that it stands
    const double side = p.z() > 0.5 ? 50.0 : 100.0;
    p = Vec3(side * (p.x() - 0.5), side * (p.y() - 0.5), 10.0 * p.z());
  }
  std::erase_if(part.triangles, [&](const Triangle& t) {  // the underside
    return part.points[t[0]].z() + part.points[t[1]].z() + part.points[t[2]].z() == 0.0;
  });
  const auto lifted = static_cast<std::uint32_t>(part.points.size());
  part.points.emplace_back(0.0, -49.9, 1.4e-5);
  part.triangles.insert(part.triangles.begin(), {{1, 0, lifted}, {0, 2, lifted}, {2, 3, lifted}, {3, 1, lifted}});
  HalfEdgeMesh mesh = buildMesh(part).mesh;
  QVERIFY(test::countEdges(mesh).sound() && test::volume(part) > 0.0);
  const auto pose = ontoLargestFlatFace(mesh);
  QVERIFY(bool(pose));
  move(mesh, *pose);
  QVERIFY(std::abs(boxOf(mesh).min().z()) < 3e-5 && std::abs(boxOf(mesh).max().z() - 10.0) < 1e-3);
}

void TransformingTest::nothingFlat() {
  QVERIFY(!ontoLargestFlatFace(buildMesh(test::icosphere(4)).mesh, {.flatness = 1e-6, .leastShare = 0.01}));
  JobState job;
  job.cancelled = true;
  QVERIFY(!ontoLargestFlatFace(brick(Vec3(1, 2, 3)), {}, Progress(job)));
}

void TransformingTest::box() {
  HalfEdgeMesh mesh = brick(Vec3(2.0, 7.0, 4.0));
  QVERIFY(rc::check("the point asked for comes to the origin", [&] {
    move(mesh, randomPose());
    const Vec3 anchor(0.5 + number(0.5), 0.5 + number(0.5), 0.5 + number(0.5));
    move(mesh, *boxToOrigin(mesh, anchor));
    RC_ASSERT((boxOf(mesh).min() + anchor.cwiseProduct(boxOf(mesh).sizes())).norm() < 1e-9);
  }));
}

void TransformingTest::nothing() {
  HalfEdgeMesh none;
  QVERIFY(bool(transform(none, Eigen::Affine3d::Identity())));
  QVERIFY(!ontoPrincipalAxes(none) && !ontoLargestFlatFace(none) && !boxToOrigin(none, Vec3::Zero()));
  const HalfEdgeMesh segment = buildMesh({{Vec3(0, 0, 0), Vec3(1, 0, 0)}, {{0, 1, 1}}}).mesh;
  QVERIFY(!ontoPrincipalAxes(segment) && !ontoLargestFlatFace(segment));
}

HANDWHEEL_TEST(TransformingTest)
#include "TransformingTest.moc"

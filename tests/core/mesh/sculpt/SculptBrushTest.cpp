// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/SculptBrush.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"
#include "proximity/ClosestPoint.h"

#include <rapidcheck.h>

#include <QTest>
#include <map>
#include <set>

using namespace handwheel;

class SculptBrushTest : public QObject {
  Q_OBJECT

 private slots:
  void areaIsWhatTheBallMeets();
  void areaOfAThinWallIsOneSide();
  void bordersStayUnlessAsked();
  void fadesTowardsWhatStays();
  void onlyThePatch();
  void seamsStay();
  void oddAreas();
  void dragsWithASmoothRim();
  void inflatesASphere();
  void flattensTowardsThePlane();
  void smoothingKeepsAPlateAndASphere();
  void smoothingTakesASpikeAway();
  void anyStroke();
  void sameInEverySizeAndPosition();
};

namespace {

HalfEdgeMesh plate() {
  return buildMesh(test::grid(11, 11, false, false, [](auto i, auto j) { return Vec3(i, j, 0); })).mesh;
}

Face faceAt(const HalfEdgeMesh& mesh, const Vec3& p) {
  Face best = 0;
  const auto distance = [&](Face f) {
    const auto [a, b, c] = mesh.points(f);
    return (closestOnTriangle(p, a, b, c) - p).norm();
  };
  for (Face f = 1; f < mesh.faceSlots(); ++f)
    if (distance(f) < distance(best)) best = f;
  return best;
}

std::map<Vertex, Vec3> goals(const HalfEdgeMesh& mesh, const std::vector<VertexGoal>& moves) {
  std::map<Vertex, Vec3> result;
  for (const VertexGoal& move : moves) result.emplace(mesh.from(move.leaving), move.to);
  return result;
}

const Vertex kMiddle = test::vertexAt(plate(), Vec3(5, 5, 0));
constexpr double kRadius = 2.3;
const Vec3 kCentre(5.2, 4.9, 0);

}  // namespace

void SculptBrushTest::areaIsWhatTheBallMeets() {
  const HalfEdgeMesh mesh = plate();
  const BrushArea area = brushArea(mesh, faceAt(mesh, kCentre), kCentre, kRadius);
  const std::set<Face> faces(area.faces.begin(), area.faces.end());
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    const auto [p, q, r] = mesh.points(f);
    QCOMPARE(faces.contains(f), (closestOnTriangle(kCentre, p, q, r) - kCentre).norm() <= kRadius);
  }
  std::map<Vertex, double> weights;
  for (const auto& held : area.vertices) weights.emplace(mesh.from(held.leaving), held.weight);
  QCOMPARE(weights.size(), area.vertices.size());
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) {
    const double share = (mesh.position(v) - kCentre).norm() / kRadius;
    QCOMPARE(weights.contains(v), share < 1.0);
    if (share < 1.0) QVERIFY(std::abs(weights[v] - std::pow(1.0 - share * share, 2)) < 1e-14);
  }
}

void SculptBrushTest::areaOfAThinWallIsOneSide() {
  TriangleSoup soup = test::grid(11, 11, false, false, [](auto i, auto j) { return Vec3(i, j, 0); });
  test::append(soup, test::turnedOver(test::moved(soup, Vec3(0, 0, -0.1))));
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const HalfEdgeMesh oneSide = plate();
  const auto facesOf = [](const HalfEdgeMesh& of) {
    const BrushArea area = brushArea(of, faceAt(of, kCentre), kCentre, kRadius);
    return std::set<Face>(area.faces.begin(), area.faces.end());
  };
  QVERIFY(!facesOf(oneSide).empty());
  QCOMPARE(facesOf(mesh), facesOf(oneSide));
}

void SculptBrushTest::bordersStayUnlessAsked() {
  const HalfEdgeMesh mesh = plate();
  const Vec3 corner(0, 0, 0);
  const auto isOnBorder = [&](const BrushArea::Held& held) {
    const Vec3& p = mesh.position(mesh.from(held.leaving));
    return p.x() == 0.0 || p.y() == 0.0;
  };
  const auto count = [&](const BrushReach& reach) {
    const BrushArea area = brushArea(mesh, faceAt(mesh, corner), corner, kRadius, reach);
    return std::count_if(area.vertices.begin(), area.vertices.end(), isOnBorder);
  };
  QCOMPARE(count({}), 0);
  QCOMPARE(count({.movesBorder = true}), 5);
}

// In the plate, 3 mm from the border at x = 0: the weights there fall evenly to nothing, and stay as they are beyond.
void SculptBrushTest::fadesTowardsWhatStays() {
  const HalfEdgeMesh mesh = plate();
  const Vec3 centre(3, 5, 0);
  const BrushArea area = brushArea(mesh, faceAt(mesh, centre), centre, 4.0);
  std::size_t n = 0;
  for (const auto& [leaving, weight] : area.vertices) {
    const Vec3& p = mesh.position(mesh.from(leaving));
    const double plain = std::pow(1.0 - (p - centre).squaredNorm() / 16.0, 2), x = p.x() / 3.0;
    const bool isNear = p.x() < 3.0 && p.y() > 2.5 && p.y() < 7.5;  // straight across from a vertex in the ball
    if (isNear || p.x() >= 3.0) QVERIFY(std::abs(weight - (isNear ? x * x * (3.0 - 2.0 * x) : 1.0) * plain) < 1e-12);
    n += isNear;
  }
  QVERIFY(n > 8);
}

void SculptBrushTest::onlyThePatch() {
  const HalfEdgeMesh mesh = plate();
  FaceSelection patch;
  for (Face f = 0; f < 100; ++f) patch.add(f);  // x below 5
  const BrushArea area = brushArea(mesh, faceAt(mesh, kCentre), kCentre, kRadius, {.patch = &patch});
  QVERIFY(!area.vertices.empty());
  for (const auto& held : area.vertices) QVERIFY(mesh.position(mesh.from(held.leaving)).x() < 5.0);
}

void SculptBrushTest::seamsStay() {
  const HalfEdgeMesh mesh = buildMesh(test::moebiusStrip(24, 4)).mesh;
  QVERIFY(test::countSeams(mesh) > 0);
  std::set<Vertex> seam;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
    if (mesh.isSeam(h)) seam.insert({mesh.from(h), mesh.to(h)});
  const BrushArea area = brushArea(mesh, 0, mesh.points(0)[0], 10.0, {.movesBorder = true});
  QVERIFY(!area.vertices.empty());
  for (const auto& held : area.vertices) QVERIFY(!seam.contains(mesh.from(held.leaving)));
}

void SculptBrushTest::oddAreas() {
  const HalfEdgeMesh mesh = plate();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  QVERIFY(brushArea(mesh, 3, kCentre, 0.0).vertices.empty());
  QVERIFY(brushArea(mesh, 3, kCentre, kNan).vertices.empty());
  QVERIFY(brushArea(mesh, 3, Vec3(kNan, 0, 0), 1.0).vertices.empty());
  QVERIFY(brushArea(mesh, 5000, kCentre, 1.0).vertices.empty());
  QVERIFY(brushArea(HalfEdgeMesh(), 0, kCentre, 1.0).vertices.empty());
  const BrushArea nothing;
  QVERIFY(dragged(mesh, nothing, Vec3(0, 0, 1)).empty() && inflated(mesh, nothing, 1.0).empty());
  QVERIFY(flattened(mesh, nothing, 1.0).empty() && smoothed(mesh, nothing, 1.0).empty());
}

void SculptBrushTest::dragsWithASmoothRim() {
  const HalfEdgeMesh mesh = plate();
  const Vec3 centre = mesh.position(kMiddle), displacement(0.3, 0.2, 1.0);
  const auto moved = goals(mesh, dragged(mesh, brushArea(mesh, faceAt(mesh, centre), centre, kRadius), displacement));
  QVERIFY((moved.at(kMiddle) - centre - displacement).norm() < 1e-15);
  for (const auto& [v, to] : moved) {
    const double share = (mesh.position(v) - centre).norm() / kRadius;
    QVERIFY((to - mesh.position(v) - std::pow(1.0 - share * share, 2) * displacement).norm() < 1e-14);
  }
}

void SculptBrushTest::inflatesASphere() {
  const HalfEdgeMesh mesh = buildMesh(test::icosphere(4)).mesh;
  const Vec3 centre = Vec3::UnitZ();
  for (const double distance : {0.05, -0.05}) {
    const BrushArea area = brushArea(mesh, faceAt(mesh, centre), centre, 0.4);
    const auto moved = goals(mesh, inflated(mesh, area, distance));
    std::size_t near = 0;
    for (Vertex v = 0; v < mesh.vertexSlots(); ++v) near += (mesh.position(v) - centre).norm() < 0.4;
    QVERIFY(near > 20);
    QCOMPARE(moved.size(), near);
    for (const auto& [v, to] : moved) {
      const Vec3& p = mesh.position(v);
      const double weight = std::pow(1.0 - (p - centre).squaredNorm() / 0.16, 2);
      QVERIFY((to - (1.0 + weight * distance) * p).norm() < 0.01 * std::abs(distance));
    }
  }
}

// On a dome all comes nearer to one plane; with the strength turned round, farther from it.
void SculptBrushTest::flattensTowardsThePlane() {
  HalfEdgeMesh mesh = plate();
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) {
    const Vec3 p = mesh.position(v);
    mesh.setPosition(v, p - 0.05 * Vec3(0, 0, (p - Vec3(5, 5, 0)).squaredNorm()));
  }
  const Vec3 centre = mesh.position(kMiddle);
  const BrushArea area = brushArea(mesh, faceAt(mesh, centre), centre, 3.1);
  const auto range = [&](const std::map<Vertex, Vec3>& moved) {
    Box box;
    for (const auto& [v, to] : moved)
      if ((mesh.position(v) - centre).norm() < 1.6) box.extend(to);
    return box.sizes().z();
  };
  const double before = range(goals(mesh, flattened(mesh, area, 0.0)));
  QVERIFY(before > 0.05);
  QVERIFY(range(goals(mesh, flattened(mesh, area, 1.0))) < 0.7 * before);
  QVERIFY(range(goals(mesh, flattened(mesh, area, -1.0))) > 1.2 * before);
  const HalfEdgeMesh flat = plate();
  const BrushArea onFlat = brushArea(flat, faceAt(flat, kCentre), kCentre, kRadius);
  QVERIFY(!onFlat.vertices.empty());
  for (const auto& [v, to] : goals(flat, flattened(flat, onFlat, 1.0))) QVERIFY((to - flat.position(v)).norm() < 1e-13);
}

// Fifty passes over all of a sphere leave its size; as many steps of a Laplacian alone would leave a third of it.
void SculptBrushTest::smoothingKeepsAPlateAndASphere() {
  const HalfEdgeMesh flat = plate();
  const BrushArea area = brushArea(flat, faceAt(flat, kCentre), kCentre, 4.0);
  const auto moved = goals(flat, smoothed(flat, area, 1.0));
  QVERIFY(!moved.empty());
  QCOMPARE(moved.size(), area.vertices.size());
  for (const auto& [v, to] : moved) QVERIFY(std::abs(to.z()) < 1e-15);
  HalfEdgeMesh sphere = buildMesh(test::icosphere(3)).mesh;
  const double before = test::volume(sphere.compact().soup);
  for (int pass = 0; pass < 50; ++pass)
    moveTowards(sphere, smoothed(sphere, brushArea(sphere, 0, Vec3::Zero(), 10.0), 1.0));
  QVERIFY(std::abs(test::volume(sphere.compact().soup) / before - 1.0) < 0.01);
  QCOMPARE(validate(sphere), std::string());
}

void SculptBrushTest::smoothingTakesASpikeAway() {
  HalfEdgeMesh mesh = plate();
  mesh.setPosition(kMiddle, mesh.position(kMiddle) + Vec3(0, 0, 1));
  const Vec3 centre(5, 5, 0);
  for (int pass = 0; pass < 20; ++pass)
    moveTowards(mesh, smoothed(mesh, brushArea(mesh, faceAt(mesh, centre), centre, 3.0), 1.0));
  QVERIFY(mesh.position(kMiddle).z() < 0.4);
  QVERIFY(test::vertexAt(mesh, Vec3(0, 0, 0)) != kNone);
}

void SculptBrushTest::anyStroke() {
  const HalfEdgeMesh whole = buildMesh(test::withHole(test::bumpySphere(3), Vec3::UnitX(), 0.3)).mesh;
  std::size_t moved = 0;
  const bool ok = rc::check([&] {
    HalfEdgeMesh mesh = whole;
    const bool movesBorder = *rc::gen::arbitrary<bool>();
    const int dabs = *rc::gen::inRange(1, 12);
    for (int dab = 0; dab < dabs; ++dab) {
      const HalfEdgeMesh before = mesh;
      const Face seed = *rc::gen::inRange<Face>(0, static_cast<Face>(mesh.faceSlots()));
      const double radius = *rc::gen::inRange(1, 100) / 100.0, strength = *rc::gen::inRange(-100, 101) / 100.0;
      const BrushArea area = brushArea(mesh, seed, mesh.points(seed)[0], radius, {.movesBorder = movesBorder});
      const int brush = *rc::gen::inRange(0, 4);
      const std::vector<VertexGoal> moves = brush == 0   ? dragged(mesh, area, Vec3(strength, 2 * strength, -strength))
                                            : brush == 1 ? inflated(mesh, area, strength * radius)
                                            : brush == 2 ? flattened(mesh, area, strength)
                                                         : smoothed(mesh, area, std::abs(strength));
      moveTowards(mesh, moves);
      for (Vertex v = 0; v < mesh.vertexSlots(); ++v) moved += mesh.position(v) != before.position(v);
      RC_ASSERT(validate(mesh) == std::string());
      for (Face f = 0; f < mesh.faceSlots(); ++f)
        RC_ASSERT(unitNormal(mesh.points(f)).dot(unitNormal(before.points(f))) > 0.0);
      for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
        RC_ASSERT(movesBorder || !mesh.isBorder(h) ||
                  test::sameBits(mesh.position(mesh.from(h)), whole.position(mesh.from(h))));
    }
  });
  QVERIFY(ok);
  QVERIFY(moved > 0);
}

void SculptBrushTest::sameInEverySizeAndPosition() {
  const HalfEdgeMesh plain = buildMesh(test::bumpySphere(3)).mesh;
  const Face seed = 17;
  const auto moves = [&](const HalfEdgeMesh& mesh, double scale, int brush) {
    const BrushArea area = brushArea(mesh, seed, mesh.points(seed)[0], 0.5 * scale);
    return brush == 0   ? dragged(mesh, area, scale * Vec3(0.1, 0, 0))
           : brush == 1 ? inflated(mesh, area, 0.1 * scale)
           : brush == 2 ? flattened(mesh, area, 0.5)
                        : smoothed(mesh, area, 1.0);
  };
  for (const auto& [scale, shift] : {std::pair(1e-6, 0.0), std::pair(1e6, 0.0), std::pair(1.0, 1e7)}) {
    const Vec3 far(shift, shift, shift);
    const HalfEdgeMesh mesh = buildMesh(test::moved(test::bumpySphere(3), far, scale)).mesh;
    for (int brush = 0; brush < 4; ++brush) {
      const std::vector<VertexGoal> here = moves(plain, 1.0, brush), there = moves(mesh, scale, brush);
      QVERIFY(!here.empty());
      QCOMPARE(there.size(), here.size());
      for (std::size_t i = 0; i < here.size(); ++i)
        QVERIFY((there[i].to - scale * here[i].to - far).norm() <= 1e-7 * scale);
    }
  }
}

HANDWHEEL_TEST(SculptBrushTest)
#include "SculptBrushTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ShapeModels.h"
#include "TestClass.h"
#include "viewport/surface/PartActors.h"
#include "viewport/surface/PartPreparation.h"

#include <vtkActorCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <rapidcheck.h>
#include <QtTest>

using namespace handwheel;

namespace {

const auto kBox = shared(boxSoup({1, 2, 3}));

DisplayPart partAt(const std::string& name, const Vec3& where, const std::shared_ptr<const TriangleSoup>& soup = kBox) {
  DisplayPart part{name, soup};
  part.pose.translation() = where;
  return part;
}

void makeAll(PartActors& actors) {
  for (const auto& soup : actors.missing()) {
    PartShape shape = shapeOf(*soup);
    actors.setShape(soup, shape);
  }
  while (actors.takeOne() > 0) {
  }
}

}  // namespace

// Needs no display: nothing is rendered.
class PartActorsTest : public QObject {
  Q_OBJECT

  vtkNew<vtkRenderer> m_renderer;
  std::unique_ptr<LayerProps> m_props;

  std::vector<vtkActor*> shown() {
    std::vector<vtkActor*> actors;
    vtkActorCollection* all = m_renderer->GetActors();
    all->InitTraversal();
    while (vtkActor* actor = all->GetNextActor()) actors.push_back(actor);
    return actors;
  }

  // Returns the point at which the actor draws the point of the part, in model coordinates.
  static Vec3 drawnAt(vtkActor* actor, const Vec3& inGeometry, const Vec3& origin) {
    const double p[4] = {inGeometry.x(), inGeometry.y(), inGeometry.z(), 1};
    double q[4];
    actor->GetMatrix()->MultiplyPoint(p, q);
    return Vec3(q[0], q[1], q[2]) + origin;
  }

 private slots:
  void init() {
    m_props = std::make_unique<LayerProps>();
    m_props->attach(m_renderer);
  }
  void cleanup() { m_props.reset(); }

  // A part with a proposed replacement is translucent, so that the two make no stripes where they coincide.
  void whatIsProposedAnewFades() {
    PartActors actors(*m_props);
    actors.set({partAt("a", Vec3(0, 0, 0)), partAt("b", Vec3(9, 0, 0))});
    makeAll(actors);
    actors.setFaded({partAt("b", Vec3(9, 1, 0))});
    const auto opacities = [this] {
      std::vector<double> all;
      for (vtkActor* actor : shown()) all.push_back(actor->GetProperty()->GetOpacity());
      std::sort(all.begin(), all.end());
      return all;
    };
    QCOMPARE(opacities().size(), std::size_t{2});
    QVERIFY(opacities()[0] < 1.0 && opacities()[0] > 0.0);
    QCOMPARE(opacities()[1], 1.0);
    actors.setFaded({});
    QCOMPARE(opacities()[0], 1.0);
    actors.set({});
  }

  // A group that no longer belongs to the others, and that comes later, too.
  void aGroupIsFaint() {
    PartActors actors(*m_props);
    actors.setFaintGroup("off");
    DisplayPart off = partAt("b", Vec3(9, 0, 0));
    off.group = "off";
    actors.set({partAt("a", Vec3(0, 0, 0)), off});
    makeAll(actors);
    std::vector<double> opacities;
    for (vtkActor* actor : shown()) opacities.push_back(actor->GetProperty()->GetOpacity());
    std::sort(opacities.begin(), opacities.end());
    QCOMPARE(opacities.size(), std::size_t{2});
    QVERIFY(opacities[0] < 1.0 && opacities[0] > 0.0);
    QCOMPARE(opacities[1], 1.0);
    actors.setFaintGroup({});
    for (vtkActor* actor : shown()) QCOMPARE(actor->GetProperty()->GetOpacity(), 1.0);
    actors.set({});
  }

  void nothingIsShownBeforeTheShapeIsMade() {
    PartActors actors(*m_props);
    actors.set({partAt("a", {0, 0, 0}), partAt("b", {5, 0, 0})});
    QVERIFY(shown().empty());
    QCOMPARE(actors.missing(), std::vector{kBox});  // once for both
    const Vec3 aboveA(0.5, 1, 9), aboveB(5.5, 1, 9);
    QVERIFY(!actors.firstHit(aboveA, -Vec3::UnitZ()));
    makeAll(actors);
    QCOMPARE(shown().size(), std::size_t{2});
    QCOMPARE(actors.builtCount(), 1);
    const auto a = actors.firstHit(aboveA, -Vec3::UnitZ()), b = actors.firstHit(aboveB, -Vec3::UnitZ());
    QVERIFY(a && b && a->element != b->element);
    QCOMPARE(actors.nameOf(a->element), std::string("a"));
    QCOMPARE(actors.nameOf(b->element), std::string("b"));
    QCOMPARE(b->distance, 6.0);
    actors.set({partAt("b", {5, 0, 0}), partAt("a", {0, 0, 0})});  // in another order they keep their numbers
    QCOMPARE(actors.nameOf(a->element), std::string("a"));
    QVERIFY(actors.missing().empty());
  }

  // The geometry is relative to the middle of the box, the drawing to the origin; both are subtracted again.
  void actorsStandWhereThePoseSays() {
    QVERIFY(rc::check([this] {
      const auto number = [](double limit) { return *rc::gen::inRange(-1000, 1001) * limit / 1000.0; };
      init();
      PartActors actors(*m_props);
      const Vec3 origin(number(1e7), number(1e7), number(1e7));
      actors.setOrigin(origin);
      actors.set({partAt("a", origin)});
      makeAll(actors);
      vtkActor* actor = shown().at(0);
      DisplayPart part = partAt("a", origin + Vec3(number(100), number(100), number(100)));
      part.pose.linear() =
          Eigen::Quaterniond(number(1) + 1.01, number(1), number(1), number(1)).normalized().toRotationMatrix();
      actors.set({part});
      RC_ASSERT(shown() == std::vector{actor});
      RC_ASSERT(actors.builtCount() == 1);
      const Vec3 p(number(1), number(2), number(3)), middle(0.5, 1, 1.5);
      RC_ASSERT((drawnAt(actor, p - middle, origin) - part.pose * p).norm() < 1e-8);
    }));
  }

  void boundsAndOutlineFollowThePoses() {
    PartActors actors(*m_props);
    DisplayPart turned = partAt("b", {10, 0, 0});
    turned.pose.linear() = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()).toRotationMatrix();
    actors.set({partAt("a", {0, 0, 0}), turned});
    QVERIFY((actors.bounds().min() - Vec3(0, 0, 0)).norm() < 1e-12);
    QVERIFY((actors.bounds().max() - Vec3(10, 2, 3)).norm() < 1e-12);
    Box outline;
    for (const Vec3& p : actors.outline()) outline.extend(p);
    QVERIFY(outline.isApprox(actors.bounds()));
  }

  // A slider changes the shape faster than it can be built: the last one built stays, until a later one is.
  void theFormerShapeStaysUntilTheNewOneIsMade() {
    PartActors actors(*m_props);
    actors.set({partAt("a", {0, 0, 0})});
    makeAll(actors);
    const vtkSmartPointer<vtkActor> first = shown().at(0);  // held, so that no other gets its address
    const auto second = shared(boxSoup({2, 2, 2})), third = shared(boxSoup({3, 3, 3})),
               last = shared(boxSoup({4, 4, 4}));
    for (const auto& soup : {second, third, last}) {
      actors.set({partAt("a", {1, 0, 0}, soup)});
      QCOMPARE(shown(), std::vector{first.GetPointer()});
      QVERIFY((drawnAt(first, {0, 0, 0}, Vec3::Zero()) - Vec3(1.5, 1, 1.5)).norm() < 1e-12);  // moved along
    }
    PartShape shape = shapeOf(*second);  // it was being built
    QVERIFY(actors.setShape(second, shape));
    QVERIFY(actors.takeOne() > 0);
    const vtkSmartPointer<vtkActor> between = shown().at(0);
    QVERIFY(between != first);
    PartShape obsolete = shapeOf(*third);  // nobody waits for this
    QVERIFY(!actors.setShape(third, obsolete));
    makeAll(actors);
    QCOMPARE(shown().size(), std::size_t{1});
    QVERIFY(shown().at(0) != between);
    QVERIFY((actors.bounds().max() - Vec3(5, 4, 4)).norm() < 1e-12);
  }

  // No intermediate state is shown: neither half of a change nor an old part beside new ones.
  void groupsChangeTogether() {
    const auto grouped = [](const std::string& name, double size) {
      DisplayPart part = partAt(name, {0, 0, 0}, shared(boxSoup({size, size, size})));
      part.group = "bar";
      return part;
    };
    const auto makeOne = [](PartActors& actors) {
      const auto soup = actors.missing().at(0);
      PartShape shape = shapeOf(*soup);
      QVERIFY(actors.setShape(soup, shape));
      QVERIFY(actors.takeOne() > 0);
    };
    PartActors actors(*m_props);
    const DisplayPart a = grouped("a", 1), b = grouped("b", 2), other = partAt("other", {9, 0, 0});
    actors.set({a, b, other});
    makeOne(actors);
    QVERIFY(shown().empty());
    makeOne(actors);
    QCOMPARE(shown().size(), std::size_t{2});
    makeOne(actors);
    QCOMPARE(shown().size(), std::size_t{3});
    // "b" goes, "c" comes, "a" changes; the rest does not wait.
    const auto before = shown();
    const std::vector<vtkSmartPointer<vtkActor>> held(before.begin(),
                                                      before.end());  // so that no other gets its address
    const DisplayPart a2 = grouped("a", 3), c = grouped("c", 4);
    actors.set({a2, c});
    QCOMPARE(shown().size(), std::size_t{2});
    QVERIFY(shown() == std::vector(before.begin(), before.begin() + 2));
    makeOne(actors);
    QVERIFY(shown() == std::vector(before.begin(), before.begin() + 2));
    makeOne(actors);
    QCOMPARE(shown().size(), std::size_t{2});
    QVERIFY(std::find(before.begin(), before.end(), shown()[0]) == before.end());
    QVERIFY(std::find(before.begin(), before.end(), shown()[1]) == before.end());
    // A part that is restored before the change was built has not changed.
    const auto present = shown();
    actors.set({grouped("a", 5), c});
    actors.set({a2, c});
    QVERIFY(actors.missing().empty());
    QVERIFY(shown() == present);
    actors.set({});
    QVERIFY(shown().empty());
  }

  // A part that changes faster than it is built does not delay others, and is shown itself.
  void whatChangesOftenIsShown() {
    const auto grouped = [](const std::string& name, double size) {
      DisplayPart part = partAt(name, {0, 0, 0}, shared(boxSoup({size, size, size})));
      part.group = "bar";
      return part;
    };
    PartActors actors(*m_props);
    double size = 1.0;
    DisplayPart still = grouped("still", size);
    actors.set({grouped("often", size), still});
    makeAll(actors);
    still = grouped("still", 100.0);
    std::set<vtkActor*> seen;
    std::vector<vtkSmartPointer<vtkActor>> held;  // so that no other gets its address
    for (int i = 0; i < 20; ++i) {
      const auto underWay = actors.missing();
      actors.set({grouped("often", ++size), still});
      if (underWay.empty()) continue;
      PartShape shape = shapeOf(*underWay[0]);
      actors.setShape(underWay[0], shape);
      actors.takeOne();
      for (vtkActor* actor : shown()) {
        if (seen.insert(actor).second) held.emplace_back(actor);
      }
    }
    QVERIFY(seen.size() > 12);  // every second state of the one, and the other
    makeAll(actors);
    QCOMPARE(shown().size(), std::size_t{2});
  }

  // While two of three neighbours change with each call, those in view are of one call: no gap between them.
  void aGroupIsShownAsItWasAtOneCall() {
    const auto grouped = [](const std::string& name, double size) {
      DisplayPart part = partAt(name, {0, 0, 0}, shared(boxSoup({size, size, size})));
      part.group = "bar";
      return part;
    };
    const auto sizes = [this] {
      std::vector<double> all;
      for (vtkActor* actor : shown()) all.push_back(std::round(actor->GetBounds()[5] - actor->GetBounds()[4]));
      std::sort(all.begin(), all.end());
      return all;
    };
    PartActors actors(*m_props);
    actors.set({grouped("a", 1), grouped("b", 2), grouped("c", 3)});
    makeAll(actors);
    QVERIFY(sizes() == std::vector<double>({1, 2, 3}));
    // Call i gives two of them, in turn, the size 10 i + 1, 2 or 3.
    std::vector<std::vector<double>> calls{{1, 2, 3}};
    std::vector<DisplayPart> parts{grouped("a", 1), grouped("b", 2), grouped("c", 3)};
    std::set<std::vector<double>> seen;
    for (int i = 1; i <= 30; ++i) {
      std::vector<double> state = calls.back();
      for (int k : {i % 3, (i + 1) % 3}) {
        state[k] = 10.0 * i + k + 1.0;
        parts[k] = grouped(std::string(1, static_cast<char>('a' + k)), state[k]);
      }
      calls.push_back(state);
      actors.set(parts);
      const auto soup = actors.missing().at(0);
      PartShape shape = shapeOf(*soup);
      QVERIFY(actors.setShape(soup, shape));
      while (actors.takeOne() > 0) {
      }
      const std::vector<double> now = sizes();
      seen.insert(now);
      const bool isOfOneCall = std::any_of(calls.begin(), calls.end(), [&](std::vector<double> call) {
        std::sort(call.begin(), call.end());
        return call == now;
      });
      QVERIFY2(isOfOneCall, qPrintable(QString::number(i)));
    }
    QVERIFY(seen.size() > 8);  // two or three shapes are built for each
    while (!actors.missing().empty()) makeAll(actors);
    std::sort(calls.back().begin(), calls.back().end());
    QVERIFY(sizes() == calls.back());
  }

  void whatIsGoneIsFreed() {
    PartActors actors(*m_props);
    auto soup = std::make_shared<const TriangleSoup>(boxSoup({1, 1, 1}));
    const std::weak_ptr<const TriangleSoup> watched = soup;
    actors.set({partAt("a", {0, 0, 0}, soup)});
    makeAll(actors);
    soup.reset();
    QVERIFY(!watched.expired());
    actors.set({});
    QVERIFY(watched.expired());
    QVERIFY(shown().empty());
    QVERIFY(actors.bounds().isEmpty());
  }

  void oddSoupsDoNoHarm() {
    PartActors actors(*m_props);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    TriangleSoup odd;
    odd.points = {{nan, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    odd.triangles = {{1, 2, 3}, {1, 1, 1}};
    const auto empty = shared({});
    actors.set({partAt("empty", {0, 0, 0}, empty), partAt("odd", {0, 0, 0}, shared(odd)), partAt("twice", {0, 0, 0}),
                partAt("twice", {9, 9, 9})});
    makeAll(actors);
    QCOMPARE(actors.builtCount(), 3);
    QVERIFY((actors.bounds().max() - Vec3(10, 11, 12)).norm() < 1e-12);
    actors.set({partAt("twice", {0, 0, 0})});
    QCOMPARE(shown().size(), std::size_t{1});
    actors.set({});
    QVERIFY(shown().empty());
  }

  void largePartsComeInBlocks() {
    PartActors actors(*m_props);
    actors.set({partAt("ball", {0, 0, 0}, shared(sphereSoup(200)))});  // 159 200 triangles
    PartShape shape = shapeOf(*actors.missing().at(0));
    QVERIFY(actors.setShape(actors.missing().at(0), shape));
    std::size_t triangles = 0, blocks = 0;
    while (const std::size_t some = actors.takeOne()) {
      QVERIFY(some <= kBlockFaces);
      triangles += some;
      QCOMPARE(shown().size(), ++blocks);
    }
    QCOMPARE(triangles, std::size_t{159200});
    QCOMPARE(blocks, std::size_t{3});
  }

  void highlightedPartsAreTinted() {
    PartActors actors(*m_props);
    actors.set({partAt("a", {0, 0, 0}), partAt("b", {5, 0, 0})});
    makeAll(actors);
    const auto colours = [this] {
      std::vector<Vec3> all;
      for (vtkActor* actor : shown()) all.emplace_back(actor->GetProperty()->GetColor());
      return all;
    };
    const auto plain = colours();
    actors.setHighlighted("b");
    QVERIFY(colours()[0] == plain[0] && colours()[1] != plain[1]);
    actors.setHighlighted("a");
    QVERIFY(colours()[0] != plain[0] && colours()[1] == plain[1]);
    actors.setHighlighted("");
    QVERIFY(colours() == plain);
    DisplayPart c = partAt("c", {9, 0, 0}), d = partAt("d", {12, 0, 0});
    c.group = d.group = "one";
    actors.set({c, d});
    makeAll(actors);
    actors.setHighlighted("c");
    QVERIFY(colours()[0] != plain[0] && colours()[1] != plain[1]);
  }

  // Every soup is delivered once, in order; one that is being built is delivered although no longer requested.
  void preparationDelivers() {
    std::vector<std::shared_ptr<const TriangleSoup>> delivered;
    PartPreparation preparation(
        [&](const PartPreparation::Soup& soup, PartShape shape) {
          QVERIFY(shape.faces != nullptr);
          delivered.push_back(soup);
        },
        [] { QFAIL("out of memory"); });
    const auto a = shared(sphereSoup(150)), b = shared(sphereSoup(20)), c = shared(sphereSoup(10));
    preparation.request({a, b});
    preparation.request({c});
    QTRY_COMPARE(delivered.size(), std::size_t{2});
    QVERIFY(delivered == (std::vector{a, c}));
    QTRY_VERIFY(!preparation.isUnderWay());
    preparation.request({b, a});
    preparation.finish();
    QVERIFY(delivered == (std::vector{a, c, b, a}));
    preparation.request({b});
    preparation.cancel();
    QTest::qWait(50);
    QCOMPARE(delivered.size(), std::size_t{4});
  }
};

HANDWHEEL_TEST(PartActorsTest)
#include "PartActorsTest.moc"

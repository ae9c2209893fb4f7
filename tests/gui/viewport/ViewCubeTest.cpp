// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "viewport/overlay/ViewCube.h"

#include <rapidcheck.h>
#include <QApplication>
#include <QSignalSpy>
#include <QtTest>
#include <set>

using namespace handwheel;

namespace {

using Key = std::tuple<int, int, int>;

Key keyOf(const CubeRegion& r) {
  return {r.x(), r.y(), r.z()};
}

std::vector<CubeRegion> allRegions() {
  std::vector<CubeRegion> regions;
  for (int i = 0; i < 27; ++i) {
    const CubeRegion r(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (!r.isZero()) regions.push_back(r);
  }
  return regions;
}

Eigen::Quaterniond anyOrientation() {
  const auto part = [] { return *rc::gen::inRange(-1000, 1001) / 1000.0; };
  return Eigen::Quaterniond(part() + 1.01, part(), part(), part()).normalized();
}

}  // namespace

class ViewCubeTest : public QObject {
  Q_OBJECT
 private slots:
  // A click where a region of the cube faces the viewer finds that region.
  void everyRegionIsFoundInTheMiddle() {
    for (const CubeRegion& region : allRegions()) {
      const Vec3 out = region.cast<double>();
      const ViewCubeGeometry cube(uprightTowards(out), {50, 50}, 30);
      const auto found = cube.regionAt({50, 50});
      QVERIFY(found.has_value());
      QCOMPARE(keyOf(*found), keyOf(region));
      QCOMPARE(keyOf(regionFacing(uprightTowards(out))), keyOf(region));
    }
  }

  // From the front there are nine cells, named by their position.
  void cellsOfTheFront() {
    const ViewCubeGeometry cube(orientationOf(StandardView::Front), {50, 50}, 30);
    QCOMPARE(cube.cells().size(), std::size_t{9});
    QCOMPARE(keyOf(*cube.regionAt({50, 50})), Key(0, -1, 0));
    QCOMPARE(keyOf(*cube.regionAt({75, 50})), Key(1, -1, 0));
    QCOMPARE(keyOf(*cube.regionAt({50, 25})), Key(0, -1, 1));
    QCOMPARE(keyOf(*cube.regionAt({25, 75})), Key(-1, -1, -1));
    QVERIFY(!cube.regionAt({85, 50}));
  }

  // The visible part is a convex outline, and each point of it belongs to one side that faces the viewer.
  void onlySidesThatFaceTheViewerShow() {
    QVERIFY(rc::check([] {
      const Eigen::Quaterniond q = anyOrientation();
      const ViewCubeGeometry cube(q, {50, 50}, 30);
      std::set<Key> sides;
      for (const CubeCell& cell : cube.cells()) {
        RC_ASSERT((q.conjugate() * Vec3(cell.side.cast<double>())).z() > 0);
        sides.insert(keyOf(cell.side));
      }
      RC_ASSERT(cube.cells().size() == 9 * sides.size());
      RC_ASSERT(sides.size() <= 3u);
      RC_ASSERT(cube.regionAt({50, 50}).has_value());
    }));
  }

  void everyRegionCanBeReachedByTheKeyboard() {
    std::set<Key> reached;
    CubeRegion region(0, -1, 0);
    for (int up = -2; up <= 2; ++up) {
      for (int around = 0; around < 8; ++around) {
        CubeRegion r = region;
        for (int i = 0; i < around; ++i) r = steppedFrom(r, 1, 0);
        for (int i = 0; i < std::abs(up); ++i) r = steppedFrom(r, 0, up > 0 ? 1 : -1);
        reached.insert(keyOf(r));
      }
    }
    QCOMPARE(reached.size(), std::size_t{26});
    QCOMPARE(keyOf(steppedFrom({0, -1, 0}, 1, 0)), Key(1, -1, 0));
    QCOMPARE(keyOf(steppedFrom({0, 0, 1}, 0, -1)), Key(0, -1, 1));
    QCOMPARE(keyOf(steppedFrom({1, 1, 1}, 0, 1)), Key(0, 0, 1));
  }

  void clicksAndDrags() {
    ViewCube cube(nullptr);
    cube.setOrientation(orientationOf(StandardView::Front));
    cube.show();
    std::vector<Key> chosen;
    connect(&cube, &ViewCube::chosen, this, [&](const CubeRegion& r) { chosen.push_back(keyOf(r)); });
    QSignalSpy started(&cube, &ViewCube::dragStarted), dragged(&cube, &ViewCube::dragged),
        ended(&cube, &ViewCube::dragEnded);
    const QPoint middle = cube.rect().center();
    QTest::mouseClick(&cube, Qt::LeftButton, {}, middle + QPoint(26, -26));
    QCOMPARE(chosen, std::vector{Key(1, -1, 1)});
    QTest::mouseClick(&cube, Qt::LeftButton, {}, QPoint(2, 2));  // beside the cube
    QCOMPARE(chosen.size(), std::size_t{1});
    QTest::mousePress(&cube, Qt::LeftButton, {}, middle);
    QMouseEvent move(QEvent::MouseMove, middle + QPoint(20, 0), cube.mapToGlobal(middle + QPoint(20, 0)), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&cube, &move);
    QTest::mouseRelease(&cube, Qt::LeftButton, {}, middle + QPoint(20, 0));
    QCOMPARE(started.size(), 1);
    QCOMPARE(dragged.size(), 1);
    QCOMPARE(dragged[0][0].toPointF().x(), 20.0);
    QCOMPARE(ended.size(), 1);
    QCOMPARE(chosen.size(), std::size_t{1});
  }

  void keysAndNames() {
    ViewCube cube(nullptr);
    QSignalSpy stepped(&cube, &ViewCube::stepped);
    QTest::keyClick(&cube, Qt::Key_Left);
    QTest::keyClick(&cube, Qt::Key_Up);
    QCOMPARE(stepped.size(), 2);
    QCOMPARE(stepped[0], (QVariantList{-1, 0}));
    QCOMPARE(stepped[1], (QVariantList{0, 1}));
    QVERIFY(cube.focusPolicy() & Qt::TabFocus);
    QCOMPARE(cube.accessibleName(), "View cube");
    cube.setOrientation(orientationOf(StandardView::Isometric));
    QCOMPARE(cube.accessibleDescription(), "Front · Right · Top");
    std::set<QString> names;
    for (const CubeRegion& r : allRegions()) names.insert(ViewCube::nameOf(r));
    QCOMPARE(names.size(), std::size_t{26});
  }

  // On a patient the side that faces the viewer has the letter of the direction from which it is seen: x is to the
  // left, y to the back, z to the head. To the right of the front is the patient's left.
  void sidesOfAPatient() {
    ViewCube cube(nullptr);
    QCOMPARE(cube.textOn({0, -1, 0}), "Front");
    cube.setPatient(true);
    const auto facing = [&](StandardView view) {
      cube.setOrientation(orientationOf(view));
      const ViewCubeGeometry geometry(orientationOf(view), {50, 50}, 30);
      QString letters;  // in front, and those of the directions to the right and up
      letters += cube.textOn(*geometry.regionAt({50, 50}));
      for (const Vec3& to : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())})
        letters += cube.textOn((orientationOf(view) * to).array().round().matrix().cast<int>());
      return letters;
    };
    QCOMPARE(facing(StandardView::Front), "ALH");
    QCOMPARE(cube.accessibleDescription(), "Front of the patient (A)");
    QCOMPARE(facing(StandardView::Back), "PRH");
    QCOMPARE(facing(StandardView::Left), "RAH");
    QCOMPARE(facing(StandardView::Right), "LPH");
    QCOMPARE(facing(StandardView::Top), "HLP");
    QCOMPARE(facing(StandardView::Bottom), "FLA");
    cube.setOrientation(orientationOf(StandardView::Isometric));
    QCOMPARE(cube.accessibleDescription(),
             "Front of the patient (A) · Left of the patient (L) · Head of the patient (H)");
    cube.setPatient(false);
    QCOMPARE(cube.accessibleDescription(), "Front · Right · Top");
  }

  // The region under the cursor is tinted with the accent: also the strips of an edge on both sides.
  void hoverHighlights() {
    ViewCube cube(nullptr);
    const SceneColours colours = sceneColours(false);
    cube.setColours(colours);
    cube.setOrientation(orientationOf(StandardView::Front));
    cube.show();
    const QPoint edge = cube.rect().center() + QPoint(26, 0);
    const auto blueness = [&] {
      const QColor c = cube.grab().toImage().pixelColor(edge);
      return c.blue() - c.red();
    };
    const int before = blueness();
    QMouseEvent move(QEvent::MouseMove, edge, cube.mapToGlobal(edge), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&cube, &move);
    QVERIFY(blueness() > before + 60);
    QCOMPARE(cube.toolTip(), "Front · Right");
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&cube, &leave);
    QCOMPARE(blueness(), before);
  }
};

HANDWHEEL_WIDGET_TEST(ViewCubeTest)
#include "ViewCubeTest.moc"

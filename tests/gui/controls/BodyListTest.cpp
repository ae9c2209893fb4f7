// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/bodies/BodyList.h"

#include "ControlsTestMain.h"
#include "scene/PrimitiveGeometry.h"

#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <memory>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const GeometryPointer kCube = *PrimitiveGeometry::make(Primitive::Cuboid, {1, 1, 1});

BodySet withBody(const BodySet& bodies, BodyId id, const std::string& name, bool isVisible = true) {
  return bodies.with(
      std::make_shared<const Body>(Body{.id = id, .name = name, .geometry = kCube, .visible = isVisible}));
}

BodySet manyBodies(BodyId count) {
  BodySet bodies;
  for (BodyId id = 1; id <= count; ++id) bodies = withBody(bodies, id, "body " + std::to_string(id));
  return bodies;
}

// A list in a window, with its requests.
struct BodyListFixture {
  BodyListFixture() {
    QObject::connect(&list, &BodyList::selected, &list, [this](const std::set<BodyId>& ids) { selected = ids; });
    QObject::connect(&list, &BodyList::renameRequested, &list, [this](BodyId id, const QString& name) {
      renamed = {id, name};
    });
    QObject::connect(&list, &BodyList::visibilityRequested, &list, [this](const std::set<BodyId>& ids, bool isVisible) {
      shown = {ids, isVisible};
    });
    list.resize(260, 300);
    list.show();
    list.activateWindow();
    if (!QTest::qWaitForWindowActive(&list)) qFatal("the window does not appear");
  }
  QPoint pointOf(int row, BodyModel::Column column) {
    return list.visualRect(list.model()->index(row, column)).center();
  }
  void click(int row, BodyModel::Column column = BodyModel::Name, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseClick(list.viewport(), Qt::LeftButton, keys, pointOf(row, column));
  }

  BodyList list;
  std::set<BodyId> selected;
  std::pair<BodyId, QString> renamed;
  std::pair<std::set<BodyId>, bool> shown;
};

}  // namespace

class BodyListTest : public QObject {
  Q_OBJECT

 private slots:
  // Any set may follow any other.
  void rowsAreThoseOfTheBodies() {
    BodyModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    std::vector<BodySet> versions{manyBodies(5), manyBodies(5).without(1).without(3), manyBodies(7).without(4),
                                  BodySet(),     withBody(manyBodies(3), 2, "other"), manyBodies(2)};
    for (const BodySet& bodies : versions) {
      model.setBodies(bodies);
      QCOMPARE(model.rowCount(), static_cast<int>(bodies.size()));
      int row = 0;
      for (const BodyPointer& body : bodies) {
        QCOMPARE(model.data(model.index(row, 0), Qt::DisplayRole).toString(), QString::fromStdString(body->name));
        QCOMPARE(model.indexOf(body->id).row(), row++);
      }
    }
    QVERIFY(!model.indexOf(3).isValid());
  }

  // Bodies without a carrier come first; after any change of carriers, each body is in one row.
  void rowsBelowWhatCarries() {
    BodyModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    const QStringList links{"base", "arm", "hand"};
    const auto carried = [](BodySet bodies, BodyId id, const char* by) {
      Body body = *bodies.withId(id);
      body.carrier = by;
      return bodies.with(std::make_shared<const Body>(body));
    };
    const BodySet five = manyBodies(5);
    const std::vector<BodySet> versions{five,
                                        carried(five, 2, "hand"),
                                        carried(carried(five, 2, "hand"), 4, "hand"),
                                        carried(carried(five, 2, "arm"), 4, "hand").without(5),
                                        carried(five, 1, "of another robot"),
                                        BodySet()};
    for (const BodySet& bodies : versions) {
      model.setBodies(bodies, links);
      int standing = 0;
      for (const BodyPointer& body : bodies) {
        const QModelIndex at = model.indexOf(body->id);
        QCOMPARE(model.body(at), body);
        const QString by = QString::fromStdString(body->carrier);
        QCOMPARE(at.parent().data().toString(), links.contains(by) ? by : QString());
        if (!at.parent().isValid()) QCOMPARE(at.row(), standing++);
      }
      QCOMPARE(model.rowCount(), standing + 3);
      QVERIFY(!model.body(model.indexOfCarrier("hand")));
    }
    model.setBodies(carried(five, 2, "hand"), {"hand"});
    QCOMPARE(model.indexOf(2).parent(), model.indexOfCarrier("hand"));
    model.setBodies(carried(five, 2, "hand"));
    QVERIFY(!model.indexOf(2).parent().isValid());
  }

  // Bodies are dropped on a carrier, on a carried body, beside all rows. Drags of another list are refused.
  void dropsAskForACarrier() {
    BodyModel model, other;
    Body onHand = *manyBodies(2).withId(2);
    onHand.carrier = "hand";
    const BodySet bodies = manyBodies(3).with(std::make_shared<const Body>(onHand));
    model.setBodies(bodies, {"base", "hand"});
    other.setBodies(bodies, {"base", "hand"});
    std::vector<std::pair<std::set<BodyId>, QString>> asked;
    connect(&model, &BodyModel::carrierRequested, this,
            [&](const std::set<BodyId>& ids, const QString& by) { asked.emplace_back(ids, by); });
    const auto drop = [&](const BodyModel& from, const QModelIndex& onto) {
      const std::unique_ptr<QMimeData> data(
          from.mimeData({from.indexOf(1), from.indexOf(1).siblingAtColumn(BodyModel::Eye), from.indexOf(3)}));
      return model.dropMimeData(data.get(), Qt::MoveAction, -1, -1, onto);
    };
    const std::set<BodyId> dragged{1, 3};
    QVERIFY(drop(model, model.indexOfCarrier("base")));
    QVERIFY(drop(model, model.indexOf(2)));
    QVERIFY(drop(model, model.indexOf(3)));
    QVERIFY(drop(model, {}));
    QCOMPARE(asked, (decltype(asked){{dragged, "base"}, {dragged, "hand"}, {dragged, ""}, {dragged, ""}}));
    QVERIFY(!drop(other, model.indexOfCarrier("base")));
    QCOMPARE(asked.size(), std::size_t{4});
    QVERIFY(!model.mimeData({model.indexOfCarrier("base")}));
    model.setBodies(bodies);
    QVERIFY(!model.flags(model.indexOf(1)).testFlag(Qt::ItemIsDragEnabled));
  }

  void clicksSelect() {
    BodyListFixture fixture;
    fixture.list.setBodies(manyBodies(5));
    fixture.click(1);
    QCOMPARE(fixture.selected, std::set<BodyId>{2});
    fixture.click(3, BodyModel::Name, Qt::ControlModifier);
    QCOMPARE(fixture.selected, (std::set<BodyId>{2, 4}));
    fixture.list.setBodies(manyBodies(5).without(1));  // does not lose them, and asks for nothing
    QCOMPARE(fixture.list.selectionModel()->selectedRows().size(), 2);
    QCOMPARE(fixture.selected, (std::set<BodyId>{2, 4}));
    fixture.list.setSelected({5});
    QCOMPARE(fixture.list.currentIndex().data().toString(), QString("body 5"));
    QCOMPARE(fixture.selected, (std::set<BodyId>{2, 4}));
  }

  void eyesAndSpaceHide() {
    BodyListFixture fixture;
    fixture.list.setBodies(withBody(manyBodies(3), 3, "hidden", false));
    fixture.click(1, BodyModel::Eye);
    QCOMPARE(fixture.shown, (std::pair<std::set<BodyId>, bool>({2}, false)));
    QVERIFY(fixture.selected.empty());
    fixture.click(2, BodyModel::Eye);
    QCOMPARE(fixture.shown, (std::pair<std::set<BodyId>, bool>({3}, true)));
    fixture.click(0);
    fixture.click(1, BodyModel::Name, Qt::ControlModifier);
    QTest::keyClick(&fixture.list, Qt::Key_Space);
    QCOMPARE(fixture.shown, (std::pair<std::set<BodyId>, bool>({1, 2}, false)));
  }

  void f2Renames() {
    BodyListFixture fixture;
    fixture.list.setBodies(manyBodies(3));
    fixture.click(1);
    QTest::keyClick(&fixture.list, Qt::Key_F2);
    auto* line = fixture.list.findChild<QLineEdit*>();
    QVERIFY(line);
    QTest::keyClicks(line, "vice");
    QTest::keyClick(line, Qt::Key_Return);
    QTRY_COMPARE(fixture.renamed, (std::pair<BodyId, QString>(2, "vice")));
  }
};

HANDWHEEL_CONTROLS_TEST(BodyListTest)
#include "BodyListTest.moc"

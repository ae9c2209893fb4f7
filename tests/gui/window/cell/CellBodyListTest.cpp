// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "CellWindow.h"
#include "controls/ActionText.h"
#include "controls/CommandModel.h"

using namespace handwheel;
using namespace handwheel::test;

// The list of the bodies of a cell, and what is selected in it and in the view.
class CellBodyListTest : public QObject {
  Q_OBJECT

 private slots:
  void aCoveredBodyIsFoundInTheList() {
    CellWindow driver;
    driver.choose("add-box");
    for (const char* field : {"body.1.x", "body.1.y", "body.1.z"}) driver.edit(field, "0");  // in the foot of the arm
    for (const char* field : {"body.1.size_x", "body.1.size_y", "body.1.size_z"}) driver.edit(field, "2");
    driver.choose("add-sphere");
    QVERIFY(driver.settle());
    driver.showAll();
    QVERIFY(driver.pixelOf("body.1").isNull());
    QCOMPARE(driver.field("body.2.name"), "sphere");
    driver.clickRow(0);
    QCOMPARE(driver.field("body.1.name"), "box");
    driver.clickRow(0, BodyModel::Eye);
    QVERIFY(driver.find<QAction>("undo")->text().contains("Hide box"));
    driver.clickRow(0, BodyModel::Eye);
    QVERIFY(driver.find<QAction>("undo")->text().contains("Show box"));
    driver.list()->setFocus();
    QTest::keyClick(driver.list(), Qt::Key_Delete);
    QCOMPARE(driver.listedBodies(), 1);
  }

  void whatIsSelectedIsTheSameInViewAndList() {
    CellWindow driver;
    driver.choose("add-box");
    QVERIFY(driver.settle());
    driver.showAll();
    const auto rows = [&] { return driver.list()->selectionModel()->selectedRows().size(); };
    const QPoint pixel = driver.pixelOf("body.1"), beside(driver.view()->width() / 2, 4);
    QVERIFY(!pixel.isNull());
    QCOMPARE(rows(), 1);
    for (const bool byKey : {true, false}) {
      if (byKey)
        QTest::keyClick(driver.view(), Qt::Key_Escape);
      else
        QTest::mouseClick(driver.view(), Qt::LeftButton, {}, beside);
      QCOMPARE(rows(), 0);
      QVERIFY(driver.field("body.1.name").isEmpty());
      QTest::mouseClick(driver.view(), Qt::LeftButton, {}, pixel);
      QCOMPARE(rows(), 1);
    }
    const QPoint link = driver.pixelOf("base_link/0");
    if (!link.isNull()) {
      QTest::mouseClick(driver.view(), Qt::LeftButton, {}, link);
      QCOMPARE(rows(), 0);
    }
  }

  // A body is dragged onto a link, which carries it from then on: it goes with the arm. Dropped on a body that stands
  // by itself it stands, too; on one that is carried, it goes with that. Each drop is one step.
  void aDropGivesABodyToALink() {
    CellWindow driver;
    driver.choose("add-box");
    driver.choose("add-sphere");
    driver.choose("add-cylinder");
    QVERIFY(driver.settle());
    const auto at = [&](const char* body, const char* axis) {
      return driver.field((std::string(body) + axis).c_str()).section(' ', 0, 0).toDouble();
    };
    const auto select = [&](BodyId id) { driver.list()->setCurrentIndex(driver.rows().indexOf(id)); };
    select(2);
    const double x = at("body.2.", "x"), y = at("body.2.", "y"), z = at("body.2.", "z");
    const auto carrierOf = [&](BodyId id) { return driver.rows().indexOf(id).parent().data().toString(); };
    QVERIFY(x > 100.0 && carrierOf(2).isEmpty());
    const QModelIndex link = driver.rows().indexOfCarrier("shoulder");
    QVERIFY(link.isValid());
    QVERIFY(driver.dropOn({driver.rows().indexOf(2)}, link));
    QVERIFY(driver.find<QAction>("undo")->text().contains("Attach sphere to shoulder"));
    QCOMPARE(carrierOf(2), QString("shoulder"));
    QTest::keyClick(driver.view(), Qt::Key_Escape);  // the joints are shown where no body is selected
    driver.edit("joint.joint_1", "90");
    QVERIFY(driver.dropOn({driver.rows().indexOf(2)}, driver.rows().indexOf(1)));
    QVERIFY(driver.find<QAction>("undo")->text().contains("Release sphere"));
    QVERIFY(carrierOf(2).isEmpty());
    select(2);
    QVERIFY(std::abs(at("body.2.", "x") + y) < 0.01 && std::abs(at("body.2.", "y") - x) < 0.01);
    QVERIFY(std::abs(at("body.2.", "z") - z) < 0.01);
    driver.click("quickActions/undo");
    QCOMPARE(carrierOf(2), QString("shoulder"));
    QVERIFY(driver.dropOn({driver.rows().indexOf(1), driver.rows().indexOf(3)}, driver.rows().indexOf(2)));
    QVERIFY(driver.find<QAction>("undo")->text().contains("Attach 2 bodies to shoulder"));
    QCOMPARE(carrierOf(1), QString("shoulder"));
    QCOMPARE(carrierOf(3), QString("shoulder"));
    driver.click("quickActions/undo");
    QVERIFY(carrierOf(1).isEmpty() && carrierOf(3).isEmpty());
  }

  // Bodies carry no bodies, so none goes round in a circle: that is said, and nothing changes.
  void aDropThatChangesNothingSaysWhy() {
    CellWindow driver;
    driver.choose("add-box");
    driver.choose("add-sphere");
    QVERIFY(driver.settle());
    const QString before = driver.find<QAction>("undo")->text();
    QVERIFY(driver.dropOn({driver.rows().indexOf(1)}, driver.rows().indexOf(2)));
    QCOMPARE(driver.find<QAction>("undo")->text(), before);
    QTRY_VERIFY(driver.text("messageText").contains("Only links of robots carry bodies"));
  }

  void aRefusedNameSaysWhy() {
    CellWindow driver;
    driver.choose("add-box");
    driver.choose("add-sphere");
    auto* row = driver.find<QDockWidget>("kindDock")->findChild<QWidget*>("property/body.2.name");
    QTRY_VERIFY(row->isVisible());
    auto* line = row->findChild<QLineEdit*>();
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, "box");
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(line->text(), QString("box"));
    const auto* problem = row->findChild<QLabel*>("propertyProblem");
    QVERIFY(problem->isVisible());
    QVERIFY2(problem->text().contains("'box'"), qPrintable(problem->text()));
  }

  void isRenamedByTheMenu() {
    CellWindow driver;
    driver.choose("add-box");
    driver.choose("renameBody");
    auto* editor = driver.list()->findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->setText("vice");
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(driver.field("body.1.name"), "vice");
    driver.click("quickActions/undo");
    QCOMPARE(driver.field("body.1.name"), "box");
  }

  void aRightClickOpensTheMenuOfTheBody() {
    CellWindow driver;
    driver.choose("add-box");
    QVERIFY(driver.settle());
    driver.showAll();
    const QPoint pixel = driver.pixelOf("body.1");
    QTest::keyClick(driver.view(), Qt::Key_Escape);
    QTest::mouseClick(driver.view(), Qt::RightButton, {}, pixel);
    auto* menu = driver.find<QMenu>("bodyMenu");
    QTRY_VERIFY(menu->isVisible());
    QCOMPARE(driver.field("body.1.name"), "box");
    menu->close();
  }

  void aCommandIsThereOnceAndSaysWhyItIsDisabled() {
    CellWindow driver;
    driver.choose("add-box");
    CommandModel model;
    model.setActions(commandsOf(driver.window()), {});
    model.setQuery("remove the body");
    int count = 0;
    for (int row = 0; row < model.rowCount(); ++row)
      count += model.index(row).data().toString().toLower() == "remove the body";
    QCOMPARE(count, 1);
    QTest::keyClick(driver.view(), Qt::Key_Escape);
    QVERIFY(driver.find<QAction>("removeBody")->property(kDisabledReason).toString().contains("Select a body"));
  }
};

HANDWHEEL_WINDOW_TEST(CellBodyListTest)
#include "CellBodyListTest.moc"

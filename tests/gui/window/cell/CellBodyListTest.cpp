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
    QVERIFY(driver.placeOf("body.1").isNull());
    QCOMPARE(driver.field("body.2.name"), "sphere");
    driver.clickRow(0);
    QCOMPARE(driver.field("body.1.name"), "box");
    driver.clickRow(0, BodyModel::Eye);
    QVERIFY(driver.find<QAction>("undo")->text().contains("Hide box"));
    driver.clickRow(0, BodyModel::Eye);
    QVERIFY(driver.find<QAction>("undo")->text().contains("Show box"));
    driver.list()->setFocus();
    QTest::keyClick(driver.list(), Qt::Key_Delete);
    QCOMPARE(driver.list()->model()->rowCount(), 1);
  }

  void whatIsSelectedIsTheSameInViewAndList() {
    CellWindow driver;
    driver.choose("add-box");
    QVERIFY(driver.settle());
    driver.showAll();
    const auto rows = [&] { return driver.list()->selectionModel()->selectedRows().size(); };
    const QPoint place = driver.placeOf("body.1"), beside(driver.view()->width() / 2, 4);
    QVERIFY(!place.isNull());
    QCOMPARE(rows(), 1);
    for (const bool byKey : {true, false}) {
      if (byKey)
        QTest::keyClick(driver.view(), Qt::Key_Escape);
      else
        QTest::mouseClick(driver.view(), Qt::LeftButton, {}, beside);
      QCOMPARE(rows(), 0);
      QVERIFY(driver.field("body.1.name").isEmpty());
      QTest::mouseClick(driver.view(), Qt::LeftButton, {}, place);
      QCOMPARE(rows(), 1);
    }
    const QPoint link = driver.placeOf("base_link/0");
    if (!link.isNull()) {
      QTest::mouseClick(driver.view(), Qt::LeftButton, {}, link);
      QCOMPARE(rows(), 0);
    }
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
    const QPoint place = driver.placeOf("body.1");
    QTest::keyClick(driver.view(), Qt::Key_Escape);
    QTest::mouseClick(driver.view(), Qt::RightButton, {}, place);
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

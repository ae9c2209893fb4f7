// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ControlsTestMain.h"
#include "controls/property/PropertyList.h"

#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

using namespace handwheel;

// A text property with choices: they are offered, and any other text may be typed.
class SuggestedTextTest : public QObject {
  Q_OBJECT

 private slots:
  void offersAndTakesOthers() {
    PropertyList list;
    const auto show = [&](const std::string& value) {
      list.setProperties({{.id = "material",
                           .group = "",
                           .label = "Material",
                           .value = value,
                           .choices = {"Brass", "Pure titanium"}}});
    };
    show("");
    list.show();
    QSignalSpy spy(&list, &PropertyList::edited);
    const auto* button = list.findChild<QToolButton*>("propertySuggestions");
    auto* line = list.findChild<QLineEdit*>("propertyText");
    QVERIFY(button && button->menu() && line);
    const QList<QAction*> offered = button->menu()->actions();
    QCOMPARE(offered.size(), 2);
    QVERIFY(offered[0]->text() == "Brass" && offered[1]->text() == "Pure titanium");
    offered[1]->trigger();
    QCOMPARE(spy.size(), 1);
    QCOMPARE(std::get<std::string>(spy[0][1].value<PropertyValue>()), std::string("Pure titanium"));
    show("Pure titanium");
    QCOMPARE(line->text(), QString("Pure titanium"));
    QCOMPARE(button->menu()->actions().size(), 2);
    line->clear();
    QTest::keyClicks(line, "cheese");
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(spy.size(), 2);
    QCOMPARE(std::get<std::string>(spy[1][1].value<PropertyValue>()), std::string("cheese"));
    list.setProperties({{.id = "material",
                         .group = "",
                         .label = "Material",
                         .value = "Brass",
                         .choices = {"Brass"},
                         .editable = false}});
    QVERIFY(list.findChild<QLabel*>("propertyValue") && list.findChild<QLabel*>("propertyValue")->text() == "Brass");
  }
};

HANDWHEEL_CONTROLS_TEST(SuggestedTextTest)
#include "SuggestedTextTest.moc"

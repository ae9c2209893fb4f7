// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/property/PropertyList.h"

#include "Accessibility.h"
#include "ControlScenes.h"
#include "ControlsTestMain.h"
#include "controls/FocusedField.h"
#include "controls/property/PropertyRow.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QColorDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

using namespace handwheel;
using namespace handwheel::test;

namespace {

struct Edit {
  std::string id;
  PropertyValue value;
  bool stillDragging;

  bool operator==(const Edit&) const = default;
};

// A list in a window that records its signals.
struct PropertyListFixture {
  PropertyListFixture() {
    list.setProperties(sampleProperties());
    QObject::connect(&list, &PropertyList::edited, &list,
                     [this](const std::string& id, const PropertyValue& value, bool stillDragging) {
                       edits.push_back({id, value, stillDragging});
                       if (onEdit) onEdit();
                     });
    list.resize(280, 900);
    list.show();
    list.activateWindow();
    if (!QTest::qWaitForWindowActive(&list)) qFatal("the window does not appear");
  }
  template <class Widget>
  Widget* find(const std::string& id, const char* name) {
    auto* row = list.findChild<QWidget*>("property/" + QString::fromStdString(id));
    auto* widget = row ? row->findChild<Widget*>(QString::fromLatin1(name)) : nullptr;
    if (!widget) qFatal("there is no %s", id.c_str());
    return widget;
  }

  PropertyList list;
  std::vector<Edit> edits;
  std::function<void()> onEdit;
};

Property& named(std::vector<Property>& properties, const std::string& id) {
  return *std::find_if(properties.begin(), properties.end(), [&](const Property& p) { return p.id == id; });
}

}  // namespace

class PropertyListTest : public QObject {
  Q_OBJECT

 private slots:
  // A group is folded below its heading, by the mouse or a key; it stays so until its initial state changes.
  void groupsFold() {
    PropertyListFixture fixture;
    std::vector<Property> properties = sampleProperties();
    const std::string group = properties.front().group, id = properties.front().id;
    const auto row = [&] { return fixture.list.findChild<QWidget*>("property/" + QString::fromStdString(id)); };
    const auto heading = [&] {
      QToolButton* found = nullptr;
      for (auto* each : fixture.list.findChildren<QToolButton*>("propertyGroup/" + QString::fromStdString(group)))
        if (!each->isHidden()) found = each;
      return found;
    };
    const auto show = [&](bool isOpen) {
      fixture.list.setFolding({{group, isOpen}});
      fixture.list.setProperties(properties);
      QTest::qWait(1);
    };
    show(false);
    QVERIFY(heading() && !row()->isVisible());
    QTest::mouseClick(heading(), Qt::LeftButton);
    QVERIFY(row()->isVisible());
    show(false);
    QVERIFY(row()->isVisible());
    heading()->setFocus();
    QTest::keyClick(heading(), Qt::Key_Space);
    QVERIFY(!row()->isVisible());
    show(true);
    QVERIFY(row()->isVisible());
    fixture.list.setFolding({});
    fixture.list.setProperties(properties);
    QVERIFY(row()->isVisible() && !heading());
  }

  void editsOfEachKind();
  void longTexts();
  void typedTextIsReported();
  void numbersInTexts();
  void sliderDrags();
  void valuesChangeInPlace();
  void rowsSurviveAChangeOfTheSet();
  void aRowMayGoWhileItSpeaks();
  void followsTheLengthUnit();
  void readOnlyValuesAndProblems();
  void tabFollowsTheOrder();
  void aRefusedTextStaysWithTheReason();
  void coloursHaveAButton();
  void choicesInAList();

  // A long choice has the width of its label, too, and its list is as wide as its names.
  void longChoicesHaveRoom() {
    PropertyListFixture fixture;
    const std::string steel = "Unalloyed steel from 0.25 % C, annealed";
    Property material{.id = "m", .group = "Stock", .label = "Material", .value = 0.0, .choices = {"Brass", "Wood"}};
    fixture.list.setProperties({material});
    auto* box = fixture.find<QComboBox>("m", "propertyChoice");
    QTRY_VERIFY(box->isVisible() && box->width() < box->parentWidget()->width());
    material.choices = {steel, "Brass"};
    fixture.list.setProperties({material});
    QTRY_COMPARE(box->width(), box->parentWidget()->width());
    QVERIFY(box->view()->minimumWidth() >= box->fontMetrics().horizontalAdvance(QString::fromStdString(steel)));
    material.choices = {"Brass", "Wood"};
    fixture.list.setProperties({material});
    QTRY_VERIFY(box->width() < box->parentWidget()->width());
  }
  void aLimitThatIsNear();
  void strangeValues();

  // A person who compares one field of several things need not look for it anew.
  void otherPropertiesStayScrolled() {
    PropertyListFixture fixture;
    const auto form = [](const std::string& of) {
      std::vector<Property> all;
      for (int i = 0; i < 40; ++i)
        all.push_back({.id = of + std::to_string(i), .group = "Mark", .label = "Limit", .value = 1.0});
      return all;
    };
    fixture.list.resize(280, 300);
    fixture.list.setProperties(form("a"));
    QScrollBar* const bar = fixture.list.verticalScrollBar();
    QTRY_VERIFY(bar->maximum() > 500);
    bar->setValue(400);
    fixture.list.setProperties(form("b"));
    QTest::qWait(50);
    QVERIFY(fixture.list.findChild<QWidget*>("property/b0") && !fixture.list.findChild<QWidget*>("property/a0"));
    QCOMPARE(bar->value(), 400);
  }
};

void PropertyListTest::editsOfEachKind() {
  PropertyListFixture fixture;
  auto* diameter = fixture.find<QLineEdit>("diameter", "numberLine");
  diameter->setFocus();
  diameter->selectAll();
  QTest::keyClicks(diameter, "2 in\r");
  QTest::mouseClick(fixture.find<QCheckBox>("coolant", "propertySwitch"), Qt::LeftButton, {}, QPoint(8, 10));
  auto* note = fixture.find<QLineEdit>("note", "propertyText");
  note->setFocus();
  QTest::keyClicks(note, "!\r");
  auto* material = fixture.find<QComboBox>("material", "propertyChoice");
  material->setFocus();
  QTest::keyClick(material, Qt::Key_Down);
  QVERIFY(fixture.edits == std::vector<Edit>({{"diameter", 50.8, false},
                                              {"coolant", false, false},
                                              {"note", std::string("first try!"), false},
                                              {"material", 2.0, false}}));
}

// A text of numbers is shown and typed with the decimal separator of the user, and reported with points.
void PropertyListTest::numbersInTexts() {
  PropertyListFixture fixture;
  fixture.list.setLocale(QLocale(QLocale::German));
  std::vector<Property> properties = sampleProperties();
  named(properties, "note").value = std::string("±0.05");
  named(properties, "note").isNumbers = true;
  fixture.list.setProperties(properties);
  auto* note = fixture.find<QLineEdit>("note", "propertyText");
  QCOMPARE(note->text(), QString("±0,05"));
  note->setFocus();
  for (const char* typed : {"0,25", "0.25"}) {
    note->selectAll();
    QTest::keyClicks(note, QLatin1String(typed) + "\r");
    QVERIFY(!fixture.edits.empty() && fixture.edits.back() == (Edit{"note", std::string("0.25"), false}));
  }
}

// A text of several lines is typed with its lines, committed by Ctrl+Return or when the field is left, and reverted by
// Esc.
void PropertyListTest::longTexts() {
  PropertyListFixture fixture;
  std::vector<Property> properties = sampleProperties();
  named(properties, "note").value = std::string("Turn the\nshaft.");
  named(properties, "note").id = "step.1.text";
  fixture.list.setProperties(properties);
  auto* field = fixture.find<QPlainTextEdit>("step.1.text", "propertyLongText");
  QCOMPARE(field->toPlainText(), QString("Turn the\nshaft."));
  QVERIFY(!field->accessibleName().isEmpty());
  field->setFocus();
  field->moveCursor(QTextCursor::End);
  QTest::keyClick(field, Qt::Key_Return);
  QTest::keyClicks(field, "Then part it off.");
  QVERIFY(fixture.edits.empty());
  QTest::keyClick(field, Qt::Key_Return, Qt::ControlModifier);
  const std::string whole = "Turn the\nshaft.\nThen part it off.";
  QVERIFY(fixture.edits == std::vector<Edit>({{"step.1.text", whole, false}}));
  named(properties, "step.1.text").value = whole;
  fixture.list.setProperties(properties);
  QTest::keyClicks(field, "!");
  QTest::keyClick(field, Qt::Key_Escape);
  QCOMPARE(field->toPlainText(), QString::fromStdString(whole));
  QTest::keyClicks(field, "?");
  fixture.find<QLineEdit>("diameter", "numberLine")->setFocus();
  QCOMPARE(fixture.edits.size(), std::size_t{2});
  QCOMPARE(std::get<std::string>(fixture.edits.back().value).size(), whole.size() + 1);
  // A refused value stays, until the value is another one.
  fixture.list.refuse("step.1.text", std::string("refused"), "No.");
  fixture.list.setProperties(properties);
  QCOMPARE(field->toPlainText(), QString("refused"));
  named(properties, "step.1.text").value = std::string("another");
  fixture.list.setProperties(properties);
  QCOMPARE(field->toPlainText(), QString("another"));
}

// Typed text is reported before it is saved or hidden, and typing goes on.
void PropertyListTest::typedTextIsReported() {
  PropertyListFixture fixture;
  auto* note = fixture.find<QLineEdit>("note", "propertyText");
  note->setFocus();
  commitFocusedField();
  QVERIFY(fixture.edits.empty());
  QTest::keyClicks(note, "!");
  QVERIFY(fixture.edits.empty());
  commitFocusedField();
  QVERIFY(fixture.edits == std::vector<Edit>({{"note", std::string("first try!"), false}}));
  QVERIFY(note->hasFocus());
}

void PropertyListTest::sliderDrags() {
  PropertyListFixture fixture;
  auto* slider = fixture.find<QSlider>("joint1", "propertySlider");
  auto* line = fixture.find<QLineEdit>("joint1", "numberLine");
  QVERIFY(slider->isVisible());
  QVERIFY(!fixture.find<QSlider>("diameter", "propertySlider")->isVisible());
  QVERIFY(fixture.find<QLabel>("joint1", "propertyLower")->isVisible());
  QCOMPARE(fixture.find<QLabel>("joint1", "propertyLower")->text(), QString("-180°"));
  QCOMPARE(fixture.find<QLabel>("joint1", "propertyUpper")->text(), QString("180°"));
  QVERIFY(!fixture.find<QLabel>("diameter", "propertyUpper")->isVisible());
  QCOMPARE(slider->value(), 583);  // (30 + 180) / 360 of 1000
  slider->setSliderDown(true);
  slider->setSliderPosition(1000);
  slider->setSliderPosition(500);
  // The document answers with its own value while the slider is held: the handle stays under the hand.
  auto properties = sampleProperties();
  named(properties, "joint1").value = 0.1;
  fixture.list.setProperties(properties);
  QCOMPARE(slider->value(), 500);
  QCOMPARE(line->text(), QString("5.72958"));  // 0.1 rad = 5.7295779…°
  slider->setSliderPosition(0);
  slider->setSliderDown(false);
  const double pi = std::numbers::pi;
  QVERIFY(
      fixture.edits ==
      std::vector<Edit>({{"joint1", pi, true}, {"joint1", 0.0, true}, {"joint1", -pi, true}, {"joint1", -pi, false}}));
  fixture.edits.clear();
  slider->setSliderDown(true);  // pressed and let go
  slider->setSliderDown(false);
  QVERIFY(fixture.edits.empty());
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_End);
  QVERIFY(fixture.edits == std::vector<Edit>({{"joint1", pi, false}}));
}

void PropertyListTest::valuesChangeInPlace() {
  PropertyListFixture fixture;
  auto* diameter = fixture.find<QLineEdit>("diameter", "numberLine");
  auto* length = fixture.find<QLineEdit>("length", "numberLine");
  diameter->setFocus();
  diameter->selectAll();
  QTest::keyClicks(diameter, "7");
  auto properties = sampleProperties();
  named(properties, "diameter").value = 51.0;
  named(properties, "length").value = 99.0;
  named(properties, "coolant").value = false;
  named(properties, "material").choices = {"Aluminium 6082", "Steel C45", "Brass", "Wood"};
  named(properties, "joint2").problem.clear();
  fixture.list.setProperties(properties);
  QCOMPARE(diameter, fixture.find<QLineEdit>("diameter", "numberLine"));
  QCOMPARE(QApplication::focusWidget(), diameter);
  QCOMPARE(diameter->text(), QString("7"));
  QCOMPARE(length->text(), QString("99"));
  QVERIFY(!fixture.find<QCheckBox>("coolant", "propertySwitch")->isChecked());
  QCOMPARE(fixture.find<QComboBox>("material", "propertyChoice")->count(), 4);
  QCOMPARE(fixture.find<QComboBox>("material", "propertyChoice")->currentText(), QString("Steel C45"));
  QVERIFY(!fixture.find<QLabel>("joint2", "propertyProblem")->isVisible());
  QVERIFY(fixture.edits.empty());
}

void PropertyListTest::rowsSurviveAChangeOfTheSet() {
  PropertyListFixture fixture;
  auto* slider = fixture.find<QSlider>("joint2", "propertySlider");
  slider->setFocus();
  slider->setSliderDown(true);
  auto properties = sampleProperties();
  std::reverse(properties.begin(), properties.end());
  properties.push_back({.id = "speed", .group = "", .label = "Speed", .value = 3.0});
  properties.erase(properties.begin());
  fixture.list.setProperties(properties);
  QCOMPARE(fixture.find<QSlider>("joint2", "propertySlider"), slider);
  QCOMPARE(QApplication::focusWidget(), slider);
  QVERIFY(slider->isSliderDown());
  slider->setSliderDown(false);
  QTest::qWait(1);  // removed widgets are deleted later
  QCOMPARE(fixture.list.findChildren<PropertyRow*>().size(), qsizetype(properties.size()));
  // The tab order goes down the page in the order of the list.
  int bottom = 0;
  for (const Property& p : properties) {
    const auto* row = fixture.list.findChild<QWidget*>("property/" + QString::fromStdString(p.id));
    QVERIFY(row->y() >= bottom);
    bottom = row->geometry().bottom();
  }
}

void PropertyListTest::aRowMayGoWhileItSpeaks() {
  PropertyListFixture fixture;
  fixture.onEdit = [&] { fixture.list.setProperties({}); };
  QTest::mouseClick(fixture.find<QCheckBox>("coolant", "propertySwitch"), Qt::LeftButton, {}, QPoint(8, 10));
  QTest::qWait(1);
  QCOMPARE(fixture.edits.size(), std::size_t(1));
  QVERIFY(fixture.list.findChildren<PropertyRow*>().isEmpty());
}

void PropertyListTest::followsTheLengthUnit() {
  PropertyListFixture fixture;
  fixture.list.setLengthUnit(LengthUnit::Inch);
  QCOMPARE(fixture.find<QLineEdit>("diameter", "numberLine")->text(), QString("1.968504"));  // 50 / 25.4
  QCOMPARE(fixture.find<QLineEdit>("joint1", "numberLine")->text(), QString("30"));
  QCOMPARE(fixture.find<QLabel>("size", "propertyValue")->text(), QString("48.605\u00a0in"));  // 1234.5678 / 25.4
  fixture.list.setProperties(sampleProperties());
  QCOMPARE(fixture.find<QLineEdit>("diameter", "numberLine")->text(), QString("1.968504"));
}

void PropertyListTest::readOnlyValuesAndProblems() {
  PropertyListFixture fixture;
  QCOMPARE(fixture.find<QLabel>("volume", "propertyValue")->text(), QString("1170000"));
  QCOMPARE(fixture.find<QLabel>("closed", "propertyValue")->text(), QString("no"));
  auto* problem = fixture.find<QLabel>("joint2", "propertyProblem");
  QVERIFY(problem->isVisible());
  QCOMPARE(problem->text(), QString("The effort of this joint is not known."));
  fixture.list.setProperties(
      {{.id = "m", .group = "", .label = "M", .value = 1.0, .choices = {"a", "b"}, .editable = false}});
  QCOMPARE(fixture.find<QLabel>("m", "propertyValue")->text(), QString("b"));
}

void PropertyListTest::tabFollowsTheOrder() {
  PropertyListFixture fixture;
  auto properties = sampleProperties();
  std::swap(properties[0], properties[5]);  // the note comes first
  properties.insert(properties.begin() + 6, {.id = "new", .group = "Joints", .label = "New", .value = 1.0});
  fixture.list.setProperties(properties);
  QTest::qWait(1);  // until the new row is shown
  fixture.find<QLineEdit>("note", "propertyText")->setFocus();
  QStringList order;
  for (int i = 0; i < 10; ++i) {
    const QWidget* at = QApplication::focusWidget();
    while (at && !at->objectName().startsWith("property/")) at = at->parentWidget();
    if (at) order << at->objectName().mid(9);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  }
  QCOMPARE(order, QStringList({"note", "length", "chord", "material", "coolant", "diameter", "new", "joint1", "joint1",
                               "joint2"}));
  QCOMPARE(notReachedByTab(fixture.list).join("\n"), QString());
}

// A document with a bug, or limits from a strange file, must not harm the window.
void PropertyListTest::aRefusedTextStaysWithTheReason() {
  const Property name{.id = "name", .group = {}, .label = "Name", .value = "table"};
  PropertyListFixture fixture;
  fixture.list.setProperties({name});
  auto* line = fixture.find<QLineEdit>("name", "propertyText");
  auto* problem = fixture.find<QLabel>("name", "propertyProblem");
  QTRY_VERIFY(line->isVisible());
  fixture.onEdit = [&] {
    fixture.list.setProperties({name});  // the document has not taken it
    fixture.list.refuse("name", fixture.edits.back().value, "It is taken.");
  };
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, "vice");
  QTest::keyClick(line, Qt::Key_Return);
  QCOMPARE(line->text(), QString("vice"));
  QVERIFY(problem->isVisible());
  QCOMPARE(problem->text(), QString("It is taken."));
  fixture.list.setProperties({name});  // something else changed
  QCOMPARE(line->text(), QString("vice"));
  QVERIFY(problem->isVisible());
  QTest::keyClick(line, Qt::Key_Backspace);  // it is being corrected
  QVERIFY(!problem->isVisible());
  QTest::keyClick(line, Qt::Key_Return);
  QVERIFY(problem->isVisible());
  QTest::keyClick(line, Qt::Key_Escape);
  QCOMPARE(line->text(), QString("table"));
  QVERIFY(!problem->isVisible());
  QCOMPARE(fixture.edits.size(), std::size_t{2});
}

void PropertyListTest::coloursHaveAButton() {
  PropertyListFixture fixture;
  fixture.list.setProperties({{.id = "part.colour", .group = {}, .label = "Colour", .value = "#ff0000"}});
  auto* button = fixture.find<QToolButton>("part.colour", "propertyColour");
  QTRY_VERIFY(button->isVisible());
  QTest::mouseClick(button, Qt::LeftButton);
  auto* dialog = fixture.list.findChild<QColorDialog*>("colourDialog");
  QVERIFY(dialog);
  QCOMPARE(dialog->currentColor(), QColor(255, 0, 0));
  dialog->setCurrentColor(QColor(0, 128, 255));
  dialog->accept();
  QCOMPARE(fixture.edits, (std::vector<Edit>{{"part.colour", std::string("#0080ff"), false}}));
}

// All choices are visible; a click chooses, and the keyboard focus stays.
void PropertyListTest::choicesInAList() {
  PropertyListFixture fixture;
  Property choice{.id = "way", .group = "Ways", .label = "Ways", .value = 0.0, .choices = {"a", "b", "c"}};
  choice.continuous = true;
  fixture.list.setProperties({choice});
  auto* rows = fixture.find<QListWidget>("way", "propertyList/choices");
  QCOMPARE(rows->count(), 3);
  QCOMPARE(rows->currentRow(), 0);
  QCOMPARE(rows->accessibleName(), "Ways");
  QTest::mouseClick(rows->viewport(), Qt::LeftButton, {}, rows->visualItemRect(rows->item(2)).center());
  QCOMPARE(fixture.edits, (std::vector<Edit>{{"way", 2.0, false}}));
  QVERIFY(!rows->hasFocus());
  choice.choices = {"a", "d"};
  choice.value = 1.0;
  fixture.list.setProperties({choice});  // is no edit
  QCOMPARE(rows->count(), 2);
  QCOMPARE(rows->currentItem()->text(), "d");
  QCOMPARE(fixture.edits.size(), std::size_t{1});
}

void PropertyListTest::aLimitThatIsNear() {
  PropertyListFixture fixture;
  Property joint{.id = "joint", .group = "", .label = "J", .value = 0.0, .least = -1.0, .largest = 1.0};
  joint.continuous = true;
  const auto isMarked = [&](const char* limit) {
    return fixture.find<QLabel>("joint", limit)->property("bad").toBool();
  };
  for (const double value : {0.0, 0.97, 0.2, -1.0, -0.5}) {
    joint.value = value;
    fixture.list.setProperties({joint});
    QCOMPARE(isMarked("propertyUpper"), value > 0.95);
    QCOMPARE(isMarked("propertyLower"), value < -0.95);
  }
}

void PropertyListTest::strangeValues() {
  const double inf = std::numeric_limits<double>::infinity();
  PropertyList list;
  list.setProperties(
      {{.id = "a", .group = "", .label = "A", .value = std::nan(""), .least = 0.0, .largest = 1.0, .continuous = true},
       {.id = "b", .group = "", .label = "B", .value = inf, .least = 1.0, .largest = 0.0, .continuous = true},
       {.id = "c", .group = "", .label = "C", .value = 7.0, .choices = {"x"}},
       {.id = "d", .group = "", .label = "D", .value = std::nan(""), .choices = {"x"}, .editable = false},
       {.id = "e", .group = "", .label = "E", .value = true, .choices = {"x"}},
       {.id = "f", .group = "", .label = "", .value = std::string("<b>plain</b>"), .editable = false},
       {.id = "g", .group = "", .label = "G", .value = 0.5, .least = -1e308, .largest = 1e308, .continuous = true}});
  list.show();
  auto* slider = list.findChild<QWidget*>("property/g")->findChild<QSlider*>();
  QSignalSpy spy(&list, &PropertyList::edited);
  slider->setValue(slider->maximum());
  QCOMPARE(spy.size(), 1);
  QCOMPARE(std::get<double>(spy[0][1].value<PropertyValue>()), 1e308);
}

HANDWHEEL_CONTROLS_TEST(PropertyListTest)
#include "PropertyListTest.moc"

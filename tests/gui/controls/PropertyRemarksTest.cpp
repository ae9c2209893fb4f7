// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ControlsTestMain.h"
#include "controls/property/PropertyList.h"

#include <QLabel>
#include <QLineEdit>
#include <QTest>

using namespace handwheel;

namespace {

constexpr const char* kNoLimit = "they cannot be scored without a limit";

std::vector<Property> criterionFields() {
  return {{.id = "name", .group = "Stem", .label = "Name", .value = "Stem"},
          {.id = "from", .group = "Stem", .label = "From Z", .value = 10.0},
          {.id = "points", .group = "Stem", .label = "Points", .value = 5.0},
          {.id = "slack", .group = "Stem", .label = "No points this far beyond", .value = 0.2}};
}

// A form with an area for remarks, once it is laid out.
struct RemarkedForm {
  RemarkedForm() {
    list.reserveRemarkSpace();
    list.setProperties(fields);
    list.resize(280, 400);
    list.show();
    if (!QTest::qWaitForWindowExposed(&list)) qFatal("the form does not appear");
  }
  void setPointsProblem(const char* problem) {
    fields[2].problem = problem;
    list.setProperties(fields);
    QTest::qWait(1);
  }
  QWidget* row(const char* id) {
    auto* found = list.findChild<QWidget*>(QStringLiteral("property/") + QLatin1String(id));
    if (!found) qFatal("there is no %s", id);
    return found;
  }
  QList<QRect> rectangles() {
    QList<QRect> all;
    for (const Property& each : fields) {
      const QWidget* const at = row(each.id.c_str());
      all << QRect(at->mapTo(&list, QPoint(0, 0)), at->size());
    }
    return all;
  }
  const QLabel& remarks() { return *list.findChild<QLabel*>("propertyRemarks"); }

  std::vector<Property> fields = criterionFields();
  PropertyList list;
};

}  // namespace

// Remarks in an area of their own below a form.
class PropertyRemarksTest : public QObject {
  Q_OBJECT

 private slots:
  // A field stays at its position for a click, whatever is remarked on the one before.
  void fieldsStayWhereTheyAre() {
    RemarkedForm form;
    QTest::qWait(1);
    const QList<QRect> before = form.rectangles();
    QCOMPARE(form.remarks().text(), QString());
    form.setPointsProblem(kNoLimit);
    QCOMPARE(form.remarks().text(), QStringLiteral("Points: ") + QLatin1String(kNoLimit));
    QVERIFY(form.remarks().isVisible() && !form.row("points")->findChild<QLabel*>("propertyProblem")->isVisible());
    QVERIFY(form.remarks().geometry().top() > form.list.viewport()->geometry().bottom());
    QCOMPARE(form.rectangles(), before);
    form.setPointsProblem("");
    QCOMPARE(form.remarks().text(), QString());
    QCOMPARE(form.rectangles(), before);
  }

  // A refused value comes first; its remark goes as soon as it is being corrected.
  void whatWasRefused() {
    RemarkedForm form;
    form.setPointsProblem(kNoLimit);
    const QList<QRect> before = form.rectangles();
    form.list.refuse("name", std::string("Foot"), "It is taken.");
    QTest::qWait(1);
    QCOMPARE(form.remarks().text(), QStringLiteral("Name: It is taken.\nPoints: ") + QLatin1String(kNoLimit));
    QCOMPARE(form.rectangles(), before);
    auto* line = form.row("name")->findChild<QLineEdit*>("propertyText");
    QCOMPARE(line->text(), QStringLiteral("Foot"));
    line->setFocus();
    QTest::keyClick(line, Qt::Key_Backspace);
    QCOMPARE(form.remarks().text(), QStringLiteral("Points: ") + QLatin1String(kNoLimit));
  }

  // The label names the field of the remark, too.
  void theLabelLooksBad() {
    RemarkedForm form;
    const auto labelled = [&](const char* id) {
      for (const QLabel* label : form.row(id)->findChildren<QLabel*>())
        if (label->objectName().isEmpty() && label->property("bad").toBool()) return true;
      return false;
    };
    QVERIFY(!labelled("points"));
    form.setPointsProblem(kNoLimit);
    QVERIFY(labelled("points") && !labelled("slack"));
    form.setPointsProblem("");
    QVERIFY(!labelled("points"));
  }

  // More than fits is cut off, and in the tool tip: the area stays the same.
  void manyRemarks() {
    RemarkedForm form;
    const QRect geometry = form.remarks().geometry();
    const QList<QRect> before = form.rectangles();
    for (Property& each : form.fields)
      each.problem = "<b> is no number that the lathe could be set to, nor is it near one";
    form.setPointsProblem(kNoLimit);
    QCOMPARE(form.remarks().geometry(), geometry);
    QCOMPARE(form.rectangles(), before);
    QVERIFY(form.remarks().toolTip().contains("&lt;b&gt;") && form.remarks().toolTip().contains(kNoLimit));
  }
};

HANDWHEEL_CONTROLS_TEST(PropertyRemarksTest)
#include "PropertyRemarksTest.moc"

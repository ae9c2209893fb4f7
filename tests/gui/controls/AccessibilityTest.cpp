// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Accessibility.h"

#include "ControlsTestMain.h"

#include <QPushButton>
#include <QSpinBox>
#include <QTreeWidget>
#include <QVBoxLayout>

using namespace handwheel::test;

// The checks find what they look for, and nothing else.
class AccessibilityTest : public QObject {
  Q_OBJECT

 private slots:
  void names();
  void tab();
  void cut();
};

namespace {

struct Form {
  explicit Form(int width = 300) {
    new QVBoxLayout(&window);
    window.resize(width, 200);
  }
  template <class Widget>
  Widget* add(const char* name, Widget* widget) {
    widget->setObjectName(QString::fromLatin1(name));
    window.layout()->addWidget(widget);
    return widget;
  }
  void show() {
    window.show();
    window.activateWindow();
    if (!QTest::qWaitForWindowActive(&window)) qFatal("the window does not appear");
  }
  QWidget window;
};

}  // namespace

void AccessibilityTest::names() {
  Form form;
  form.add("titled", new QPushButton("Go"));
  form.add("pictured", new QPushButton(QIcon(), QString()));
  form.add("line", new QLineEdit);
  form.add("namedLine", new QLineEdit)->setAccessibleName("Name");
  auto* label = form.add("label", new QLabel("&Size"));
  label->setBuddy(form.add("buddied", new QLineEdit));
  form.add("spin", new QSpinBox)->setAccessibleName("Number");
  form.add("hidden", new QLineEdit)->hide();
  form.add("untouchable", new QLineEdit)->setFocusPolicy(Qt::NoFocus);
  form.show();
  QCOMPARE(withoutAccessibleName(form.window), QStringList({"pictured", "line"}));
}

void AccessibilityTest::tab() {
  Form form;
  form.add("one", new QPushButton("1"));
  form.add("two", new QPushButton("2"))->setFocusPolicy(Qt::NoFocus);
  form.add("three", new QSpinBox);
  form.add("four", new QPushButton("4"))->setEnabled(false);
  auto* host = form.add("host", new QWidget);
  auto* inner = new QLineEdit(host);
  inner->setObjectName("inner");
  host->setFocusProxy(inner);
  form.add("box", new QComboBox);
  form.show();
  QCOMPARE(notReachedByTab(form.window), QStringList({"two"}));
  QCOMPARE(notReachedByTab(form.window, [](const QWidget* w) { return w->objectName() == "two"; }), QStringList());
  // A widget that keeps Tab for itself cuts off those that follow.
  auto* trap = form.add("trap", new QTreeWidget);
  trap->setTabKeyNavigation(true);
  new QTreeWidgetItem(trap, {"row"});
  new QTreeWidgetItem(trap, {"row"});
  form.add("after", new QPushButton("5"));
  QTest::qWait(1);
  QVERIFY(notReachedByTab(form.window).contains("after"));
}

void AccessibilityTest::cut() {
  Form form(100);
  const QString text = "A text that needs more room than it has";
  form.add("fits", new QLabel("Short"));
  auto* wrapped = form.add("wraps", new QLabel(text));
  wrapped->setWordWrap(true);
  form.add("narrow", new QLabel(text))->setFixedWidth(50);
  auto* low = form.add("low", new QLabel(text));
  low->setWordWrap(true);
  low->setFixedHeight(10);
  form.add("button", new QPushButton(text))->setFixedWidth(60);
  form.add("empty", new QLabel)->setFixedWidth(5);
  form.show();
  QStringList names;
  for (const QString& line : cutTexts(form.window)) names << line.section(':', 0, 0);
  QCOMPARE(names, QStringList({"narrow", "low", "button"}));
}

HANDWHEEL_CONTROLS_TEST(AccessibilityTest)
#include "AccessibilityTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ControlScenes.h"
#include "ControlsTestMain.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QProgressBar>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

using namespace handwheel;
using namespace handwheel::test;

// Switching the theme leaves nothing of the theme before: existing widgets look like those created in the new theme.
class ThemeTest : public QObject {
  Q_OBJECT

 private:
  // Returns a widget with everything that the style sheet has a colour for.
  static std::unique_ptr<QWidget> scene() {
    auto all = std::make_unique<QWidget>();
    auto* column = new QVBoxLayout(all.get());
    for (const char* property : {"muted", "strong", "good", "bad", "wrong"}) {
      auto* label = new QLabel(QString::fromLatin1(property));
      label->setProperty(property, true);
      column->addWidget(label);
    }
    for (const char* property : {"primary", "flat", "none"}) {
      auto* button = new QPushButton(QString::fromLatin1(property));
      button->setProperty(property, true);
      column->addWidget(button);
    }
    auto* tool = new QToolButton;
    tool->setIcon(icon(QStringLiteral("fit")));
    tool->setCheckable(true);
    tool->setChecked(true);
    column->addWidget(tool);
    auto* check = new QCheckBox(QStringLiteral("check"));
    check->setChecked(true);
    column->addWidget(check);
    auto* combo = new QComboBox;
    combo->addItems({"one", "two"});
    column->addWidget(combo);
    auto* bar = new QProgressBar;
    bar->setValue(40);
    column->addWidget(bar);
    auto* line = new QLineEdit(QStringLiteral("line"));
    line->setProperty("wrong", true);
    column->addWidget(line);
    auto* tree = new QTreeWidget;
    tree->addTopLevelItem(new QTreeWidgetItem(QStringList{QStringLiteral("item")}));
    tree->topLevelItem(0)->addChild(new QTreeWidgetItem(QStringList{QStringLiteral("child")}));
    tree->topLevelItem(0)->setSelected(true);
    column->addWidget(tree);
    auto* list = new PropertyList;
    list->setProperties(sampleProperties());
    column->addWidget(list);
    all->resize(300, 900);
    return all;
  }

  static QImage picture(QWidget& widget) {
    widget.clearFocus();
    return widget.grab().toImage();
  }

  static QImage inTheme(ThemeKind kind) {
    applyTheme(*qApp, kind);
    const auto fresh = scene();
    fresh->setAttribute(Qt::WA_ShowWithoutActivating);
    fresh->show();
    if (!QTest::qWaitForWindowExposed(fresh.get())) qFatal("not shown");
    QTest::qWait(50);
    return picture(*fresh);
  }

  // Returns the open list of a combo box in a parent, as the screen would show it.
  static QImage listOfChoices(QWidget& parent) {
    auto* combo = new QComboBox(&parent);
    combo->addItems({"one", "two", "three"});
    combo->resize(120, 32);
    parent.resize(200, 100);
    parent.show();
    if (!QTest::qWaitForWindowExposed(&parent)) qFatal("not shown");
    combo->showPopup();
    QWidget* const list = combo->view()->window();
    if (!QTest::qWaitForWindowExposed(list)) qFatal("not shown");
    QImage picture(list->size(), QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::black);  // a window without anything in it
    list->render(&picture, {}, {}, QWidget::DrawWindowBackground | QWidget::DrawChildren);
    combo->hidePopup();
    return picture;
  }

 private slots:
  void cleanup() { applyTheme(*qApp, ThemeKind::Light); }

  void aVisibleWindowFollowsAtOnce() {
    const QImage light = inTheme(ThemeKind::Light), dark = inTheme(ThemeKind::Dark);
    QVERIFY(light != dark);
    applyTheme(*qApp, ThemeKind::Light);
    const auto window = scene();
    window->setAttribute(Qt::WA_ShowWithoutActivating);
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window.get()));
    QTest::qWait(50);
    QCOMPARE(picture(*window), light);
    applyTheme(*qApp, ThemeKind::Dark);
    QCOMPARE(picture(*window), dark);  // no event has been served in between
    applyTheme(*qApp, ThemeKind::Light);
    QCOMPARE(picture(*window), light);
    applyTheme(*qApp, ThemeKind::Dark);
    applyTheme(*qApp, ThemeKind::Light);  // the first of the two had not finished the hidden ones
    QTest::qWait(50);
    QCOMPARE(picture(*window), light);
  }

  void listsOfChoicesAreOpaqueAndAlike_data() {
    QTest::addColumn<bool>("isDark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
  }
  void listsOfChoicesAreOpaqueAndAlike() {
    QFETCH(bool, isDark);
    const ThemeKind kind = isDark ? ThemeKind::Dark : ThemeKind::Light;
    applyTheme(*qApp, kind);
    QWidget window;
    QDialog dialog;
    const ThemeColours& colours = themeColours(kind);
    for (const QImage& list : {listOfChoices(window), listOfChoices(dialog)}) {
      const int right = list.width() - 1, bottom = list.height() - 1;
      QCOMPARE(list.pixelColor(right - 3, bottom - 3), colours.raised);
      for (const QPoint corner : {QPoint(0, 0), QPoint(right, 0), QPoint(0, bottom), QPoint(right, bottom)})
        QCOMPARE(list.pixelColor(corner), colours.border);
    }
  }

  void whatIsHiddenFollows_data() {
    QTest::addColumn<int>("waitMs");
    QTest::newRow("when it is shown") << 0;
    QTest::newRow("in time") << 200;
  }
  void whatIsHiddenFollows() {
    QFETCH(int, waitMs);
    const QImage dark = inTheme(ThemeKind::Dark);
    applyTheme(*qApp, ThemeKind::Light);
    const auto window = scene();
    window->setAttribute(Qt::WA_ShowWithoutActivating);
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window.get()));
    window->hide();
    QTest::qWait(50);
    applyTheme(*qApp, ThemeKind::Dark);
    if (waitMs > 0) QTest::qWait(waitMs);
    window->show();
    QCOMPARE(picture(*window), dark);
  }

  // A widget is deleted while the hidden widgets wait for their turn.
  void aWidgetMayDie() {
    auto window = scene();
    window->show();
    window->hide();
    applyTheme(*qApp, ThemeKind::Dark);
    window.reset();
    QTest::qWait(50);
    QCOMPARE(currentTheme(), ThemeKind::Dark);
  }
};

HANDWHEEL_CONTROLS_TEST(ThemeTest)
#include "ThemeTest.moc"

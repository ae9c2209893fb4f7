// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ControlPictures.h"
#include "ControlScenes.h"
#include "ControlsTestMain.h"

#include <QDir>
#include <QTest>
#include <QTreeView>

using namespace handwheel;
using namespace handwheel::test;

// Every control in both themes, at the scale of the environment (QT_SCALE_FACTOR).
class ControlPicturesTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { applyTheme(*qApp, ThemeKind::Light); }
  void startPage_data();
  void startPage();
  void propertyList();
  void numberFields();
  void palette();
  void preferences();
  void statusPanel();
  void bars();
  void docks();
};

void ControlPicturesTest::startPage_data() {
  QTest::addColumn<QSize>("size");
  QTest::newRow("wide") << QSize(1280, 660);
  QTest::newRow("usual") << QSize(960, 620);
  QTest::newRow("narrow") << QSize(560, 300);  // the room left of 1280 x 800 at 200 %
}

void ControlPicturesTest::startPage() {
  QFETCH(QSize, size);
  const auto page = sampleStartPage();
  page->resize(size);
  lookAt(*page, QStringLiteral("start-") + QTest::currentDataTag());
  auto* scroll = page->findChild<QScrollArea*>("startScroll");
  QCOMPARE(scroll->widget()->width(), std::min(scroll->viewport()->width(), scroll->widget()->maximumWidth()));
  for (const QWidget* child : visibleWidgets(*scroll->widget())) {
    const QRect rectangle(child->mapTo(scroll->widget(), QPoint()), child->size());
    QVERIFY2(scroll->widget()->rect().contains(rectangle), qPrintable(pathOf(child, *page)));
  }
}

void ControlPicturesTest::propertyList() {
  PropertyList list;
  list.setProperties(sampleProperties());
  list.resize(264, 640);
  lookAt(list, "properties");
  PropertyList empty;
  empty.setEmptyText("The tool has no settings.");
  empty.setProperties({});
  empty.resize(264, 80);
  lookAt(empty, "properties-empty");
}

void ControlPicturesTest::numberFields() {
  QWidget form;
  auto* column = new QVBoxLayout(&form);
  for (int i = 0; i < 4; ++i) {
    auto* field = new NumberField(&form);
    field->setLabel(QString::number(i));
    field->setQuantity(i == 3 ? Quantity::Angle : Quantity::Length, LengthUnit::Millimetre);
    if (i == 1) field->setPrefix("⌀");
    field->setRange(0.0, i == 2 ? 10.0 : 1e9);
    field->setValue(i == 2 ? 25.0 : i == 3 ? std::numbers::pi : 12.7);
    column->addWidget(field);
  }
  form.resize(200, 200);
  lookAt(form, "numbers");
}

void ControlPicturesTest::palette() {
  const auto window = sampleWindow();
  CommandPalette palette(window.get());
  window->resize(640, 400);
  window->show();
  palette.popUp();
  lookAt(*window, "palette-all", {"commandList"});  // the keys of the line move in it
  palette.popUp();
  auto* query = palette.findChild<QLineEdit*>("commandQuery");
  QTest::keyClicks(query, "sa");
  lookAt(*window, "palette-sa", {"commandList"});
}

void ControlPicturesTest::preferences() {
  const auto window = sampleWindow();
  ShortcutModel keys;
  window->findChild<QAction*>("wireframe")->setShortcut(QKeySequence("Ctrl+S"));
  keys.setActions(window->findChildren<QAction*>(), window->menuBar());
  PreferencesDialog dialog(&keys, sampleNavigation());
  dialog.resize(640, 400);
  dialog.show();
  auto* list = dialog.findChild<QTreeView*>("shortcutList");
  list->setCurrentIndex(list->model()->index(1, 0));
  auto* pages = dialog.findChild<QListWidget*>("preferencePages");
  for (int page = 0; page < pages->count(); ++page) {
    pages->setCurrentRow(page);
    lookAt(dialog, QStringLiteral("preferences-%1").arg(page));
  }
}

void ControlPicturesTest::statusPanel() {
  StatusPanel panel;
  panel.setSource(sampleServices);
  panel.resize(480, 160);
  lookAt(panel, "status");
}

void ControlPicturesTest::bars() {
  QMainWindow window;
  auto* messages = new MessageBar(&window);
  messages->showMessage(
      {Message::Weight::Warning, "The scan has holes", "5 of them are open", "Fill them.", "Show", [] {}});
  window.setCentralWidget(messages);
  auto* jobs = new JobBar(&window);
  window.statusBar()->addWidget(new HintBar(&window), 1);
  window.findChild<HintBar*>()->setHints(sampleHints());
  window.statusBar()->addPermanentWidget(jobs);
  jobs->setJobs({{1, "Looking for self-intersections", 0.4}, {2, "Saving bunny.stl"}, {3, "Repairing bunny", 0.9}});
  window.resize(900, 140);
  lookAt(window, "bars");
  QTest::mouseClick(jobs->findChild<QAbstractButton*>("jobMore"), Qt::LeftButton);
  auto* list = jobs->findChild<QWidget*>("jobList");
  QVERIFY(list->isVisible());
  const QString folder = qEnvironmentVariable("HANDWHEEL_PICTURES");
  if (!folder.isEmpty()) QVERIFY(list->grab().save(QDir(folder).filePath("jobs.png")));
  QCOMPARE(cutTexts(*list), QStringList());
}

void ControlPicturesTest::docks() {
  QMainWindow window;
  window.setCentralWidget(new QWidget(&window));
  auto* dock = new QDockWidget("Properties", &window);
  dock->setObjectName("propertiesDock");
  auto* list = new PropertyList(dock);
  list->setProperties(sampleProperties());
  dock->setWidget(list);
  dock->setTitleBarWidget(new DockTitle(dock));
  window.addDockWidget(Qt::RightDockWidgetArea, dock);
  window.resize(640, 400);
  lookAt(window, "dock");
  dock->setFloating(true);
  lookAt(*dock, "dock-floating");
}

HANDWHEEL_CONTROLS_TEST(ControlPicturesTest)
#include "ControlPicturesTest.moc"

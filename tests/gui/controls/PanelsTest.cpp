// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Accessibility.h"
#include "ControlScenes.h"
#include "ControlsTestMain.h"
#include "panels/SuggestionCard.h"
#include "panels/Tile.h"

#include <QAbstractButton>
#include <QAbstractItemModelTester>
#include <QAction>
#include <QProgressBar>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

using namespace handwheel;
using namespace handwheel::test;

// Start page, docks, hints, jobs and services.
class PanelsTest : public QObject {
  Q_OBJECT

 private slots:
  void startPageByKeyboard();
  void startPageSamples();
  void recentFiles();
  void docksFloatAndReturn();
  void docksFollowTheirTitle();
  void hintsThatFit();
  void hintsThatAreLeftOut();
  void severalJobs();
  void jobsThatWaitAndGo();
  void servicesKeepTheirRows();
  void hiddenStatusAsksNobody();
  void cardIsLowAndFolds();
};

void PanelsTest::startPageByKeyboard() {
  const auto page = sampleStartPage();
  page->resize(560, 300);
  page->show();
  page->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(page.get()));
  page->findChild<Tile*>("sampleTile")->setFocus();
  QStringList said;
  connect(page.get(), &StartPage::tileChosen, this, [&](const QString& name) { said << name; });
  connect(page.get(), &StartPage::openRequested, this, [&] { said << "open"; });
  connect(page.get(), &StartPage::clearRecentRequested, this, [&] { said << "clear"; });
  connect(page.get(), &StartPage::recentRequested, this, [&](const QString& path) { said << path; });
  for (int i = 0; i < 5; ++i) {
    if (i > 0) QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QWidget* focused = QApplication::focusWidget();
    QVERIFY(focused);
    QVERIFY(!focused->visibleRegion().isEmpty());  // scrolled to
    QTest::keyClick(focused, i % 2 || !qobject_cast<Tile*>(focused) ? Qt::Key_Space : Qt::Key_Return);
  }
  QCOMPARE(said, QStringList({"sampleTile", "cellTile", "open", "clear", "/home/a/scans/bunny.stl"}));
}

void PanelsTest::startPageSamples() {
  StartPage page;
  const StartTile scan{"sampleTile", "repair", "Repair a sample scan", "Opens a sample scan", false};
  const StartTile lathe{"latheTile", "kind-workpiece", "Turn a sample bar", "A shaft", true};
  page.setTiles({scan, lathe});
  QSignalSpy chosen(&page, &StartPage::tileChosen);
  auto* tile = page.findChild<Tile*>("sampleTile");
  QVERIFY(!tile->isEnabled());
  QCOMPARE(tile->accessibleDescription(), QString("The sample is not installed."));
  tile->click();
  QCOMPARE(chosen.size(), 0);
  page.findChild<Tile*>("latheTile")->click();
  QCOMPARE(chosen, QList<QVariantList>({{"latheTile"}}));
  page.setTiles({lathe});  // others replace them
  QVERIFY(!page.findChild<Tile*>("sampleTile"));
  QCOMPARE(page.findChild<Tile*>("latheTile")->accessibleDescription(), QString("A shaft"));
}

void PanelsTest::recentFiles() {
  StartPage page;
  page.show();
  QStringList asked;
  page.setPictures(
      [&](const QString& path) {
        asked << path;
        return samplePicture(path);
      },
      {});
  QVERIFY(!page.findChild<QWidget*>("clearRecent")->isVisible());
  const QStringList paths = {"/a/one.stl", "/a/two.urdf"};
  page.setRecentFiles(paths);
  QCOMPARE(asked, paths);
  QVERIFY(page.findChild<QWidget*>("clearRecent")->isVisible());
  // A click may lead to another list at once.
  connect(&page, &StartPage::recentRequested, &page, [&](const QString&) { page.setRecentFiles({"/a/two.urdf"}); });
  QTest::mouseClick(page.findChild<Tile*>("recent/one.stl"), Qt::LeftButton);
  QTest::qWait(1);
  QVERIFY(!page.findChild<Tile*>("recent/one.stl"));
  QVERIFY(page.findChild<Tile*>("recent/two.urdf"));
}

namespace {

struct DockFixture {
  DockFixture() : dock("Properties", &window) {
    dock.setObjectName("propertiesDock");
    dock.setWidget(new QLineEdit(&dock));
    title = new DockTitle(&dock);
    dock.setTitleBarWidget(title);
    window.setCentralWidget(new QWidget(&window));
    window.addDockWidget(Qt::RightDockWidgetArea, &dock);
    window.resize(640, 400);
    window.show();
    if (!QTest::qWaitForWindowExposed(&window)) qFatal("the window does not appear");
  }
  QToolButton* button(const char* name) { return title->findChild<QToolButton*>(name); }

  QMainWindow window;
  QDockWidget dock;
  DockTitle* title;
};

}  // namespace

void PanelsTest::docksFloatAndReturn() {
  DockFixture fixture;
  QCOMPARE(notReachedByTab(fixture.window), QStringList());
  auto* button = fixture.button("propertiesDockFloatButton");
  button->setFocus();
  QTest::keyClick(button, Qt::Key_Space);
  QVERIFY(fixture.dock.isFloating());
  QVERIFY(fixture.title->isVisible());
  QVERIFY(fixture.title->height() > 0);
  QCOMPARE(fixture.dock.windowTitle(), QString("Properties"));
  QVERIFY(button->accessibleName().startsWith("Dock"));
  QTest::mouseDClick(fixture.title, Qt::LeftButton, {}, QPoint(20, 8));
  QVERIFY(!fixture.dock.isFloating());
  QVERIFY(button->accessibleName().startsWith("Undock"));
  QTest::mouseDClick(fixture.title, Qt::LeftButton, {}, QPoint(20, 8));
  QVERIFY(fixture.dock.isFloating());
  QTest::mouseClick(fixture.button("propertiesDockFoldButton"), Qt::LeftButton);
  QVERIFY(!fixture.dock.isVisible());
  fixture.dock.toggleViewAction()->trigger();
  QVERIFY(fixture.dock.isVisible());
}

void PanelsTest::docksFollowTheirTitle() {
  DockFixture fixture;
  fixture.dock.setWindowTitle("Tool settings");
  QCOMPARE(fixture.title->findChild<QLabel*>("dockTitleText")->text(), QString("Tool settings"));
  QVERIFY(fixture.button("propertiesDockFoldButton")->accessibleName().contains("Tool settings"));
  fixture.dock.setFeatures(QDockWidget::DockWidgetClosable);
  QVERIFY(!fixture.button("propertiesDockFloatButton")->isVisible());
  QVERIFY(fixture.button("propertiesDockFoldButton")->isVisible());
}

void PanelsTest::hintsThatFit() {
  HintBar bar;
  bar.setHints(sampleHints());
  QVERIFY(bar.accessibleName().contains("Wheel: zoom"));
  QVERIFY(!bar.accessibleName().contains("Enter"));  // cannot be used now
  QVERIFY(bar.toolTip().contains("Esc: leave"));
  bar.resize(60, bar.sizeHint().height());
  const QImage narrow = bar.grab().toImage();
  bar.setHints({});
  QVERIFY(bar.grab().toImage() != narrow);  // at least that there is more
  QCOMPARE(bar.accessibleName(), QString());
}

// When it becomes narrower the hints that are not available go first, then the others from the end.
void PanelsTest::hintsThatAreLeftOut() {
  const Hint drag{"Drag", "move"}, enter{"Enter", "apply the tool", false}, escape{"Esc", "leave"};
  HintBar bar;
  bar.setHints({drag, enter, escape});
  const std::vector<std::vector<Hint>> expected{{drag, enter, escape}, {drag, escape}, {drag}, {}};
  std::vector<std::vector<Hint>> seen;
  for (int width = 1000; width > 0; --width) {
    bar.resize(width, bar.sizeHint().height());
    if (seen.empty() || seen.back() != bar.shownHints()) seen.push_back(bar.shownHints());
  }
  QVERIFY(seen == expected);
}

void PanelsTest::severalJobs() {
  JobBar bar;
  QList<quint64> cancelled;
  connect(&bar, &JobBar::cancelJobRequested, this, [&](quint64 id) { cancelled << id; });
  bar.setJobs({{7, "Repairing", 0.5}, {8, "Saving"}, {9, "Loading", 0.25}});
  QVERIFY(bar.isVisible());
  auto* more = bar.findChild<QToolButton*>("jobMore");
  QVERIFY(more->isVisible());
  QCOMPARE(more->accessibleName(), QString("2 more jobs"));
  QTest::mouseClick(bar.findChild<QToolButton*>("jobCancel"), Qt::LeftButton);
  QTest::mouseClick(more, Qt::LeftButton);
  auto* list = bar.findChild<QWidget*>("jobList");
  QVERIFY(list->isVisible());
  QTest::mouseClick(list->findChild<QToolButton*>("jobCancel/2"), Qt::LeftButton);
  QCOMPARE(cancelled, QList<quint64>({7, 9}));
  auto* progress = list->findChild<QProgressBar*>("jobProgress/2");
  QCOMPARE(double(progress->value()) / progress->maximum(), 0.25);
  QCOMPARE(list->findChild<QProgressBar*>("jobProgress/1")->maximum(), 0);  // not known: it moves to and fro
  QCOMPARE(bar.findChild<QLabel*>("jobTime")->text(), QString());
  bar.setJobs({{9, "Loading", 0.75, false, 65}});
  QCOMPARE(bar.findChild<QLabel*>("jobTime")->text(), QString("for 1:05"));
  QVERIFY(!list->isVisible());
  QVERIFY(!more->isVisible());
  QTest::mouseClick(bar.findChild<QToolButton*>("jobCancel"), Qt::LeftButton);
  QCOMPARE(cancelled.last(), quint64(9));
  bar.setJobs({});
  QVERIFY(!bar.isVisible());
}

// A waiting job moves no bar. A press on a job whose line goes over to the next one is not meant for that.
void PanelsTest::jobsThatWaitAndGo() {
  JobBar bar;
  QList<quint64> cancelled;
  connect(&bar, &JobBar::cancelJobRequested, this, [&](quint64 id) { cancelled << id; });
  bar.setJobs({{1, "Repairing", 0.5}, {2, "Saving", -1.0, true}});
  QTest::mouseClick(bar.findChild<QToolButton*>("jobMore"), Qt::LeftButton);
  auto* list = bar.findChild<QWidget*>("jobList");
  QVERIFY(list->findChild<QLabel*>("jobName/1")->text().contains("waiting"));
  QVERIFY(!list->findChild<QProgressBar*>("jobProgress/1")->isVisible());
  QVERIFY(list->findChild<QProgressBar*>("jobProgress/0")->isVisible());
  list->close();
  auto* cancel = bar.findChild<QToolButton*>("jobCancel");
  QTest::mousePress(cancel, Qt::LeftButton);
  bar.setJobs({{2, "Saving", 0.0}});
  QTest::mouseRelease(cancel, Qt::LeftButton);
  QCOMPARE(cancelled, QList<quint64>({1}));
}

void PanelsTest::servicesKeepTheirRows() {
  ServiceModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
  model.setServices(sampleServices());
  const auto text = [&](int row, int column) { return model.index(row, column).data().toString(); };
  QCOMPARE(text(0, ServiceModel::Ticks), QString("1000"));
  QCOMPARE(text(0, ServiceModel::Cost), QString("42"));
  QCOMPARE(text(0, ServiceModel::Share), QString("4.2 % of the servo tick"));
  QCOMPARE(text(1, ServiceModel::Share), QString("82 % of the frame"));
  QCOMPARE(text(2, ServiceModel::Ticks), QString());  // asleep
  QCOMPARE(text(3, ServiceModel::Share), QString());
  QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
  QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
  auto services = sampleServices();
  services[0].ticksPerSecond = 998.0;
  model.setServices(services);
  QCOMPARE(reset.size(), 0);
  QCOMPARE(changed.size(), 1);
  QCOMPARE(text(0, ServiceModel::Ticks), QString("998"));
  QCOMPARE(text(0, ServiceModel::State), QString("running"));
  services[0].behind = 0.256;
  services[0].dropped = services[2].dropped = 3;
  model.setServices(services);
  QCOMPARE(text(0, ServiceModel::State), QString("too slow by 26 %, 3 inputs dropped"));
  QCOMPARE(text(2, ServiceModel::State), QString("idle"));
  services.pop_back();
  model.setServices(services);
  QCOMPARE(reset.size(), 1);
  QCOMPARE(model.rowCount(), 3);
}

void PanelsTest::hiddenStatusAsksNobody() {
  StatusPanel panel;
  int asked = 0;
  panel.setSource([&] {
    ++asked;
    return sampleServices();
  });
  QTest::qWait(700);
  QCOMPARE(asked, 0);
  panel.show();
  QTRY_VERIFY(asked >= 3);
  panel.hide();
  asked = 0;
  QTest::qWait(700);
  QCOMPARE(asked, 0);
}

// A long text makes it wider before it makes it higher. Folded, one line is left, with the first action; it stays
// folded for the next steps, and nothing of it is lost when it is unfolded.
void PanelsTest::cardIsLowAndFolds() {
  QWidget view;
  view.resize(800, 500);
  QAction first("Repair all"), second("Go one by one");
  first.setObjectName("first");
  second.setObjectName("second");
  SuggestionCard card(&view);
  view.show();
  const auto isShown = [&](const char* name) {
    const auto* widget = card.findChild<QWidget*>(name);
    return widget && widget->isVisible();
  };
  Suggestion step{"warning", Qt::red, "3 holes found.", "A word.", {&first, &second}};
  card.showStep(step);
  const int usual = card.width();
  step.detail = QString("A sentence about what was found and about what is to be done. ").repeated(10);
  card.showStep(step);
  QVERIFY(card.width() > usual);
  QVERIFY(view.rect().contains(card.geometry()));
  QTRY_VERIFY(isShown("nextStep/first") && isShown("nextStep/second") && isShown("nextStepDetail"));

  const int unfolded = card.height();
  auto* const fold = card.findChild<QToolButton*>("nextStepFold");
  QSignalSpy covers(&card, &SuggestionCard::covers);
  fold->click();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  QVERIFY(card.height() < unfolded / 2);
  QVERIFY(!covers.isEmpty() && covers.last()[0].toInt() < unfolded);
  QTRY_VERIFY(isShown("nextStepTitle") && isShown("nextStep/first"));  // a layout shows its widgets later
  QVERIFY(!isShown("nextStep/second") && !isShown("nextStepDetail"));
  QSignalSpy triggered(&first, &QAction::triggered);
  card.findChild<QAbstractButton*>("nextStep/first")->click();
  QCOMPARE(triggered.size(), 1);

  step.title = "1 hole left.";
  step.actions = {&second, &first};
  card.showStep(step);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  QTRY_VERIFY(isShown("nextStep/second") && !isShown("nextStep/first") && !isShown("nextStepDetail"));
  fold->click();
  QTRY_VERIFY(isShown("nextStep/second") && isShown("nextStep/first") && isShown("nextStepDetail"));
  card.showStep({});
  QVERIFY(!card.isVisible());
}

HANDWHEEL_CONTROLS_TEST(PanelsTest)
#include "PanelsTest.moc"

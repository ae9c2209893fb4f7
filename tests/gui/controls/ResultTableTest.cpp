// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ResultTable.h"

#include "ControlPictures.h"
#include "ControlsTestMain.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMenu>
#include <QScrollBar>
#include <QSignalSpy>
#include <QVBoxLayout>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using CellState = ResultCell::State;

ResultModel::Row student(const QString& name, double points, const QString& file) {
  return {{name}, {QString::number(points), points, points < 50 ? CellState::Bad : CellState::Good, "of 100"}, {file}};
}

std::vector<ResultModel::Row> someClass() {
  return {student("Cem", 9, "shaft10.handwheel"),
          student("Anna", 100, "shaft2.handwheel"),
          {{"Zoë"}, {QString(), std::numeric_limits<double>::quiet_NaN()}, {"shaft1.handwheel"}},
          student("Ben", 71.5, "=cmd|' /C calc'!A1"),
          {{"Dora"}}};
}

struct ResultFixture {
  ResultFixture() {
    table.setTable({"Student", "Points", "File"}, someClass());
    window.resize(420, 240);
    (new QVBoxLayout(&window))->addWidget(&table);
    window.show();
    window.activateWindow();
    if (!QTest::qWaitForWindowActive(&window)) qFatal("the table does not appear");
    table.setFocus();
  }
  QString column(int column) {
    QStringList texts;
    for (int row = 0; row < table.model()->rowCount(); ++row)
      texts << table.model()->index(row, column).data().toString();
    return texts.join(' ');
  }
  QWidget window;
  ResultTable table{&window};
};

}  // namespace

class ResultTableTest : public QObject {
  Q_OBJECT

 private slots:
  // the C locale does not know numbers in texts
  void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }
  void cleanup() { applyTheme(*qApp, ThemeKind::Light); }
  void sorts();
  void equalRowsStay();
  void selectionFollowsItsRow();
  void menuSorts();
  void copies();
  void activates();
  void firstColumnStays();
  void empty();
  void pictures();
};

// The names stay visible beside the marks at any scroll position, in the same rows, and can be chosen there.
void ResultTableTest::firstColumnStays() {
  ResultFixture fixture;
  QStringList headings{"Student"};
  std::vector<ResultModel::Row> rows;
  for (int i = 0; i < 30; ++i) headings << QString("Criterion %1").arg(i);
  for (int row = 0; row < 60; ++row) {
    rows.push_back({{QString("Student %1").arg(row)}});
    for (int i = 0; i < 30; ++i) rows.back().push_back({QString::number(i), double(i)});
  }
  fixture.table.setTable(headings, rows);
  auto* first = fixture.table.findChild<QTreeView*>("firstColumn");
  QVERIFY(first);
  fixture.table.horizontalScrollBar()->setValue(fixture.table.horizontalScrollBar()->maximum());
  fixture.table.verticalScrollBar()->setValue(fixture.table.verticalScrollBar()->maximum() / 2);
  QVERIFY(fixture.table.horizontalScrollBar()->value() > 0 && fixture.table.verticalScrollBar()->value() > 0);
  const QPoint point(5, fixture.table.viewport()->height() / 2);
  const QPoint within =
      first->viewport()->mapFrom(&fixture.table, fixture.table.viewport()->mapTo(&fixture.table, point));
  const QModelIndex name = first->indexAt(within), beside = fixture.table.indexAt(point);
  QCOMPARE(name.column(), 0);
  QVERIFY(name.row() > 0);
  QCOMPARE(name.row(), beside.row());
  QVERIFY(fixture.table.childAt(fixture.table.viewport()->mapTo(&fixture.table, point)) == first->viewport());
  QTest::mouseClick(first->viewport(), Qt::LeftButton, {}, within);
  QVERIFY(fixture.table.selectionModel()->isRowSelected(name.row(), {}));
  // A click on its heading sorts the rows of both.
  QTest::mouseClick(first->header()->viewport(), Qt::LeftButton, {}, QPoint(10, 5));
  QCOMPARE(fixture.table.header()->sortIndicatorSection(), 0);
  QCOMPARE(fixture.table.model()->index(1, 0).data().toString(), QString("Student 1"));
  QTest::mouseClick(first->header()->viewport(), Qt::LeftButton, {}, QPoint(10, 5));
  QCOMPARE(fixture.table.model()->index(0, 0).data().toString(), QString("Student 59"));
}

// Numbers are sorted by value, "2" before "10" in texts, empty cells last.
void ResultTableTest::sorts() {
  ResultFixture fixture;
  QCOMPARE(fixture.column(0), QString("Cem Anna Zoë Ben Dora"));
  fixture.table.sortByColumn(1, Qt::AscendingOrder);
  QCOMPARE(fixture.column(0), QString("Cem Ben Anna Zoë Dora"));
  fixture.table.sortByColumn(1, Qt::DescendingOrder);
  QCOMPARE(fixture.column(0), QString("Anna Ben Cem Zoë Dora"));
  fixture.table.sortByColumn(2, Qt::AscendingOrder);
  QVERIFY(fixture.column(0).indexOf("Zoë") < fixture.column(0).indexOf("Anna"));
  QVERIFY(fixture.column(0).indexOf("Anna") < fixture.column(0).indexOf("Cem"));
  QVERIFY(fixture.column(0).endsWith("Dora"));
  const QHeaderView* header = fixture.table.header();
  QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, {header->sectionViewportPosition(0) + 10, 8});
  QCOMPARE(fixture.column(0), QString("Anna Ben Cem Dora Zoë"));
  fixture.table.setTable({"Student", "Points", "File"}, {{{"b"}}, {{"a"}}});
  QCOMPARE(fixture.column(0), QString("a b"));  // the order stays
}

void ResultTableTest::equalRowsStay() {
  ResultModel model;
  std::vector<ResultModel::Row> rows;
  for (int i = 0; i < 100; ++i) rows.push_back({{QString::number(i % 3), i % 3}, {QString::number(i)}});
  model.setTable({"a", "b"}, rows);
  for (auto direction : {Qt::DescendingOrder, Qt::AscendingOrder}) {
    model.sort(0, direction);
    for (int row = 1; row < 100; ++row) {
      const bool isSame = rows[model.source(row)][0].number == rows[model.source(row - 1)][0].number;
      QVERIFY(!isSame || model.source(row) > model.source(row - 1));
    }
  }
}

void ResultTableTest::selectionFollowsItsRow() {
  ResultFixture fixture;
  fixture.table.setCurrentIndex(fixture.table.model()->index(1, 0));
  fixture.table.sortByColumn(0, Qt::DescendingOrder);
  QCOMPARE(fixture.table.currentIndex().data().toString(), QString("Anna"));
}

void ResultTableTest::menuSorts() {
  ResultFixture fixture;
  for (const char* wanted : {"Cem Ben Anna Zoë Dora", "Anna Ben Cem Zoë Dora"}) {
    QContextMenuEvent event(QContextMenuEvent::Keyboard, {10, 10}, fixture.table.mapToGlobal(QPoint(10, 10)));
    QApplication::sendEvent(fixture.table.viewport(), &event);
    auto* menu = fixture.table.findChild<QMenu*>("resultMenu");
    QVERIFY(menu);
    QCOMPARE(menu->actions().size(), 5);  // copy, a line, three columns
    menu->actions().at(3)->trigger();
    menu->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QCOMPARE(fixture.column(0), QString::fromUtf8(wanted));
  }
}

void ResultTableTest::copies() {
  ResultFixture fixture;
  fixture.table.sortByColumn(0, Qt::AscendingOrder);
  fixture.table.selectionModel()->select(fixture.table.model()->index(1, 0),
                                         QItemSelectionModel::Select | QItemSelectionModel::Rows);
  QTest::keyClick(&fixture.table, Qt::Key_C, Qt::ControlModifier);
  QCOMPARE(QGuiApplication::clipboard()->text(), QString("Student\tPoints\tFile\nBen\t71.5\t'=cmd|' /C calc'!A1"));
  fixture.table.clearSelection();
  QCOMPARE(fixture.table.copyText().count('\n'), 5);
  fixture.table.setTable({"a\tb"}, {{{"one\ttwo\nthree"}}, {{"-5", -5.0}}});
  QCOMPARE(fixture.table.copyText(), QString("a b\n-5\none two three"));
}

void ResultTableTest::activates() {
  ResultFixture fixture;
  QSignalSpy rows(&fixture.table, &ResultTable::rowActivated);
  fixture.table.sortByColumn(0, Qt::AscendingOrder);
  fixture.table.setCurrentIndex(fixture.table.model()->index(0, 0));
  QTest::keyClick(&fixture.table, Qt::Key_Return);
  QCOMPARE(rows.size(), 1);
  QCOMPARE(rows[0][0].value<std::size_t>(), std::size_t(1));  // Anna
}

void ResultTableTest::empty() {
  ResultTable table;
  QCOMPARE(table.copyText(), QString());
  table.setTable({}, {{{"of no column"}}, {}});
  table.sortByColumn(3, Qt::AscendingOrder);
  table.setTable({"a", "b"}, {});
  QCOMPARE(table.copyText(), QString("a\tb"));
  table.grab();
}

void ResultTableTest::pictures() {
  ResultFixture fixture;
  lookAt(fixture.window, "results");
}

HANDWHEEL_CONTROLS_TEST(ResultTableTest)
#include "ResultTableTest.moc"

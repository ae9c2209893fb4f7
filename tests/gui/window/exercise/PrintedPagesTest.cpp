// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/exercise/PrintedPages.h"

#include "../WindowTestMain.h"

#include <QBuffer>
#include <QPdfWriter>
#include <QTextDocument>

using namespace handwheel;

// Where the pages of a printed report begin and end.
class PrintedPagesTest : public QObject {
  Q_OBJECT

 private slots:
  // Rows 0…9, 12…21 and so on, on pages of 30: two rows and what is between them end at 22, three at 34.
  void rowsStayWhole() {
    std::vector<PrintedBlock> rows;
    for (int i = 0; i < 5; ++i) rows.push_back({12.0 * i, 12.0 * i + 10.0});
    const std::vector<PrintedPage> pages = pagesOf(rows, 30.0);
    QCOMPARE(pages.size(), std::size_t{3});
    const double ends[] = {0.0, 23.0, 47.0, 58.0};  // in the middle between two rows
    for (std::size_t i = 0; i < pages.size(); ++i) {
      QCOMPARE(pages[i].from, ends[i]);
      QCOMPARE(pages[i].to, ends[i + 1]);
    }
  }

  void aHeadingIsNotLeftBehind() {
    const std::vector<PrintedBlock> blocks{{0, 10}, {10, 20, false, true}, {20, 40}};
    const std::vector<PrintedPage> pages = pagesOf(blocks, 30.0);
    QCOMPARE(pages.size(), std::size_t{2});
    QCOMPARE(pages[0].to, 10.0);
    QCOMPARE(pages[1].from, 10.0);
    // Alone on its page it can only stay.
    QCOMPARE(pagesOf({{0, 10, false, true}, {10, 40}}, 30.0).size(), std::size_t{2});
  }

  void aStudentBeginsAPage() {
    const std::vector<PrintedPage> pages = pagesOf({{0, 10}, {10, 12, true}, {12, 14}}, 100.0);
    QCOMPARE(pages.size(), std::size_t{2});
    QCOMPARE(pages[1].from, 10.0);
    QCOMPARE(pages[1].to, 14.0);
  }

  // What is higher than a page fills as many as it needs.
  void whatIsTooHighIsCut() {
    const std::vector<PrintedPage> pages = pagesOf({{0, 25}, {25, 30}}, 10.0);
    QCOMPARE(pages.size(), std::size_t{4});
    QCOMPARE(pages[2].to, 25.0);
    QCOMPARE(pages[3].to, 30.0);
    QVERIFY(pagesOf({}, 10.0).empty());
  }

  void aPageForEachStudentInThePdf() {
    QTextDocument document;
    const QString student =
        QStringLiteral("<h2 style=\"page-break-before: always\">Ada</h2><table><tr><td>1</td></tr></table>");
    document.setHtml("<h1>Class</h1>" + student + student);
    QBuffer buffer;
    QVERIFY(buffer.open(QIODevice::WriteOnly));
    {
      QPdfWriter writer(&buffer);
      writer.setPageSize(QPageSize(QPageSize::A4));
      printWholeRows(document, writer);
    }
    QCOMPARE(buffer.data().count("/Type /Page\n"), 3);
  }
};

HANDWHEEL_WINDOW_TEST(PrintedPagesTest)
#include "PrintedPagesTest.moc"

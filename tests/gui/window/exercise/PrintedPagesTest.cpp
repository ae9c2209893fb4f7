// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/exercise/PrintedPages.h"

#include "../WindowTestMain.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>
#include <cmath>

using namespace handwheel;

// The page breaks of a printed report.
class PrintedPagesTest : public QObject {
  Q_OBJECT

 private slots:
  // Rows 0…9, 12…21 and so on, on pages of 30: two rows and the gap between them end at 22, three at 34.
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

  // A row that is higher than a page fills as many pages as it needs.
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

  // Blue, and red in the last tenth at the right: on the page it is as wide as the text, with a tenth that is red.
  void aWidePictureIsWhole_data() {
    QTest::addColumn<QString>("size");
    QTest::newRow("as it is") << QString();
    QTest::newRow("of a width") << QStringLiteral("width=\"1500\"");
    QTest::newRow("of both") << QStringLiteral("width=\"1500\" height=\"300\"");
  }
  void aWidePictureIsWhole() {
    QFETCH(QString, size);
    QImage picture(2000, 400, QImage::Format_RGB32);
    picture.fill(Qt::blue);
    QPainter(&picture).fillRect(1800, 0, 200, 400, Qt::red);
    QTextDocument document;
    document.addResource(QTextDocument::ImageResource, QUrl("wide"), picture);
    document.setHtml("<p><img src=\"wide\" " + size + "/></p>");
    QImage page(827, 1169, QImage::Format_RGB32);  // A4, 100 in an inch
    page.setDotsPerMeterX(3937);
    page.setDotsPerMeterY(3937);
    page.fill(Qt::white);
    int more = 0;
    printWholeRows(document, page, [&more] { ++more; });
    QCOMPARE(more, 0);
    const double margin = 100.0 * 2.0 / 2.54, width = 827.0 - 2.0 * margin;
    int coloured = 0, red = 0, last = 0;
    for (int x = 0; x < page.width(); ++x) {
      const QColor colour = page.pixelColor(x, 130);  // below the margin, above the lower edge of the picture
      if (colour == QColor(Qt::white)) continue;
      ++coloured;
      if (colour.red() > colour.blue()) ++red;
      last = x;
    }
    QVERIFY2(std::abs(coloured - width) <= 4.0, qPrintable(QString::number(coloured)));
    QVERIFY2(std::abs(red - 0.1 * width) <= 3.0, qPrintable(QString::number(red)));
    QVERIFY2(last <= 827.0 - margin + 1.0, qPrintable(QString::number(last)));
    QVERIFY(page.pixelColor(last, 130).red() > 200);
  }

  // Pictures of 100 by 50, and of 10 by 5000: the first is unchanged, the second is as high as a page.
  void onlyWhatIsTooLargeIsMadeSmaller() {
    QImage picture(100, 50, QImage::Format_RGB32), high(10, 5000, QImage::Format_RGB32);
    picture.fill(Qt::red);
    high.fill(Qt::red);
    QTextDocument document;
    document.addResource(QTextDocument::ImageResource, QUrl("small"), picture);
    document.addResource(QTextDocument::ImageResource, QUrl("high"), high);
    document.setHtml("<p><img src=\"small\"/></p><p><img src=\"high\"/></p>");
    QImage page(827, 1169, QImage::Format_RGB32);
    page.fill(Qt::white);
    printWholeRows(document, page, [&page] { page.fill(Qt::white); });  // the last page stays
    const QString html = document.toHtml();
    QVERIFY(!html.contains("src=\"small\" width"));
    QVERIFY(html.contains("src=\"high\" width"));
  }
};

HANDWHEEL_WINDOW_TEST(PrintedPagesTest)
#include "PrintedPagesTest.moc"

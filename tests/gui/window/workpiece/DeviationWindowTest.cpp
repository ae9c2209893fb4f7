// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../StlFiles.h"
#include "../WindowDriver.h"
#include "../WindowTestMain.h"
#include "plot/PlotWidget.h"
#include "window/mesh/deviation/MeshDeviation.h"

#include <QDockWidget>
#include <QPushButton>
#include <QRegularExpression>

using namespace handwheel;
using namespace handwheel::test;

// The deviation map in the window: a torus whose hole was filled, against what it was, and against others.
class DeviationWindowTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  QString fileWithHole() {
    const QString path = m_folder.filePath(QStringLiteral("hole.stl"));
    writeStl(path, torusWithHole());
    return path;
  }

  static bool isShown(WindowDriver& driver) { return driver.find<QWidget>("deviationPanel")->isVisible(); }

  static double millimetres(const QString& text) {
    const auto found = QRegularExpression(QStringLiteral("^([+−]?)([0-9.]+)\\D*mm$")).match(text);
    if (!found.hasMatch()) qFatal("no length: %s", qPrintable(text));
    return (found.captured(1) == QStringLiteral("−") ? -1.0 : 1.0) * found.captured(2).toDouble();
  }

  // Pixels of the surface that are clearly red or blue; the legend is left out.
  static int coloured(WindowDriver& driver) {
    auto* view = driver.find<Viewport>("viewport");
    const QImage image = view->grabImage();
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width() * 3 / 4; ++x) {
        const QColor c = image.pixelColor(x, y);
        count += std::abs(c.red() - c.blue()) > 70;
      }
    }
    return count;
  }

  // Blue at its lower end.
  static bool hasLegend(WindowDriver& driver) {
    const QImage image = driver.find<Viewport>("viewport")->grabImage();
    const QColor low = image.pixelColor(image.width() - 23, image.height() / 2 + 105);
    return low.blue() > low.red() + 100;
  }

 private slots:
  void mapOfARepair() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHole()));
    auto* view = driver.find<Viewport>("viewport");
    view->setStandardView(StandardView::Top);
    const int before = coloured(driver);  // marks and axes
    driver.choose("repairAll");
    QVERIFY(driver.settle());
    driver.choose("deviation");
    QVERIFY(isShown(driver));
    QVERIFY(driver.settle());
    QCOMPARE(driver.find<QDockWidget>("kindDock")->windowTitle(), QStringLiteral("Deviation"));
    QVERIFY(driver.find<QPushButton>("deviationHighest")->isVisible());
    // The patch lies within the hole, which is as wide as six of 48 parts of a circle of 40 mm.
    const double highest = millimetres(driver.find<QPushButton>("deviationHighest")->text());
    const double lowest = millimetres(driver.find<QPushButton>("deviationLowest")->text());
    QVERIFY2(std::max(highest, -lowest) > 1.0 && std::max(highest, -lowest) < 15.0,
             qPrintable(QString::number(highest)));
    QVERIFY(coloured(driver) > before + 500);
    QVERIFY(hasLegend(driver));
    const auto& bars = driver.find<PlotWidget>("deviationHistogram")->plot().series.at(0);
    double sum = 0.0;
    for (const QPointF& bar : bars.points) sum += bar.y();
    QVERIFY(std::abs(sum - 100.0) < 1e-6);
    // An edit takes it away.
    driver.find<QAction>("undo")->trigger();
    QVERIFY(!isShown(driver));
    QVERIFY(driver.settle());
    QVERIFY(!hasLegend(driver));
  }

  void figuresLeadToTheirPlaces() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHole()));
    driver.choose("repairAll");
    QVERIFY(driver.settle());
    driver.choose("deviation");
    QVERIFY(driver.settle());
    auto* view = driver.find<Viewport>("viewport");
    const double height = view->camera().height;
    driver.click("deviationHighest");
    QVERIFY(view->camera().height < 0.5 * height);
    const Vec3 centre = view->camera().centre;
    const double around = std::hypot(centre.x(), centre.y()), tube = std::hypot(around - 30.0, centre.z());
    QVERIFY2(tube < 11.0, qPrintable(QString::number(tube)));
  }

  // Back to the list; and the range, which moves the colours.
  void rangeAndClosing() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHole()));
    driver.choose("repairAll");
    QVERIFY(driver.settle());
    driver.find<Viewport>("viewport")->setStandardView(StandardView::Top);
    const int plain = coloured(driver);  // marks and axes
    driver.choose("deviation");
    QVERIFY(driver.settle());
    QVERIFY(coloured(driver) > plain + 500);
    auto* line = driver.find<QWidget>("deviationRange")->findChild<QLineEdit*>();
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, "1000");
    QTest::keyClick(line, Qt::Key_Return);
    QVERIFY(coloured(driver) < plain + 100);
    driver.click("deviationClose");
    QVERIFY(!isShown(driver));
    QCOMPARE(driver.find<QDockWidget>("kindDock")->windowTitle(), QStringLiteral("Defects"));
  }

  // Another file: the same torus without a hole, so that nothing is far from it. And one that is no mesh.
  void againstAFile() {
    WindowDriver driver;
    const QString whole = m_folder.filePath(QStringLiteral("whole.stl"));
    writeStl(whole, quadTorus(48, 24, {}));
    QVERIFY(driver.open(fileWithHole()));
    driver.choose("deviation");
    QVERIFY(driver.settle());
    driver.click("deviationOther");
    QVERIFY(driver.enterFileName("compareDialog", whole));
    QVERIFY(driver.settle());
    QVERIFY2(driver.text("deviationTitle").contains("whole.stl"), qPrintable(driver.text("deviationTitle")));
    QCOMPARE(millimetres(driver.find<QPushButton>("deviationHighest")->text()), 0.0);
    QFile text(m_folder.filePath(QStringLiteral("text.stl")));
    QVERIFY(text.open(QIODevice::WriteOnly) && text.write("solid nothing\nendsolid\n") > 0);
    text.close();
    driver.click("deviationOther");
    QVERIFY(driver.enterFileName("compareDialog", text.fileName()));
    QVERIFY(driver.settle());
    QVERIFY(driver.text("deviationTitle").contains("whole.stl"));  // the previous result stays
  }

  // A range that was being typed is dropped when the mesh changes.
  void theMeshChangesWhileARangeIsTyped() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHole()));
    driver.choose("repairAll");
    QVERIFY(driver.settle());
    driver.choose("deviation");
    QVERIFY(driver.settle());
    driver.window().activateWindow();
    auto* line = driver.find<QWidget>("deviationRange")->findChild<QLineEdit*>();
    line->setFocus();
    QTRY_VERIFY(line->hasFocus());
    line->selectAll();
    QTest::keyClicks(line, "7");
    driver.choose("undo");
    QVERIFY(!isShown(driver));
    QVERIFY(driver.settle());
  }

  // The file that was chosen last counts, though the comparison before it still runs.
  void anotherFileDuringAComparison() {
    WindowDriver driver;
    const QString whole = m_folder.filePath(QStringLiteral("chosen.stl"));
    writeStl(whole, quadTorus(48, 24, {}));
    QVERIFY(driver.open(fileWithHole()));
    driver.hold();
    driver.choose("deviation");
    driver.click("deviationOther");
    QVERIFY(driver.enterFileName("compareDialog", whole));
    driver.release();
    QVERIFY(driver.settle());
    QVERIFY2(driver.text("deviationTitle").contains("chosen.stl"), qPrintable(driver.text("deviationTitle")));
    QVERIFY(driver.find<QWidget>("deviationHistogram")->isVisible());
  }

  // The document in view and its map go together.
  void eachDocumentHasItsOwn() {
    WindowDriver driver;
    const QString whole = m_folder.filePath(QStringLiteral("other.stl"));
    writeStl(whole, quadTorus(40, 20, {}));
    QVERIFY(driver.open(fileWithHole()));
    driver.choose("deviation");
    QVERIFY(driver.settle());
    QVERIFY(isShown(driver));
    QVERIFY(driver.open(whole));
    QVERIFY(!isShown(driver));
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QVERIFY(isShown(driver));
    QVERIFY(driver.settle());
  }

  void report() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHole()));
    driver.choose("repairAll");
    QVERIFY(driver.settle());
    driver.choose("deviation");
    QVERIFY(driver.settle());
    const QString page = m_folder.filePath(QStringLiteral("r.html")),
                  paper = m_folder.filePath(QStringLiteral("r.pdf"));
    for (const QString& path : {page, paper}) {
      driver.click("deviationReport");
      QVERIFY(driver.enterFileName("reportDialog", path));
      QVERIFY(driver.settle());
    }
    QFile html(page), pdf(paper);
    QVERIFY(html.open(QIODevice::ReadOnly) && pdf.open(QIODevice::ReadOnly));
    QVERIFY(html.readAll().contains("src=\"data:image/png;base64,"));
    QCOMPARE(pdf.readAll().count("/Subtype /Image"), 3);
  }

  void sharesAreKept() {
    SurfaceDeviation d;
    d.lowest.distance = -3.0;
    d.highest.distance = 1.0;
    d.histogram = {0.1, 0.2, 0.3, 0.4};  // about -2.5, -1.5, -0.5, 0.5
    const std::vector<double> shares = sharesWithin(d, 1.0, 2);
    QCOMPARE(shares.size(), std::size_t{2});
    QVERIFY(std::abs(shares[0] - 0.6) < 1e-12 && std::abs(shares[1] - 0.4) < 1e-12);
    d.lowest.distance = d.highest.distance = 0.0;  // all the same
    const std::vector<double> same = sharesWithin(d, 1.0, 3);
    QVERIFY(std::abs(same[1] - 1.0) < 1e-12);
  }
};

HANDWHEEL_WINDOW_TEST(DeviationWindowTest)
#include "DeviationWindowTest.moc"

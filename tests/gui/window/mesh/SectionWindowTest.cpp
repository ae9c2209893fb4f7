// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../StlFiles.h"
#include "../WindowDriver.h"
#include "../WindowTestMain.h"
#include "theme/Theme.h"
#include "viewport/Lighting.h"
#include "viewport/Viewport.h"

#include <QComboBox>
#include <QRegularExpression>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// The section by the clipping plane, in numbers and in the view: a torus of 48 × 24 about Z, with radii of 30 and 10
// mm.
class SectionWindowTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  QString file() {
    const QString path = m_folder.filePath(QStringLiteral("torus.stl"));
    writeStl(path, quadTorus(48, 24, {}));
    return path;
  }

  // The number in a row of the panel; NaN while there is no such row.
  static double figure(WindowDriver& driver, const char* property) {
    const auto* row = driver.window().findChild<QWidget*>(QStringLiteral("property/") + QLatin1String(property));
    if (!row) return std::nan("");
    for (const QLabel* label : row->findChildren<QLabel*>()) {
      const auto found = QRegularExpression(QStringLiteral("^([0-9.]+)\\D*$")).match(label->text());
      if (found.hasMatch()) return found.captured(1).toDouble();
    }
    return std::nan("");
  }

 private slots:
  // At half its height the torus is cut in two rings of 48 corners.
  void figuresFollowThePlane() {
    WindowDriver driver;
    QVERIFY(driver.open(file()));
    QVERIFY(std::isnan(figure(driver, "section_area")));
    driver.choose("clipModel");
    auto* box = driver.find<QWidget>("property/clip_axis")->findChild<QComboBox*>();
    box->setCurrentIndex(2);
    emit box->activated(2);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    const double polygon = 24.0 * std::sin(2.0 * M_PI / 48.0);
    const double area = polygon * (40.0 * 40.0 - 20.0 * 20.0), length = 96.0 * std::sin(M_PI / 48.0) * (40.0 + 20.0);
    const auto isAbout = [&] {
      return std::abs(figure(driver, "section_area") - area) < 0.005 * area &&
             std::abs(figure(driver, "section_length") - length) < 0.005 * length;
    };
    QTRY_VERIFY2(isAbout(), qPrintable(QString::number(figure(driver, "section_area"))));
    driver.choose("clipModel");
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QTRY_VERIFY(std::isnan(figure(driver, "section_area")));
    QVERIFY(driver.settle());
  }

  // The half section of a bar: the plane is in its axis and faces the viewer, the face is hatched in the colour of
  // sections; models without an axis have none.
  void theHalfSectionOfABar() {
    WindowDriver driver;
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    auto* viewport = driver.find<Viewport>("viewport");
    const auto* half = driver.window().findChild<QAction*>(QStringLiteral("halfSection"));
    QVERIFY(half && !viewport->clipPlane().on);
    driver.choose("halfSection");
    const ClipPlane plane = viewport->clipPlane();
    QVERIFY(plane.on && std::abs(plane.offset) < 1e-12 && std::abs(plane.normal.z()) < 1e-12);
    QVERIFY(plane.normal.dot(viewport->camera().towardsViewer()) > 0.5);
    QVERIFY(driver.settle());
    const QColor cut = sceneColours(currentTheme() == ThemeKind::Dark).cut;
    const auto hasShade = [](const QImage& picture, const QColor& wanted) {
      int count = 0;
      for (int y = 0; y < picture.height(); y += 2) {
        for (int x = 0; x < picture.width(); x += 2) {
          const QColor c = picture.pixelColor(x, y);
          const int off = std::abs(c.red() - wanted.red()) + std::abs(c.green() - wanted.green()) +
                          std::abs(c.blue() - wanted.blue());
          if (off < 24) ++count;
        }
      }
      return count > 200;
    };
    const auto isHatched = [&] {
      const QImage picture = viewport->grabImage();
      const QColor line = QColor::fromRgbF(0.62 * cut.redF(), 0.62 * cut.greenF(), 0.62 * cut.blueF());
      return hasShade(picture, cut) && hasShade(picture, line);
    };
    QTRY_VERIFY(isHatched());
    // Its position is the user's once the user moves it; the half section ends with the plane.
    driver.choose("clipModel");
    QVERIFY(!viewport->clipPlane().on && !half->isChecked());
    driver.choose("halfSection");
    QVERIFY(driver.open(file()));
    QVERIFY(!viewport->clipPlane().on && !half->isEnabled());
  }
};

HANDWHEEL_WINDOW_TEST(SectionWindowTest)
#include "SectionWindowTest.moc"

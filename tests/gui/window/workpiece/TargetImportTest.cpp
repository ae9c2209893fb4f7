// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowDriver.h"
#include "../WindowTestMain.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"

#include <QAction>
#include <QDialog>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// The target of a workpiece, from a drawing.
class TargetImportTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  // A shaft of ⌀36 over 40 mm and ⌀24 over 20 mm, drawn with that end at the largest X: the free one. It is turned end
  // for end in the dialog, and later once more, as a step that undo takes back.
  void isTurnedEndForEnd() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("shaft.svg");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        "<svg xmlns='http://www.w3.org/2000/svg' width='60mm' height='20mm' viewBox='0 0 60 20'>"
        "<line id='axis' x1='0' y1='20' x2='60' y2='20'/>"
        "<path d='M0,20 L0,2 L40,2 L40,8 L60,8 L60,20'/></svg>");
    file.close();
    WindowDriver driver;
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    auto& workpiece = static_cast<WorkpieceDocument&>(driver.window().findChild<DocumentTabs*>()->current()->document);
    auto* const turn = driver.find<QAction>("turnWorkpieceTarget");
    QVERIFY(!turn->isEnabled());
    driver.find<QAction>("importTarget")->trigger();
    QVERIFY(driver.enterFileName("targetDialog", path));
    QVERIFY(driver.settle());
    QTRY_VERIFY(driver.window().findChild<QDialog*>("targetPlaceDialog"));
    auto* const dialog = driver.find<QDialog>("targetPlaceDialog");
    const auto isFree = [&](const QString& diameter) {
      const auto labels = dialog->findChildren<QLabel*>();
      return std::any_of(labels.begin(), labels.end(), [&](const QLabel* each) {
        return each->text().contains(QStringLiteral("The end of %1 mm is the free one").arg(diameter));
      });
    };
    auto* const picture = dialog->findChild<QLabel*>("targetPlacePicture");
    QTRY_VERIFY(picture && picture->isVisible());
    const QImage before = picture->pixmap().toImage();
    QVERIFY(isFree(QStringLiteral("⌀24")));
    dialog->findChild<QPushButton*>("turnTarget")->click();
    QVERIFY(isFree(QStringLiteral("⌀36")));
    QVERIFY(picture->pixmap().toImage() != before);
    dialog->findChild<QPushButton*>("propertiesAccept")->click();
    QVERIFY(driver.settle());

    const auto radiusBelowFace = [&](double mm) {
      const TargetProfile& target = workpiece.workpiece().target->profile;
      return target.extentAt(target.upperEnd() - mm)->outer;
    };
    QVERIFY(workpiece.workpiece().target != nullptr);
    QVERIFY(std::abs(radiusBelowFace(39.5) - 18.0) < 1e-3 && std::abs(radiusBelowFace(40.5) - 12.0) < 1e-3);
    QVERIFY(turn->isEnabled());
    turn->trigger();
    QVERIFY(std::abs(radiusBelowFace(19.5) - 12.0) < 1e-3 && std::abs(radiusBelowFace(20.5) - 18.0) < 1e-3);
    driver.click("quickActions/undo");
    QTRY_VERIFY(std::abs(radiusBelowFace(39.5) - 18.0) < 1e-3);
    driver.click("quickActions/undo");
    QTRY_VERIFY(workpiece.workpiece().target == nullptr);
    QTRY_VERIFY(!turn->isEnabled());
  }
};

HANDWHEEL_WINDOW_TEST(TargetImportTest)
#include "TargetImportTest.moc"

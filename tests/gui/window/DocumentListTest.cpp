// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"

#include <QTreeWidget>

using namespace handwheel;
using namespace handwheel::test;

// The list of open documents, by the keyboard alone.
class DocumentListTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  QString file(const char* name) {
    const QString path = m_folder.filePath(QString::fromLatin1(name));
    writeStl(path, quadTorus(24, 12, {{3, 5}}));
    return path;
  }
  // With the focus in the list, on the document that is shown.
  QTreeWidget* enteredList(WindowDriver& driver) {
    if (!driver.open(file("first.stl")) || !driver.open(file("second.stl"))) qFatal("a file cannot be opened");
    driver.window().activateWindow();
    if (!QTest::qWaitForWindowActive(&driver.window())) qFatal("the window does not become active");
    auto* list = driver.find<QTreeWidget>("documentTree");
    list->setFocus();
    return list;
  }
  static QString rowText(const QTreeWidget* list, int column, int role) {
    return list->currentItem()->data(column, role).toString();
  }

 private slots:
  void arrowKeysShowWhatTheyReach() {
    WindowDriver driver;
    QTreeWidget* list = enteredList(driver);
    const auto* tabs = driver.find<QTabBar>("documentTabBar");
    QCOMPARE(tabs->currentIndex(), 1);
    QTest::keyClick(list, Qt::Key_Up);
    QCOMPARE(tabs->currentIndex(), 0);
    QVERIFY(list->hasFocus());
    QTest::keyClick(list, Qt::Key_Down);
    QCOMPARE(tabs->currentIndex(), 1);
    QCOMPARE(list->currentItem()->text(0), QStringLiteral("second.stl"));
    QTest::keyClick(list, Qt::Key_Return);
    QVERIFY(driver.find<Viewport>("viewport")->hasFocus());
    QVERIFY(driver.settle());
  }

  void tabsAreWalkedThroughByKeys() {
    WindowDriver driver;
    (void)enteredList(driver);
    QVERIFY(driver.open(file("third.stl")));
    auto* tabs = driver.find<QTabBar>("documentTabBar");
    tabs->setFocus();
    QTest::keyClick(tabs, Qt::Key_Left);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Left);
    QCOMPARE(tabs->currentIndex(), 0);
    QVERIFY(driver.settle());
  }

  void spaceIsTheEye() {
    WindowDriver driver;
    QTreeWidget* list = enteredList(driver);
    const QString shown = rowText(list, 1, Qt::AccessibleTextRole);
    QTest::keyClick(list, Qt::Key_Space);
    QTRY_VERIFY(driver.find<Viewport>("viewport")->bounds().isEmpty());
    QVERIFY(rowText(list, 1, Qt::AccessibleTextRole) != shown);
    QVERIFY(rowText(list, 0, Qt::AccessibleTextRole).contains("hidden"));
    QTest::keyClick(list, Qt::Key_Space);
    QTRY_VERIFY(!driver.find<Viewport>("viewport")->bounds().isEmpty());
    QCOMPARE(rowText(list, 1, Qt::AccessibleTextRole), shown);
    QVERIFY(driver.settle());
  }

  void aCommandHidesTheDocument() {
    WindowDriver driver;
    QVERIFY(!driver.find<QAction>("toggleDocument")->isEnabled());
    QVERIFY(driver.open(file("hide.stl")));
    driver.choose("toggleDocument");
    QTRY_VERIFY(driver.find<Viewport>("viewport")->bounds().isEmpty());
    driver.choose("toggleDocument");
    QTRY_VERIFY(!driver.find<Viewport>("viewport")->bounds().isEmpty());
    QVERIFY(driver.settle());
  }

  // The eye of a document that is not in view does not bring it there.
  void theMouseTogglesAnyEye() {
    WindowDriver driver;
    QTreeWidget* list = enteredList(driver);
    QTreeWidgetItem* first = list->topLevelItem(0);
    const QRect eye = list->visualRect(list->model()->index(0, 1));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, eye.center());
    QVERIFY(first->data(0, Qt::AccessibleTextRole).toString().contains("hidden"));
    QCOMPARE(driver.find<QTabBar>("documentTabBar")->currentIndex(), 1);
    QCOMPARE(list->currentItem(), list->topLevelItem(1));
    const QRect name = list->visualRect(list->model()->index(0, 0));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, name.center());
    QCOMPARE(driver.find<QTabBar>("documentTabBar")->currentIndex(), 0);
    QVERIFY(driver.settle());
  }

  // The picture in a row has the proportions of the view, not those of an icon.
  void rowsShowPictures() {
    WindowDriver driver;
    QVERIFY(driver.open(file("picture.stl")));
    auto* list = driver.find<QTreeWidget>("documentTree");
    const auto size = [list] { return list->topLevelItem(0)->icon(0).actualSize({480, 480}); };
    QTRY_VERIFY_WITH_TIMEOUT(size().width() > size().height(), kPatienceMs);
    const QImage picture = list->topLevelItem(0)->icon(0).pixmap(320).toImage();
    QSet<QRgb> colours;
    for (int x = 0; x < picture.width(); ++x) colours.insert(picture.pixel(x, picture.height() / 2));
    QVERIFY(colours.size() > 8);  // a shaded part, not an empty view
  }
};

HANDWHEEL_WINDOW_TEST(DocumentListTest)
#include "DocumentListTest.moc"

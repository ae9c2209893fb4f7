// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/MessageBar.h"

#include "ControlsTestMain.h"

#include <QAbstractButton>
#include <QLabel>
#include <QPushButton>
#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

class MessageBarTest : public QObject {
  Q_OBJECT

 private slots:
  // The latest is in front; closing it or using its action brings back the one before. A repeated one counts once.

  void messagesWaitForEachOther() {
    QWidget window;
    MessageBar bar(&window);
    window.show();
    const auto text = [&bar] { return bar.findChild<QLabel*>("messageText")->text(); };
    const auto press = [&bar](const char* name) {
      auto* button = bar.findChild<QAbstractButton*>(name);
      QVERIFY(button->isVisible());
      button->click();
    };
    int recovered = 0, discarded = 0;
    const auto recover = [&] { ++recovered; };
    bar.showMessage({Message::Weight::Warning, "recover", {}, {}, "Recover", recover});
    bar.showMessage({Message::Weight::Warning, "either", {}, {}, "Recover", recover, "Discard", [&] { ++discarded; }});
    for (const char* title : {"first", "second", "first"})
      bar.showMessage({Message::Weight::Error, title, {}, {}, {}, {}});
    QVERIFY(text().contains("first"));
    QCOMPARE(bar.findChild<QPushButton*>("messageMore")->text(), QString("3 more"));
    QVERIFY(!bar.findChild<QWidget*>("messageAction")->isVisible());
    QVERIFY(!bar.findChild<QWidget*>("messageOther")->isVisible());
    press("messageClose");
    QVERIFY(text().contains("second"));
    press("messageClose");
    QVERIFY(text().contains("either"));
    press("messageOther");
    QCOMPARE(discarded, 1);
    QCOMPARE(recovered, 0);
    QVERIFY(text().contains("recover"));
    QVERIFY(!bar.findChild<QWidget*>("messageMore")->isVisible());
    press("messageAction");
    QCOMPARE(recovered, 1);
    QVERIFY(bar.isHidden());
  }

  // A loss is read first, whatever comes later, and the button for the others says how serious they are.
  void aLossIsNotHiddenBehindOthers() {
    QWidget window;
    MessageBar bar(&window);
    window.show();
    const auto text = [&bar] { return bar.findChild<QLabel*>("messageText")->text(); };
    auto* const more = bar.findChild<QPushButton*>("messageMore");
    Message loss{Message::Weight::Warning, "material was lost"};
    loss.comesFirst = true;
    bar.showMessage(loss);
    bar.showMessage({Message::Weight::Info, "two pieces were deleted"});
    QVERIFY(text().contains("material was lost"));
    QVERIFY(more->isVisible() && more->icon().isNull());
    more->click();  // it was read
    QVERIFY(text().contains("two pieces were deleted"));
    QVERIFY(!more->icon().isNull());
    bar.showMessage({Message::Weight::Info, "later"});
    QVERIFY(text().contains("later"));
    QVERIFY(!more->icon().isNull());
  }

  // Once there was time to read what was lost in a document, the answers to what the user does there are seen.
  void whatWasReadComesFirstNoMore() {
    QWidget window;
    MessageBar bar(&window);
    window.show();
    const char fixture[] = "a";
    const auto* const document = reinterpret_cast<const Document*>(fixture);
    bar.setDocument(document);
    const auto text = [&bar] { return bar.findChild<QLabel*>("messageText")->text(); };
    Message loss{Message::Weight::Warning, "material was lost"};
    loss.comesFirst = true;
    loss.about = document;
    bar.showMessage(loss);
    Message answer{Message::Weight::Warning, "the point is not in the segment"};
    answer.about = document;
    bar.showMessage(answer);
    QVERIFY(text().contains("material was lost"));
    bar.setReadingTime(0);
    bar.showMessage(answer);
    QVERIFY(text().contains("not in the segment"));
    QVERIFY(!bar.findChild<QPushButton*>("messageMore")->icon().isNull());
    bar.forget(document);
  }

  // It covers no more of the view than its text needs at its width.

  void aLineIsAsHighAsAnotherLine() {
    QWidget window, *area = new QWidget(&window);
    area->setGeometry(0, 0, 6000, 400);
    MessageBar bar(&window);
    bar.lieOver(area);
    window.show();
    bar.showMessage({Message::Weight::Info, "short", {}, {}, {}, {}});
    QCoreApplication::processEvents();
    const int height = bar.height();
    bar.findChild<QAbstractButton*>("messageClose")->click();
    bar.showMessage({Message::Weight::Info, QString("word ").repeated(40) + "end", {}, {}, {}, {}});
    QCoreApplication::processEvents();
    QCOMPARE(bar.height(), height);
  }

  // A button may still get the release of a key or of the mouse when its message is no longer in front.

  void aMessageThatWentHasNoButtons() {
    QWidget window;
    MessageBar bar(&window);
    window.show();
    int done = 0;
    bar.showMessage({Message::Weight::Warning, "first", {}, {}, "Do", [&] { ++done; }});
    bar.showMessage({Message::Weight::Error, "second", {}, {}, {}, {}});
    bar.findChild<QAbstractButton*>("messageAction")->click();
    bar.findChild<QAbstractButton*>("messageOther")->click();
    QCOMPARE(done, 0);
    QVERIFY(bar.findChild<QLabel*>("messageText")->text().contains("second"));
    bar.findChild<QAbstractButton*>("messageClose")->click();
    bar.findChild<QAbstractButton*>("messageAction")->click();
    QCOMPARE(done, 1);
    for (const char* name : {"messageAction", "messageOther", "messageClose"})
      bar.findChild<QAbstractButton*>(name)->click();
    QCOMPARE(done, 1);
    QVERIFY(bar.isHidden());
  }

  // A later message about the same subject replaces the earlier one; about other subjects, and about no document, it
  // does not.
  void laterMessagesReplaceEarlierOnes() {
    QWidget window;
    MessageBar bar(&window);
    window.show();
    const char fixture[] = "ab";
    const auto* a = reinterpret_cast<const Document*>(fixture);
    bar.setDocument(a);
    const auto show = [&bar](const char* detail, const Document* about) {
      bar.showMessage({Message::Weight::Warning, "path.src was written", detail, {}, {}, {}, {}, {}, about});
    };
    const auto* more = bar.findChild<QWidget*>("messageMore");
    show("the part has moved", a);
    show("all is well", a);
    QVERIFY(!more->isVisible());
    QVERIFY(bar.findChild<QLabel*>("messageText")->text().contains("all is well"));
    show("all is well", nullptr);
    QVERIFY(more->isVisible());
  }

  // Pointers to documents are only compared.
  void messagesGoWithTheirDocument() {
    QWidget window;
    MessageBar bar(&window);
    window.show();
    const auto text = [&bar] { return bar.findChild<QLabel*>("messageText")->text(); };
    const auto about = [](const char* title, const char* document) {
      return Message{
          Message::Weight::Error, title, {}, {}, {}, {}, {}, {}, reinterpret_cast<const Document*>(document)};
    };
    const char fixture[] = "ab";
    const auto* a = reinterpret_cast<const Document*>(fixture);
    const auto* b = reinterpret_cast<const Document*>(fixture + 1);
    bar.setDocument(a);
    bar.showMessage(about("of a", fixture));
    QVERIFY(bar.isVisible());
    bar.setDocument(b);
    QVERIFY(bar.isHidden());
    bar.showMessage(about("of a, later", fixture));  // visible, although another document is current
    QVERIFY(text().contains("of a, later"));
    QVERIFY(!bar.findChild<QWidget*>("messageMore")->isVisible());
    bar.showMessage({Message::Weight::Info, "of the program", {}, {}, {}, {}});
    bar.setDocument(a);
    QVERIFY(text().contains("of the program"));
    QCOMPARE(bar.findChild<QPushButton*>("messageMore")->text(), QString("2 more"));
    bar.setDocument(b);
    QVERIFY(text().contains("of the program"));
    QVERIFY(!bar.findChild<QWidget*>("messageMore")->isVisible());
    bar.forget(a);
    bar.setDocument(nullptr);
    QVERIFY(text().contains("of the program"));
    QTest::mouseClick(bar.findChild<QAbstractButton*>("messageClose"), Qt::LeftButton);
    QVERIFY(bar.isHidden());
    bar.setDocument(a);
    QVERIFY(bar.isHidden());
    // A message that there was time to read is not shown over other documents.
    bar.setReadingTime(0);
    bar.showMessage({Message::Weight::Error, "of a file that is not open", {}, {}, {}, {}});
    bar.showMessage(about("of a", fixture));
    bar.setDocument(a);
    QCOMPARE(bar.findChild<QPushButton*>("messageMore")->text(), QString("1 more"));
    QTest::qWait(5);
    bar.setDocument(b);
    QVERIFY(bar.isHidden());
    bar.setDocument(a);
    QVERIFY(text().contains("of a"));
    QVERIFY(!bar.findChild<QWidget*>("messageMore")->isVisible());
    bar.forget(a);
  }

  // A message about possible loss comes first, whatever arrives later.
  void someComeFirst() {
    QWidget window;
    MessageBar bar(&window);
    window.show();
    const auto text = [&bar] { return bar.findChild<QLabel*>("messageText")->text(); };
    bar.showMessage({Message::Weight::Warning, "recover", {}, {}, {}, {}, {}, {}, nullptr, {}, true});
    bar.showMessage({Message::Weight::Error, "later", {}, {}, {}, {}});
    QVERIFY(text().contains("recover"));
    bar.setReadingTime(0);
    QTest::qWait(5);
    const char fixture[] = "a";
    bar.setDocument(reinterpret_cast<const Document*>(fixture));
    QVERIFY(text().contains("recover"));  // while others about no document have gone
    QVERIFY(!bar.findChild<QWidget*>("messageMore")->isVisible());
  }

  void theNextOneIsShownOnDemand() {
    QWidget window;
    MessageBar bar(&window);
    window.show();
    for (const char* title : {"first", "second", "third"})
      bar.showMessage({Message::Weight::Info, title, {}, {}, {}, {}, {}, {}, nullptr, {}, title[0] == 's'});
    QStringList seen;
    for (int i = 0; i < 4; ++i) {
      seen << bar.findChild<QLabel*>("messageText")->text();
      bar.findChild<QAbstractButton*>("messageMore")->click();
    }
    QCOMPARE(seen, QStringList({"<b>second</b>", "<b>third</b>", "<b>first</b>", "<b>second</b>"}));
  }

  // A message that is over is removed with the next message, without any change of its document.
  void theNextOneOfItsSort() {
    QWidget window;
    MessageBar bar(&window);
    window.show();
    int last = 0;
    for (int number = 1; number <= 2; ++number) {
      last = number;
      Message message{Message::Weight::Info, QString::number(number)};
      message.isOver = [&last, number] { return last != number; };
      bar.showMessage(message);
    }
    QCOMPARE(bar.findChild<QLabel*>("messageText")->text(), QString("<b>2</b>"));
    QVERIFY(!bar.findChild<QWidget*>("messageMore")->isVisible());
  }

  void whatIsOverIsWithdrawn() {
    QWidget window;
    MessageBar bar(&window);
    window.show();
    const char fixture[] = "ab";
    const auto* a = reinterpret_cast<const Document*>(fixture);
    const auto* b = reinterpret_cast<const Document*>(fixture + 1);
    for (const Document* about : {a, b}) {
      for (const char* topic : {"saving", "links"})
        bar.showMessage({Message::Weight::Error, topic, {}, {}, {}, {}, {}, {}, about, topic});
    }
    bar.withdraw(a, "saving");
    bar.setDocument(a);
    QVERIFY(bar.findChild<QLabel*>("messageText")->text().contains("links"));
    QVERIFY(!bar.findChild<QWidget*>("messageMore")->isVisible());
    bar.setDocument(b);
    QCOMPARE(bar.findChild<QPushButton*>("messageMore")->text(), QString("1 more"));
  }
};

HANDWHEEL_CONTROLS_TEST(MessageBarTest)
#include "MessageBarTest.moc"

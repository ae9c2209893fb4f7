// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "process/ReaderAnswer.h"

#include "TestClass.h"

#include <QTest>

using namespace handwheel;

class ReaderAnswerTest : public QObject {
  Q_OBJECT

 private slots:
  void theLastByteSaysWhatItIs() {
    const auto content = answerOf("rmc");
    QVERIFY(content && content->kind == ReaderAnswer::Kind::Content);
    QCOMPARE(content->text, std::string("rm"));
    const auto nothing = answerOf("c");
    QVERIFY(nothing && nothing->text.empty());
    const auto reason = answerOf("it is emptyr");
    QVERIFY(reason && reason->kind == ReaderAnswer::Kind::Reason);
    QCOMPARE(reason->text, std::string("it is empty"));
    const auto memory = answerOf("m");
    QVERIFY(memory && memory->kind == ReaderAnswer::Kind::OutOfMemory);
  }

  void whatIsNoAnswer() {
    for (const char* bytes : {"", "x", "contentC", "r", "\xff"}) QVERIFY2(!answerOf(bytes), bytes);
    QVERIFY(!answerOf(std::string(201, 'x') + "r"));
    QVERIFY(answerOf(std::string(200, 'x') + "r"));
    QVERIFY(!answerOf(std::string("c\0", 2)));
  }
};

HANDWHEEL_TEST(ReaderAnswerTest)
#include "ReaderAnswerTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/Utf8.h"

#include "TestClass.h"

#include <QTest>
#include <QUtf8StringView>
#include <string>

using namespace handwheel;

// Tests the recognition of UTF-8 against Qt's.
class Utf8Test : public QObject {
  Q_OBJECT

 private slots:
  // All sequences of two bytes, and those of three and four bytes whose bytes are at the limits of the standard.
  void asQtDoes() {
    const auto isSame = [](const std::string& bytes) {
      return isUtf8(bytes) == QUtf8StringView(bytes.data(), static_cast<qsizetype>(bytes.size())).isValidUtf8();
    };
    for (int first = 0; first < 256; ++first) {
      for (int second = 0; second < 256; ++second)
        QVERIFY(isSame({static_cast<char>(first), static_cast<char>(second)}));
    }
    const std::string edges =
        "\x7f\x80\x8f\x90\x9f\xa0\xbf\xc0\xc1\xc2\xdf\xe0\xe1\xec\xed\xee\xef\xf0\xf1\xf4\xf5\xff";
    for (const char a : edges) {
      for (const char b : edges) {
        for (const char c : edges) {
          QVERIFY(isSame({a, b, c}));
          for (const char d : edges) QVERIFY(isSame({a, b, c, d}));
        }
      }
    }
    QVERIFY(isUtf8(""));
  }
};

HANDWHEEL_TEST(Utf8Test)
#include "Utf8Test.moc"

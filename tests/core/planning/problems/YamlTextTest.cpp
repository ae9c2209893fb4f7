// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/problems/YamlText.h"

#include "TestClass.h"

#include <QtTest>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

std::string repeated(const std::string& what, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i) text += what;
  return text;
}

}  // namespace

// Tests untrusted YAML as JSON. The expectations follow from YAML 1.2, sections 6 to 8 and 10.3.
class YamlTextTest : public QObject {
  Q_OBJECT

 private slots:
  void valuesByTheirForm() {
    const auto read = parseYaml(
        "a: [1, -2.5, 1e-05, .5]\n"
        "b: {c: true, d: null, e: ~, f: }\n"
        "'g h': \"1\"\n"
        "i:\n  - x: 1\n    y: {}\n  - text of words\n"
        "2: # a number is a text where it is a key\n  -0\n",
        "text");
    QVERIFY(read.hasValue());
    const nlohmann::json expected = {{"a", {1.0, -2.5, 1e-5, 0.5}},
                                     {"b", {{"c", true}, {"d", nullptr}, {"e", nullptr}, {"f", nullptr}}},
                                     {"g h", "1"},
                                     {"i", {{{"x", 1.0}, {"y", nlohmann::json::object()}}, "text of words"}},
                                     {"2", -0.0}};
    QVERIFY2(*read == expected, read->dump().c_str());
    QVERIFY(parseYaml("", "text").hasValue() && parseYaml("", "text")->is_null());
  }

  void hostile_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("reason");
    const auto row = [](const char* name, const std::string& text, const char* reason) {
      QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(reason);
    };
    std::string laughs = "a0: &a0 [x, x, x]\n";
    for (int i = 1; i < 30; ++i) {
      const std::string before = "*a" + std::to_string(i - 1), name = "a" + std::to_string(i);
      laughs += name + ": &" + name + " [" + before + ", " + before + ", " + before + "]\n";
    }
    row("a billion laughs", laughs, "aliases");
    row("a list in itself", "&a [*a]", "aliases");
    row("lists in lists", repeated("[", 100'000) + repeated("]", 100'000), "");  // the parser may take one for a key
    row("maps in maps", repeated("{a: ", 100'000) + repeated("}", 100'000), "");
    row("rows in rows", repeated("- ", 100'000), "deep");
    row("keys of keys", repeated("? ", 100'000), "key");
    row("a map as key", "? {a: b}\n: c", "key");
    row("the same key twice", "a: 1\na: 2", "twice");
    row("two documents", "a: 1\n---\nb: 2", "more than one");
    row("more values than allowed", "[" + repeated("1,", YamlLimits::kMostNodes + 1) + "]", "too many");
    row("more bytes than allowed", std::string(YamlLimits::kMostBytes + 1, ' '), "too large");
    row("not ended", "a: [1, 2", "not YAML");
    row("an unknown escape", "a: \"\\q\"", "not YAML");
    row("a character beyond Unicode", "a: \"\\UFFFFFFFF\"", "not YAML");
  }

  void hostile() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, reason);
    const auto read = parseYaml(text.toStdString(), "scene");
    QVERIFY(!read);
    QVERIFY(read.error().code == ErrorCode::ElementMalformed);
    QCOMPARE(read.error().arguments.at(0), std::string("scene"));
    QVERIFY2(QByteArray::fromStdString(read.error().arguments.at(1)).contains(reason),
             read.error().arguments.at(1).c_str());
  }

  // Anything else is read or refused, and nothing crashes; the parser's own tokens in every order.
  void tokensInEveryOrder() {
    const std::vector<std::string> tokens = {
        "!",   "!2", "!<",   "%YAML 9.9\n",  "%TAG ! x\n", "&", "*", "|", ">", "'", "\"", "\\",
        "-",   "- ", "? ",   ": ",           ",",          "[", "]", "{", "}", "#", "\n", "---",
        "...", "a",  "\xff", "\xef\xbb\xbf", "@",          "`"};
    for (const std::string& a : tokens) {
      for (const std::string& b : tokens) {
        for (const std::string& c : tokens) {
          const auto read = parseYaml(a + b + c, "text");
          QVERIFY(read || read.error().code == ErrorCode::ElementMalformed);
        }
      }
    }
  }

  void theLineOfTheDamage() {
    const auto read = parseYaml("a: 1\nb: 2\nc: *d\n", "text");
    QVERIFY(!read);
    QCOMPARE(int(read.error().position.kind), int(InputPosition::Kind::Line));
    QCOMPARE(read.error().position.value, std::uint64_t{3});
  }
};

HANDWHEEL_TEST(YamlTextTest)
#include "YamlTextTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "xml/Xml.h"
#include "xml/XmlNumbers.h"

#include <QTest>
#include <clocale>
#include <cmath>

using namespace handwheel;

namespace {

ErrorCode codeOf(std::string_view bytes, const XmlLimits& limits = {}) {
  const auto root = readXml(bytes, limits);
  return root ? ErrorCode::Unsupported : root.error().code;
}

std::string nested(std::size_t depth) {
  std::string text;
  for (std::size_t i = 0; i < depth; ++i) text += "<a>";
  for (std::size_t i = 0; i < depth; ++i) text += "</a>";
  return text;
}

}  // namespace

class XmlTest : public QObject {
  Q_OBJECT

 private slots:
  void tree();
  void encodings();
  void malformedHasALine();
  void limits();
  void entitiesAreRefused();
  void cancelled();
  void numbers();
  void numbersDoNotFollowTheLocale();
};

void XmlTest::tree() {
  const auto root =
      readXml("<?xml version='1.0'?>\n<!-- <b/> --><a x='1' y='&lt;2'>\n <b>one<c/> two</b>\n <b/> </a>", {});
  QVERIFY(root.hasValue());
  QCOMPARE(root->name, std::string("a"));
  QCOMPARE(root->line, std::uint64_t{2});
  QCOMPARE(*root->attribute("x"), std::string("1"));
  QCOMPARE(*root->attribute("y"), std::string("<2"));
  QVERIFY(!root->attribute("z"));
  QVERIFY(root->text.empty());
  QCOMPARE(root->children.size(), std::size_t{2});
  QCOMPARE(root->child("b")->text, std::string("one two"));
  QCOMPARE(root->child("b")->line, std::uint64_t{3});
  QCOMPARE(root->child("b")->child("c")->line, std::uint64_t{3});
  QCOMPARE(root->children[1].line, std::uint64_t{4});
  QVERIFY(!root->child("c"));
}

void XmlTest::encodings() {
  const auto latin = readXml("<?xml version='1.0' encoding='ISO-8859-1'?><a x='\xe4'/>", {});
  QVERIFY(latin.hasValue());
  QCOMPARE(*latin->attribute("x"), std::string("\xc3\xa4"));
  QCOMPARE(codeOf("<a x='\xe4'/>"), ErrorCode::ElementMalformed);  // no UTF-8
  const QString text = QStringLiteral("\ufeff<a x='ä'/>");
  const auto wide = readXml({reinterpret_cast<const char*>(text.utf16()), std::size_t(text.size()) * 2}, {});
  QVERIFY(wide.hasValue());
  QCOMPARE(*wide->attribute("x"), std::string("\xc3\xa4"));
}

void XmlTest::malformedHasALine() {
  for (std::string_view text : {"", "  ", "solid x", "<a>", "<a></b>", "<a x=1/>", "<a/><b/>", "<a>&none;</a>", "<a"})
    QCOMPARE(codeOf(text), ErrorCode::ElementMalformed);
  const auto root = readXml("<a>\n<b>\n</a>", {});
  QVERIFY(!root);
  QVERIFY(root.error().position.kind == InputPosition::Kind::Line);
  QCOMPARE(root.error().position.value, std::uint64_t{3});
}

void XmlTest::limits() {
  QVERIFY(readXml(nested(64), {}).hasValue());
  QCOMPARE(codeOf(nested(65)), ErrorCode::ElementMalformed);
  QCOMPARE(codeOf(nested(1'000'000)), ErrorCode::ElementMalformed);
  QCOMPARE(codeOf("<a><b/><b/></a>", {.elements = 2}), ErrorCode::FileTooLarge);
  QVERIFY(readXml("<a><b/></a>", {.elements = 2}).hasValue());
  std::string attributes;
  for (int i = 0; i < 9; ++i) attributes += " x" + std::to_string(i) + "=''";
  QVERIFY(readXml("<a" + attributes + "/>", {.elements = 2}).hasValue());
  QCOMPARE(codeOf("<a" + attributes + "/>", {.elements = 1}), ErrorCode::FileTooLarge);
  QCOMPARE(codeOf("<a/>", {.bytes = 3}), ErrorCode::FileTooLarge);
}

void XmlTest::entitiesAreRefused() {
  std::string bomb = "<!DOCTYPE a [<!ENTITY e0 'ha'>";
  for (int i = 1; i < 30; ++i) {
    const std::string before = "&e" + std::to_string(i - 1) + ";";
    bomb += "<!ENTITY e" + std::to_string(i) + " '" + before + before + "'>";
  }
  const auto root = readXml(bomb + "]><a>&e29;</a>", {});
  QVERIFY(!root);
  QCOMPARE(root.error().code, ErrorCode::Unsupported);
  QCOMPARE(codeOf("<!DOCTYPE a [<!ENTITY f SYSTEM 'file:///etc/hostname'>]><a>&f;</a>"), ErrorCode::Unsupported);
  QVERIFY(readXml("<!DOCTYPE a><a/>", {}).hasValue());
}

void XmlTest::cancelled() {
  JobState state;
  state.cancelled = true;
  const auto root = readXml("<a/>", {}, Progress(state));
  QVERIFY(!root);
  QCOMPARE(root.error().code, ErrorCode::Cancelled);
}

void XmlTest::numbers() {
  const std::pair<const char*, double> kGood[] = {{"1.", 1.0},    {".81", 0.81},   {"+2", 2.0},
                                                  {"-1e3", -1e3}, {"1e-400", 0.0}, {"-0.0", 0.0}};
  for (const auto& [word, value] : kGood) QCOMPARE(*parseNumber(word), value);
  for (const char* word : {"", "+", "-", "+-1", "1,5", "1.5x", "0x10", "${x}"})
    QCOMPARE(parseNumber(word).error().code, ErrorCode::NumberMalformed);
  QCOMPARE(parseNumber("1e400").error().code, ErrorCode::NumberNotFinite);

  // The sign of the exponent alone does not tell which end of the range was exceeded.
  const std::string zeros(400, '0');
  QCOMPARE(*parseNumber("0." + zeros + "1"), 0.0);
  QCOMPARE(*parseNumber("0." + zeros + "1e5"), 0.0);
  QCOMPARE(parseNumber("1" + zeros + "e-5").error().code, ErrorCode::NumberNotFinite);

  double three[3] = {};
  QVERIFY(parseNumbers(" 1\t2\n3 ", three).hasValue());
  QVERIFY(three[0] == 1 && three[1] == 2 && three[2] == 3);
  QCOMPARE(parseNumbers("1 2", three).error().code, ErrorCode::CountMismatch);
  QCOMPARE(parseNumbers("1 2 3 4", three).error().code, ErrorCode::CountMismatch);
  for (const char* text : {"1 nan 3", "inf 2 3", "1 2 -Infinity", "1 2 1e999"})
    QCOMPARE(parseNumbers(text, three).error().code, ErrorCode::NumberNotFinite);
}

void XmlTest::numbersDoNotFollowTheLocale() {
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) QSKIP("the locale de_DE.UTF-8 is not installed");
  const auto number = parseNumber("1.5");
  std::setlocale(LC_ALL, "C");
  QCOMPARE(*number, 1.5);
}

HANDWHEEL_TEST(XmlTest)
#include "XmlTest.moc"

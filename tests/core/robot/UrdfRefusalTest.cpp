// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/UrdfReader.h"

#include "Robots.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const std::string kUrdfRefusalAB = link("a") + link("b");

std::string urdfRefusalJointAB(const std::string& type, const std::string& inside = {}) {
  return robotOf(kUrdfRefusalAB + joint("j", type, "a", "b", inside));
}

}  // namespace

class UrdfRefusalTest : public QObject {
  Q_OBJECT

 private slots:
  void refused_data();
  void refused();
  void linesOfErrors();
};

void UrdfRefusalTest::refused_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<ErrorCode>("code");
  const auto row = [](const char* name, const std::string& text, ErrorCode code) {
    QTest::newRow(name) << QString::fromStdString(text) << code;
  };
  const ErrorCode kMalformed = ErrorCode::ElementMalformed;
  row("no XML", "solid part", kMalformed);
  row("something else", "<html/>", kMalformed);
  row("empty", robotOf(""), kMalformed);
  row("link without name", robotOf("<link/>"), kMalformed);
  row("two links of a name", robotOf(link("a") + link("a")), kMalformed);
  row("two joints of a name",
      robotOf(kUrdfRefusalAB + link("c") + joint("j", "fixed", "a", "b") + joint("j", "fixed", "b", "c")), kMalformed);
  row("joint without name", robotOf(kUrdfRefusalAB + "<joint type='fixed'/>"), kMalformed);
  row("joint without type", robotOf(kUrdfRefusalAB + "<joint name='j'/>"), kMalformed);
  row("unknown type", urdfRefusalJointAB("hinge"), kMalformed);
  row("no parent", robotOf(kUrdfRefusalAB + "<joint name='j' type='fixed'><child link='b'/></joint>"), kMalformed);
  row("missing parent", robotOf(link("b") + joint("j", "fixed", "a", "b")), ErrorCode::ReferenceMissing);
  row("missing child", robotOf(link("a") + joint("j", "fixed", "a", "b")), ErrorCode::ReferenceMissing);
  row("two roots", robotOf(kUrdfRefusalAB), kMalformed);
  row("no root", robotOf(kUrdfRefusalAB + joint("j", "fixed", "a", "b") + joint("k", "fixed", "b", "a")), kMalformed);
  row("own parent", robotOf(link("a") + joint("j", "fixed", "a", "a")), kMalformed);
  row("two parents",
      robotOf(kUrdfRefusalAB + link("c") + joint("j", "fixed", "a", "b") + joint("k", "fixed", "a", "c") +
              joint("l", "fixed", "c", "b")),
      kMalformed);
  row("ring apart",
      robotOf(kUrdfRefusalAB + link("c") + link("d") + joint("j", "fixed", "a", "b") + joint("k", "fixed", "c", "d") +
              joint("l", "fixed", "d", "c")),
      kMalformed);
  row("no axis", urdfRefusalJointAB("revolute", "<axis xyz='0 0 0'/>" + limit(-1, 1)), kMalformed);
  row("axis of two numbers", urdfRefusalJointAB("revolute", "<axis xyz='0 1'/>" + limit(-1, 1)),
      ErrorCode::CountMismatch);
  row("axis not finite", urdfRefusalJointAB("revolute", "<axis xyz='0 nan 0'/>" + limit(-1, 1)),
      ErrorCode::NumberNotFinite);
  row("origin not finite", urdfRefusalJointAB("fixed", "<origin xyz='inf 0 0'/>"), ErrorCode::NumberNotFinite);
  row("turn not finite", urdfRefusalJointAB("fixed", "<origin rpy='0 0 1e999'/>"), ErrorCode::NumberNotFinite);
  row("origin no number", urdfRefusalJointAB("fixed", "<origin xyz='${x} 0 0'/>"), ErrorCode::NumberMalformed);
  row("origin too far", urdfRefusalJointAB("fixed", "<origin xyz='1e7 0 0'/>"), ErrorCode::ValueOutOfRange);
  row("limits turned round", urdfRefusalJointAB("revolute", limit(1, -1)), kMalformed);
  row("limits at infinity", urdfRefusalJointAB("revolute", "<limit lower='inf' upper='inf'/>"), kMalformed);
  row("limits at its other end", urdfRefusalJointAB("prismatic", "<limit lower='-inf' upper='-inf'/>"), kMalformed);
  row("limits too far", urdfRefusalJointAB("prismatic", "<limit lower='1e300' upper='1e301'/>"), kMalformed);
  row("limit not a number", urdfRefusalJointAB("revolute", "<limit lower='nan' upper='1'/>"),
      ErrorCode::NumberNotFinite);
  row("limit malformed", urdfRefusalJointAB("revolute", "<limit lower='a' upper='1'/>"), ErrorCode::NumberMalformed);
  row("limit of two numbers", urdfRefusalJointAB("revolute", "<limit lower='0 1' upper='1'/>"),
      ErrorCode::NumberMalformed);
  row("follows nobody", urdfRefusalJointAB("revolute", limit(-1, 1) + "<mimic/>"), kMalformed);
  row("follows too far",
      robotOf(kUrdfRefusalAB + link("c") + joint("j", "revolute", "a", "b", limit(-1, 1)) +
              joint("k", "revolute", "b", "c", limit(-1, 1) + "<mimic joint='j' multiplier='1e300'/>")),
      kMalformed);
  row("xacro", robotOf(link("a") + "<xacro:include filename='x'/>"), ErrorCode::Unsupported);
}

void UrdfRefusalTest::refused() {
  QFETCH(QString, text);
  QFETCH(ErrorCode, code);
  const auto read = readUrdf(text.toStdString());
  QVERIFY(!read);
  QCOMPARE(read.error().code, code);
}

void UrdfRefusalTest::linesOfErrors() {
  const auto read = readUrdf("<robot>\n<link name='a'/>\n<link name='b'/>\n\n" +
                             joint("j", "revolute", "a", "b", "\n<axis xyz='0 0 oops'/>") + "</robot>");
  QVERIFY(!read);
  QCOMPARE(read.error().position.value, std::uint64_t{6});
  QCOMPARE(read.error().arguments, std::vector<std::string>{"oops"});
  const auto roots = readUrdf("<robot>\n<link name='a'/>\n<link name='b'/>\n</robot>");
  QCOMPARE(roots.error().position.value, std::uint64_t{3});
  const auto ring = readUrdf("<robot>\n" + kUrdfRefusalAB + link("c") + joint("i", "fixed", "b", "c") +
                             joint("j", "fixed", "a", "b") + joint("k", "fixed", "b", "a") + "</robot>");
  QCOMPARE(ring.error().code, ErrorCode::ElementMalformed);
  QVERIFY(ring.error().position.value == 3 || ring.error().position.value == 4);  // i only hangs on it
}

HANDWHEEL_TEST(UrdfRefusalTest)
#include "UrdfRefusalTest.moc"

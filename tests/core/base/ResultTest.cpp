// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/Result.h"

#include <QTest>
#include <memory>

using namespace handwheel;

namespace {

Result<int> half(int n) {
  if (n % 2 != 0) return Error{ErrorCode::NumberMalformed, {std::to_string(n)}, InputPosition::line(3), "numbers.txt"};
  return n / 2;
}

const ErrorDescription kBent{.id = "Bent"};
const ErrorDescription kTwin{.id = "Bent"};
constexpr ErrorCode kCode = kBent;  // a constant wherever its texts are
static_assert(kCode == kBent && !(kCode == kTwin));

}  // namespace

class ResultTest : public QObject {
  Q_OBJECT

 private slots:
  void value();
  void error();
  void codes();
  void movesOut();
  void done();
};

void ResultTest::value() {
  Result<int> r = half(8);
  QVERIFY(r.hasValue());
  QVERIFY(bool(r));
  QCOMPARE(*r, 4);
  *r = 5;
  QCOMPARE(r.value(), 5);
}

void ResultTest::error() {
  const Result<int> r = half(7);
  QVERIFY(!r);
  QVERIFY(r.error().code == ErrorCode::NumberMalformed);
  QCOMPARE(r.error().arguments, std::vector<std::string>({"7"}));
  QVERIFY(r.error().position.kind == InputPosition::Kind::Line);
  QCOMPARE(r.error().position.value, std::uint64_t{3});
  QCOMPARE(r.error().subject, std::string("numbers.txt"));
}

// Codes are compared by identity, not by name; the default is Cancelled.
void ResultTest::codes() {
  ErrorCode code;
  QVERIFY(code == ErrorCode::Cancelled);
  QVERIFY(Error().code == code);
  code = kBent;
  const ErrorCode copy = code;
  QVERIFY(copy == kBent && copy != kTwin && copy != ErrorCode::Cancelled);
  QCOMPARE(copy->id, "Bent");
}

void ResultTest::movesOut() {
  Result<std::unique_ptr<int>> r(std::make_unique<int>(9));
  const std::unique_ptr<int> out = std::move(r).value();
  QCOMPARE(*out, 9);
}

void ResultTest::done() {
  const Status ok = Done{};
  const Status failed = Error{ErrorCode::Cancelled, {}, {}, {}};
  QVERIFY(ok.hasValue());
  QVERIFY(!failed.hasValue());
}

HANDWHEEL_TEST(ResultTest)
#include "ResultTest.moc"

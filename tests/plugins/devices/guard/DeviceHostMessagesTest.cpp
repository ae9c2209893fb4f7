// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/DeviceHostMessages.h"

#include <rapidcheck.h>
#include <QtTest>
#include <cstring>
#include <limits>

#include "HapticPoses.h"
#include "TestClass.h"
#include "haptics/device/DeviceErrors.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

guard::Message anyMessage() {
  const auto number = static_cast<std::uint32_t>(*rc::gen::inRange(0, 1 << 30));
  switch (*rc::gen::inRange(0, 7)) {
    case 0:
      return guard::Open{number};
    case 1:
      return guard::Force{number, {anyVector(), anyVector(), anyNumber()}};
    case 2:
      return guard::Close{};
    case 3:
      return guard::Opening{*rc::gen::inRange(0, 101) / 100.0};
    case 4: {
      DeviceCapabilities all;
      all.maxForce = 3.25;
      all.workspaceRadius = 70.0 + *rc::gen::inRange(0, 9);
      all.buttons = *rc::gen::inRange(0, 33);
      all.isRateControl = *rc::gen::arbitrary<bool>();
      return guard::Opened{all};
    }
    case 5: {
      Error error{DeviceError::NotResponding, {}, {}, *rc::gen::arbitrary<std::string>()};
      for (int i = *rc::gen::inRange(0, 4); i > 0; --i) error.arguments.push_back(*rc::gen::arbitrary<std::string>());
      return guard::Refused{error};
    }
    default: {
      DeviceState state;
      state.position = anyVector();
      state.orientation = anyRotation().normalized();
      state.velocity = anyVector();
      state.gripper = anyNumber();
      state.buttons = number;
      state.reading = number / 3;
      state.status = *rc::gen::element(DeviceStatus::Absent, DeviceStatus::Ready, DeviceStatus::Failed);
      state.hasVelocity = *rc::gen::arbitrary<bool>();
      return guard::State{number, state};
    }
  }
}

std::string bytesOf(const guard::Message& message) {
  guard::Buffer buffer;
  const auto bytes = guard::bytesOf(message, buffer);
  return {bytes.begin(), bytes.end()};
}

std::span<const std::uint8_t> spanOf(const std::string& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

// Returns the messages in bytes that come in pieces of at most so many.
std::vector<guard::Message> read(guard::Reader& reader, const std::string& bytes, std::size_t piece) {
  std::vector<guard::Message> all;
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    reader.add(spanOf(bytes).subspan(at, std::min(piece, bytes.size() - at)));
    while (auto message = reader.next()) all.push_back(std::move(*message));
  }
  return all;
}

// Returns a message with one number overwritten.
std::string changed(const guard::Message& message, std::size_t at, double value) {
  std::string bytes = bytesOf(message);
  std::memcpy(bytes.data() + at, &value, sizeof(value));
  return bytes;
}

bool breaks(const std::string& bytes) {
  guard::Reader reader;
  return read(reader, bytes, 64).empty() && reader.isBroken();
}

}  // namespace

class DeviceHostMessagesTest : public QObject {
  Q_OBJECT

 private slots:
  // Orientations are normalised again in transit, so one transfer is compared with another.
  void comeThroughInPiecesOfAnySize() {
    QVERIFY(rc::check([] {
      std::vector<std::string> sent;
      std::string bytes;
      for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
        sent.push_back(bytesOf(anyMessage()));
        bytes += sent.back();
      }
      guard::Reader reader;
      const auto received = read(reader, bytes, static_cast<std::size_t>(*rc::gen::inRange(1, 300)));
      RC_ASSERT(!reader.isBroken());
      RC_ASSERT(received.size() == sent.size());
      for (std::size_t i = 0; i < sent.size(); ++i) {
        if (const auto* state = std::get_if<guard::State>(&received[i])) {
          RC_ASSERT(std::abs(state->state.orientation.norm() - 1.0) < 1e-12);
          RC_ASSERT(bytesOf(received[i]).substr(0, 36) == sent[i].substr(0, 36));  // head, number, position
        } else {
          RC_ASSERT(bytesOf(received[i]) == sent[i]);
        }
      }
    }));
  }

  void codesArriveAsTheyAre() {
    for (const ErrorCode code : {ErrorCode(ErrorCode::ReferenceMissing), ErrorCode(DeviceError::PluginVersion)}) {
      guard::Reader reader;
      const auto received = read(reader, bytesOf(guard::Refused{{code, {}, {}, {}}}), 100);
      QCOMPARE(std::get<guard::Refused>(received.at(0)).error.code, code);
    }
    guard::Reader reader;
    const auto foreign = read(reader, bytesOf(guard::Refused{{ErrorCode::VersionNewer, {}, {}, {}}}), 100);
    QCOMPARE(std::get<guard::Refused>(foreign.at(0)).error.code, DeviceError::Unreachable);
  }

  void longTextsAreCut() {
    const guard::Refused refused{{ErrorCode::LibraryFailed, {std::string(5000, 'a'), "b", "c", "d"}, {}, "e"}};
    guard::Reader reader;
    const auto received = read(reader, bytesOf(refused), 100);
    QCOMPARE(received.size(), std::size_t{1});
    const Error& error = std::get<guard::Refused>(received[0]).error;
    QVERIFY(error.code == ErrorCode::LibraryFailed);
    QCOMPARE(error.arguments.size(), std::size_t{3});
    QVERIFY(error.arguments[0].size() >= 100 && error.arguments[0].size() < 1000);
    QCOMPARE(error.arguments[1], std::string("b"));
    QCOMPARE(error.subject, std::string("e"));
  }

  // A force or position that is not finite breaks the stream.
  void whatIsNoNumberBreaks() {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
      for (std::size_t at = 12; at < 12 + 7 * 8; at += 8) QVERIFY(breaks(changed(guard::Force{}, at, bad)));
      for (std::size_t at = 12; at < 12 + 11 * 8; at += 8) QVERIFY(breaks(changed(guard::State{}, at, bad)));
      QVERIFY(breaks(changed(guard::Opening{}, 8, bad)));
    }
    QVERIFY(breaks(changed(guard::State{}, 12 + 6 * 8, 0.0)));  // w: no rotation at all
    QVERIFY(breaks(changed(guard::Opening{}, 8, 1.5)));
  }

  void nonsenseBreaksForGood() {
    const std::string good = bytesOf(guard::Close{});
    QVERIFY(breaks(std::string(100, '\xff')));
    QVERIFY(breaks(std::string("\x02\0\0\0\x01\0\0\0x", 9)));      // a byte more than the message has
    QVERIFY(breaks(std::string("\x01\0\0\0\x04\0\0\0abcd", 12)));  // fewer
    QVERIFY(breaks(std::string("\0\0\0\0\xff\xff\xff\x7f", 8)));   // longer than any
    guard::Reader reader;
    QVERIFY(read(reader, std::string(100, '\xff') + good, 64).empty());
    QVERIFY(read(reader, good, 64).empty());
  }
};

HANDWHEEL_TEST(DeviceHostMessagesTest)
#include "DeviceHostMessagesTest.moc"

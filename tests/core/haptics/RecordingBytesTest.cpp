// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/RecordingBytes.h"

#include <rapidcheck.h>
#include <QtTest>
#include <cstring>
#include <limits>

#include "HapticPoses.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

RecordedTick anyTick(std::uint64_t number) {
  RecordedTick tick;
  tick.tick = number;
  tick.tip.position = anyVector(1e7);
  tick.tip.orientation = anyRotation();
  tick.tip.velocity = anyVector();
  tick.tip.gripper = anyNumber();
  tick.tip.time = anyNumber();
  tick.tip.period = anyNumber();
  tick.tip.stiffnessLimit = *rc::gen::element(std::numeric_limits<double>::infinity(), 0.3);
  tick.tip.dampingLimit = anyNumber();
  tick.tip.buttons = static_cast<std::uint32_t>(*rc::gen::inRange(0, 1 << 30));
  tick.tip.isRestart = *rc::gen::arbitrary<bool>();
  tick.felt.force = anyVector();
  tick.felt.torque = anyVector();
  tick.felt.gripper = anyNumber();
  tick.felt.proxy = anyVector();
  tick.felt.isContact = *rc::gen::arbitrary<bool>();
  tick.felt.isFresh = *rc::gen::arbitrary<bool>();
  tick.felt.isSoftened = *rc::gen::arbitrary<bool>();
  tick.felt.stiffness = anyNumber();
  tick.sent = {anyVector(), anyVector(), anyNumber()};
  tick.devicePosition = anyVector();
  tick.actions = static_cast<std::uint32_t>(*rc::gen::inRange(0, 1 << 9));
  tick.microseconds = 1.25f;
  tick.status = *rc::gen::element(DeviceStatus::Absent, DeviceStatus::Ready, DeviceStatus::Failed);
  tick.hasSource = *rc::gen::arbitrary<bool>();
  return tick;
}

Recording anyRecording() {
  Recording recording;
  const int ticks = *rc::gen::inRange(0, 6), events = *rc::gen::inRange(0, 3);
  for (int i = 0; i < ticks; ++i) recording.add(anyTick(static_cast<std::uint64_t>(2 * i + 3)));
  for (int i = 0; i < events; ++i) recording.addEvent({static_cast<std::uint64_t>(i), std::string(i * 5, 'x')});
  return recording;
}

bool isSame(const RecordedTick& a, const RecordedTick& b) {
  const auto felt = [](const ForceOut& x, const ForceOut& y) {
    return x.force == y.force && x.torque == y.torque && x.gripper == y.gripper && x.proxy == y.proxy &&
           x.isContact == y.isContact && x.isFresh == y.isFresh && x.isSoftened == y.isSoftened &&
           x.stiffness == y.stiffness;
  };
  const auto tip = [](const TipState& x, const TipState& y) {
    return x.position == y.position && x.orientation.coeffs() == y.orientation.coeffs() && x.velocity == y.velocity &&
           x.gripper == y.gripper && x.time == y.time && x.period == y.period && x.stiffnessLimit == y.stiffnessLimit &&
           x.dampingLimit == y.dampingLimit && x.buttons == y.buttons && x.isRestart == y.isRestart;
  };
  return a.tick == b.tick && tip(a.tip, b.tip) && felt(a.felt, b.felt) && a.sent.force == b.sent.force &&
         a.sent.torque == b.sent.torque && a.sent.gripper == b.sent.gripper && a.devicePosition == b.devicePosition &&
         a.actions == b.actions && a.microseconds == b.microseconds && a.status == b.status &&
         a.hasSource == b.hasSource;
}

Recording twoTicks() {
  Recording recording;
  recording.add({});
  recording.add({1, {}, {}, {}, {}, {}, {}, {}, {}});
  recording.addEvent({0, "begun"});
  return recording;
}

}  // namespace

class RecordingBytesTest : public QObject {
  Q_OBJECT

 private slots:
  void readsBackTheSame() {
    QVERIFY(rc::check("the same", [] {
      const Recording recording = anyRecording();
      const auto read = recordingFromBytes(recordingBytes(recording));
      RC_ASSERT(read.hasValue());
      RC_ASSERT(read->size() == recording.size() && read->missing() == recording.missing());
      for (std::size_t i = 0; i < recording.size(); ++i) RC_ASSERT(isSame((*read)[i], recording[i]));
      RC_ASSERT(read->events().size() == recording.events().size());
      for (std::size_t i = 0; i < recording.events().size(); ++i) {
        RC_ASSERT(read->events()[i].tick == recording.events()[i].tick);
        RC_ASSERT(read->events()[i].text == recording.events()[i].text);
      }
    }));
  }

  // The sizes that the header states: 20 bytes, an event of 12 and its text, ticks of 312.
  void isAsLongAsStated() {
    QCOMPARE(recordingBytes(Recording()).size(), std::size_t{20});
    QCOMPARE(recordingBytes(twoTicks()).size(), std::size_t{20 + 12 + 5 + 2 * 312});
  }

  void everyCutIsFound() {
    const std::string bytes = recordingBytes(twoTicks());
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      const auto read = recordingFromBytes(std::string_view(bytes).substr(0, length));
      QVERIFY(!read.hasValue());
      QVERIFY(read.error().code == (length < 4 ? ErrorCode::HeaderMalformed : ErrorCode::DataTruncated));
    }
    QVERIFY(recordingFromBytes(bytes + "x").error().code == ErrorCode::CountMismatch);
  }

  // Announces far more than there is: told at once, without asking for the memory.
  void announcedNumbersAreNotBelieved() {
    std::string bytes = recordingBytes(twoTicks());
    std::string many = bytes;
    std::memset(many.data() + 12, 0xff, 8);
    QVERIFY(recordingFromBytes(many).error().code == ErrorCode::DataTruncated);
    many = bytes;
    std::memset(many.data() + 8, 0xff, 4);
    QVERIFY(recordingFromBytes(many).error().code == ErrorCode::DataTruncated);
  }

  void aNewerVersionIsRefused() {
    std::string bytes = recordingBytes(twoTicks());
    bytes[4] = 2;
    QVERIFY(recordingFromBytes(bytes).error().code == ErrorCode::VersionNewer);
  }

  // A tip must be somewhere; what a failed device said, and a scene without an answer, may be no number.
  void tipsAreFinite() {
    RecordedTick tick;
    tick.devicePosition.x() = tick.felt.force.y() = std::numeric_limits<double>::quiet_NaN();
    Recording recording;
    recording.add(tick);
    QVERIFY(recordingFromBytes(recordingBytes(recording)).hasValue());
    tick.tip.position.z() = std::numeric_limits<double>::infinity();
    tick.tick = 1;
    recording.add(tick);
    const auto read = recordingFromBytes(recordingBytes(recording));
    QVERIFY(!read.hasValue() && read.error().code == ErrorCode::NumberNotFinite);
    QCOMPARE(read.error().place.value, std::uint64_t{20 + 312});
  }
};

QTEST_GUILESS_MAIN(RecordingBytesTest)
#include "RecordingBytesTest.moc"

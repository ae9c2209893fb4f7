// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/RecordingBytes.h"

#include <rapidcheck.h>
#include <QtTest>
#include <cstring>
#include <limits>

#include "AnyRecording.h"
#include "TestClass.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

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
      RC_ASSERT(read.hasValue() && isSame(*read, recording));
    }));
  }

  // Parts, cut anywhere, are recordings, and one after the other they are the whole.
  void partsAreTheWhole() {
    QVERIFY(rc::check("parts", [] {
      const Recording recording = anyRecording();
      Recording together;
      std::size_t first = 0;
      do {
        const std::size_t last = first + static_cast<std::size_t>(*rc::gen::inRange<int>(
                                             first < recording.size() ? 1 : 0, recording.size() - first + 1));
        const auto part = recordingFromBytes(recordingBytes(recording, first, last));
        RC_ASSERT(part.hasValue() && part->size() == last - first);
        together.append(*part);
        first = last;
      } while (first < recording.size());
      RC_ASSERT(isSame(together, recording));
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

  // Announces far more than there is: refused at once, without allocating the memory.
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

  // A tip must be finite; the reading of a failed device, and a scene without an answer, need not.
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
    QCOMPARE(read.error().position.value, std::uint64_t{20 + 312});
  }

  // The player needs the times.
  void timesAreFinite() {
    RecordedTick tick;
    tick.tip.time = std::numeric_limits<double>::quiet_NaN();
    Recording recording;
    recording.add(tick);
    QVERIFY(recordingFromBytes(recordingBytes(recording)).error().code == ErrorCode::NumberNotFinite);
  }
};

HANDWHEEL_TEST(RecordingBytesTest)
#include "RecordingBytesTest.moc"

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "falcon/Packet.h"

#include <rapidcheck.h>
#include <QtTest>
#include <string>

using namespace handwheel;
using namespace handwheel::falcon;

namespace {

std::string text(const PacketBytes& bytes) {
  return {bytes.begin(), bytes.end()};
}

std::span<const std::uint8_t> bytesOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// Returns an answer with these encoders; status as the device sends it.
std::string answer(const Counts& encoders, int status) {
  std::string packet = text(encode(encoders, 0));
  packet[13] = static_cast<char>('A' + status);
  return packet;
}

}  // namespace

class FalconPacketTest : public QObject {
  Q_OBJECT

 private slots:
  void packetsAsDocumented() {
    QCOMPARE(text(encode({}, 0)), std::string("<AAAAAAAAAAAAAA>"));
    QCOMPARE(text(encode({-1447, 0, 0}, 0)).substr(0, 5), std::string("<JFKP"));
    QCOMPARE(text(encode({0, 0, 4096}, kHoming | kRed)), std::string("<AAAAAAAAAAABJA>").replace(13, 1, "J"));
  }

  void answersAreRead() {
    AnswerReader reader;
    QCOMPARE(reader.take(bytesOf(answer({-1447, 12, 32767}, 0x74))), 1);
    QCOMPARE(reader.reading().encoders, (Counts{-1447, 12, 32767}));
    QCOMPARE(reader.reading().buttons, std::uint8_t(4));
    QVERIFY(reader.reading().isHomed());
    QCOMPARE(reader.take(bytesOf(answer({1, 2, 3}, 0x31))), 1);
    QVERIFY(!reader.reading().isHomed());
  }

  void piecesOfAnySizeMakeTheSame() {
    const bool ok = rc::check([](const std::vector<std::array<std::int16_t, 3>>& all) {
      std::string stream;
      for (const auto& n : all) stream += answer({n[0], n[1], n[2]}, 0x70);
      AnswerReader reader;
      int answers = 0;
      for (std::size_t at = 0; at < stream.size();) {
        const auto length = static_cast<std::size_t>(*rc::gen::inRange(1, 40));
        answers += reader.take(bytesOf(stream.substr(at, length)));
        at += length;
      }
      RC_ASSERT(answers == static_cast<int>(all.size()));
      if (all.empty()) return;
      RC_ASSERT(reader.reading().encoders == (Counts{all.back()[0], all.back()[1], all.back()[2]}));
    });
    QVERIFY(ok);
  }

  // Packets cut short at any byte give no false reading, and at most one whole packet after the cut is lost.
  void aCutPacketIsPassedOver() {
    for (std::size_t kept = 0; kept < kPacketSize; ++kept) {
      AnswerReader reader;
      QCOMPARE(reader.take(bytesOf(answer({1, 1, 1}, 0x70))), 1);
      const int answers = reader.take(
          bytesOf(answer({-7, -7, -7}, 0x7f).substr(0, kept) + answer({2, 2, 2}, 0x70) + answer({3, 3, 3}, 0x70)));
      QCOMPARE(answers, 2);
      QCOMPARE(reader.reading().encoders, (Counts{3, 3, 3}));
      QCOMPARE(reader.reading().buttons, std::uint8_t(0));
    }
  }

  void noiseIsNoAnswer() {
    const bool ok = rc::check([](const std::vector<std::uint8_t>& noise) {
      AnswerReader reader;
      (void)reader.take(noise);
      reader.clear();
      RC_ASSERT(reader.take(bytesOf(answer({4, 5, 6}, 0x70))) == 1);
      RC_ASSERT(reader.reading().encoders == (Counts{4, 5, 6}));
    });
    QVERIFY(ok);
    AnswerReader reader;
    QCOMPARE(reader.take(bytesOf("<AAAAAAAAAAA!AA>")), 0);  // no nibble
    QCOMPARE(reader.take(bytesOf("<AAAAAAAAAAAAAAA")), 0);  // no end
  }
};

HANDWHEEL_TEST(FalconPacketTest)
#include "FalconPacketTest.moc"

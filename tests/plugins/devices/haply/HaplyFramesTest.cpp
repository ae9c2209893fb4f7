// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haply/Frames.h"

#include <rapidcheck.h>
#include <QtTest>

using namespace handwheel::haply;

namespace {

std::span<const std::uint8_t> haplyFramesBytesOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::vector<Message> all(FrameReader& reader) {
  std::vector<Message> messages;
  while (auto message = reader.next()) messages.push_back(std::move(*message));
  return messages;
}

std::vector<Message> read(const std::string& stream) {
  FrameReader reader;
  reader.take(haplyFramesBytesOf(stream));
  return all(reader);
}

bool haplyFramesBreaks(const std::string& stream) {
  FrameReader reader;
  reader.take(haplyFramesBytesOf(stream));
  (void)all(reader);
  return reader.isBroken();
}

using namespace std::string_literals;

}  // namespace

class HaplyFramesTest : public QObject {
  Q_OBJECT

 private slots:
  // RFC 6455, section 5.7.
  void examplesOfTheStandard() {
    QCOMPARE(read("\x81\x05Hello"s)[0].payload, "Hello"s);
    QCOMPARE(maskedFrame(Opcode::Text, "Hello", 0x37fa213d), "\x81\x85\x37\xfa\x21\x3d\x7f\x9f\x4d\x51\x58"s);
    const auto fragmented = read("\x01\x03Hel\x80\x02lo"s);
    QCOMPARE(fragmented.size(), std::size_t(1));
    QCOMPARE(fragmented[0].payload, "Hello"s);
    const auto ping = read("\x89\x05Hello"s);
    QVERIFY(ping[0].opcode == Opcode::Ping && ping[0].payload == "Hello");
    const std::string k256(256, 'x'), k65536(65536, 'y');
    QCOMPARE(read("\x82\x7e\x01\x00"s + k256)[0].payload, k256);
    QCOMPARE(read("\x82\x7f\x00\x00\x00\x00\x00\x01\x00\x00"s + k65536)[0].payload, k65536);
  }

  void lengthsOfMaskedFrames() {
    for (const std::size_t size : {0u, 125u, 126u, 65535u, 65536u}) {
      const std::string frame = maskedFrame(Opcode::Text, std::string(size, 'z'), 0);
      QCOMPARE(frame.size(), size + (size < 126 ? 6 : size < 65536 ? 8 : 14));
      QVERIFY(frame.ends_with(std::string(size, 'z')));
    }
  }

  void aPingMayComeBetweenFragments() {
    const auto messages = read(
        "\x01\x01"
        "a"
        "\x89\x00"
        "\x80\x01"
        "b"s);
    QCOMPARE(messages.size(), std::size_t(2));
    QVERIFY(messages[0].opcode == Opcode::Ping);
    QCOMPARE(messages[1].payload, "ab"s);
  }

  void whatIsNoFrameBreaksTheStream() {
    QVERIFY(haplyFramesBreaks("\x81\x85\x00\x00\x00\x00Hello"s));  // a server does not mask
    QVERIFY(haplyFramesBreaks("\xc1\x00"s));                       // reserved bits
    QVERIFY(haplyFramesBreaks("\x83\x00"s));                       // an opcode that is none
    QVERIFY(haplyFramesBreaks("\x80\x00"s));                       // continues nothing
    QVERIFY(
        haplyFramesBreaks("\x01\x01"
                          "a"
                          "\x01\x01"
                          "b"s));                                             // two begun
    QVERIFY(haplyFramesBreaks("\x09\x00"s));                                  // a ping in pieces
    QVERIFY(haplyFramesBreaks("\x81\x7f\xff\xff\xff\xff\xff\xff\xff\xff"s));  // huge
    QVERIFY(!haplyFramesBreaks("\x81\x05Hel"s));                              // not whole yet
  }

  void piecesOfAnySizeMakeTheSame() {
    const bool ok = rc::check([](const std::vector<std::string>& texts) {
      std::string stream;
      for (const std::string& text : texts)
        stream += "\x81"s + static_cast<char>(text.size() % 126) + text.substr(0, text.size() % 126);
      FrameReader reader;
      std::vector<Message> messages;
      for (std::size_t at = 0; at < stream.size();) {
        const auto length = static_cast<std::size_t>(*rc::gen::inRange(1, 50));
        reader.take(haplyFramesBytesOf(stream.substr(at, length)));
        for (Message& message : all(reader)) messages.push_back(std::move(message));
        at += length;
      }
      RC_ASSERT(messages.size() == texts.size());
      for (std::size_t i = 0; i < texts.size(); ++i)
        RC_ASSERT(messages[i].payload == texts[i].substr(0, texts[i].size() % 126));
    });
    QVERIFY(ok);
  }
};

HANDWHEEL_TEST(HaplyFramesTest)
#include "HaplyFramesTest.moc"

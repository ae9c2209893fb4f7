// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheCollisions.h"

#include "TestClass.h"
#include "machining/lathe/LatheJson.h"
#include "machining/lathe/LatheMounting.h"

#include <QtTest>
#include <array>
#include <set>

using namespace handwheel;

// Parts of a lathe that meet, and how they are reported.
class LatheCollisionsTest : public QObject {
  Q_OBJECT

 private slots:
  void partsHaveTitlesOfTheirOwn() {
    std::set<std::string> titles;
    for (std::size_t i = 0; i < kLatheParts; ++i) titles.insert(titleOf(static_cast<LathePart>(i)));
    QVERIFY(titles.size() == kLatheParts && !titles.contains(""));
    QCOMPARE(std::string(titleOf(LathePart::Work)), std::string("Workpiece"));
  }

  void reasonsAreSentencesOfTheirOwn() {
    std::set<std::string> sentences;
    for (const CrashCause cause : {CrashCause::Contact, CrashCause::Rapid, CrashCause::SpindleAtRest,
                                   CrashCause::Reversed, CrashCause::TooDeep, CrashCause::Overload})
      sentences.insert(sentenceOf(cause));
    for (const MountRefusal refusal :
         {MountRefusal::Unknown, MountRefusal::NotAllowed, MountRefusal::Turning, MountRefusal::InTheWay})
      sentences.insert(sentenceOf(refusal));
    QCOMPARE(sentences.size(), std::size_t{10});
    for (const std::string& sentence : sentences) QVERIFY2(sentence.ends_with('.'), sentence.c_str());
  }

  // A triangle beside the axis has its image on the other side, with the same roundness; twice mirrored it is itself.
  void sectionsAreMirrored() {
    const std::array<ProfilePoint, 3> corners{{{3, 1}, {8, 2}, {5, 6}}};
    const RoundedPolygon section(corners, 0.5), image = section.mirrored();
    const SectionSweep here(section, {0, 0}, {0, 0}), there(image, {0, 0}, {0, 0});
    QCOMPARE(there.least(), -here.largest());
    QCOMPARE(there.largest(), -here.least());
    QCOMPARE(there.first(), here.first());
    QCOMPARE(image.radius(), 0.5);
    QVERIFY(!(image == section) && image.mirrored() == section);
  }

  // Two boxes with 1 mm between them touch once one has gone this far.
  void solidsTouch() {
    const std::array<ProfilePoint, 4> box{{{0, 0}, {0, 10}, {5, 10}, {5, 0}}};
    const std::vector<LatheSolid> moved{{LathePart::Holder, RoundedPolygon(box, 0.0)}},
        others{{LathePart::Jaws, RoundedPolygon(box, 0.0).moved({0.0, -11.0})}};
    QVERIFY(!contactBetween(moved, {0.0, -0.99}, others));
    const auto contact = contactBetween(moved, {0.0, -1.01}, others);
    QVERIFY(contact && contact->moving == LathePart::Holder && contact->struck == LathePart::Jaws);
    QVERIFY(contact->position == ProfilePoint(0.0, -1.01) && contact->cause == CrashCause::Contact);
    QVERIFY(!contactBetween(moved, {6.0, -1.01}, others));
  }

  // A tool is the same as its copy, and another one with another nose, holder or edge.
  void toolsAreCompared() {
    const LatheTool tool = *toolNamed(shippedLatheTools(), "right-finishing");
    QVERIFY(tool == LatheTool(tool));
    const auto differs = [&tool](auto change) {
      LatheTool other = tool;
      change(other);
      return !(other == tool);
    };
    QVERIFY(differs([](LatheTool& other) { other.noseRadius *= 2.0; }));
    QVERIFY(differs([](LatheTool& other) { other.holder.clear(); }));
    QVERIFY(differs([](LatheTool& other) { other.cutting[0] = other.cutting[0].moved({0.0, 1.0}); }));
  }
};

HANDWHEEL_TEST(LatheCollisionsTest)
#include "LatheCollisionsTest.moc"

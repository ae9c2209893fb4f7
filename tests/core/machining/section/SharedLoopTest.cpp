// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/section/SharedLoop.h"

#include "SectionChecks.h"
#include "TestClass.h"
#include "machining/section/ToolSweep.h"

#include <rapidcheck.h>
#include <QtTest>
#include <set>

using namespace handwheel;

namespace {

// A polygon around a circle. No two neighbours are on one line.
SectionLoop polygon(int corners) {
  const auto at = [&](int i) {
    const double angle = 2.0 * M_PI * (i % corners) / corners;
    return ProfilePoint(20.0 + 10.0 * std::cos(angle), 30.0 + 10.0 * std::sin(angle));
  };
  SectionLoop loop;
  for (int i = 0; i < corners; ++i) loop.push_back(SectionSegment::line(at(i), at(i + 1)));
  return loop;
}

bool isSame(const SectionLoop& a, const SectionLoop& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const SectionSegment& x, const SectionSegment& y) {
    return x.from == y.from && x.to == y.to && x.pass == y.pass;
  });
}

int integerIn(int low, int high) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
}

class SharedLoopTest : public QObject {
  Q_OBJECT

 private slots:
  // Area, box and segments are those of the polygon; by the formula of a regular one.
  void measures() {
    for (const int corners : {3, 15, 16, 17, 64, 65, 200, 5000}) {
      const SectionLoop plain = polygon(corners);
      const SharedLoop loop = SharedLoop::of(plain);
      QVERIFY(isSame(loop.segments(), plain));
      QCOMPARE(loop.size(), plain.size());
      const double area = 0.5 * 100.0 * corners * std::sin(2.0 * M_PI / corners);
      QVERIFY(std::abs(loop.area() - area) < 1e-10 * area);
      QVERIFY(std::abs(loop.volume() - 2.0 * M_PI * 20.0 * area) < 1e-10 * loop.volume());
      for (const SectionRun::Pointer& run : loop.runs()) QVERIFY(run->segments.size() <= 96);
    }
  }

  // Neighbours on one line are joined, also the last and the first one.
  void neighboursAreJoined() {
    SectionLoop square;
    const std::array<ProfilePoint, 4> corners{ProfilePoint(10, 10), ProfilePoint(20, 10), ProfilePoint(20, 20),
                                              ProfilePoint(10, 20)};
    for (std::size_t side = 0; side < 4; ++side) {
      const ProfilePoint &a = corners[side], &b = corners[(side + 1) % 4];
      for (int i = 0; i < 100; ++i)
        square.push_back(SectionSegment::line(a + 0.01 * i * (b - a), a + 0.01 * (i + 1) * (b - a)));
    }
    std::rotate(square.begin(), square.begin() + 30, square.end());
    QCOMPARE(SharedLoop::of(square).size(), std::size_t{4});
    QVERIFY(std::abs(SharedLoop::of(square).area() - 100.0) < 1e-9);
  }

  // Parts of a loop, in order, give the loop again, whatever the parts are. Runs stay neither too small nor too large.
  void partsGiveTheLoopAgain() {
    const bool isHeld = rc::check([] {
      const SectionLoop plain = polygon(integerIn(3, 2000));
      SharedLoop loop = SharedLoop::of(plain);
      for (int round = 0; round < 20; ++round) {
        SharedLoopBuilder builder;
        for (const SectionRun::Pointer& run : loop.runs()) {
          const auto size = static_cast<int>(run->segments.size());
          const int cut = integerIn(0, 3) == 0 ? integerIn(0, size) : 0;
          if (cut > 0) builder.add(RunPart{run, 0, static_cast<std::size_t>(cut)});
          if (cut < size && integerIn(0, 1) == 0) {
            builder.add(run->segments[static_cast<std::size_t>(cut)]);
            if (cut + 1 < size) builder.add(RunPart{run, static_cast<std::size_t>(cut) + 1, run->segments.size()});
          } else if (cut < size) {
            builder.add(RunPart{run, static_cast<std::size_t>(cut), run->segments.size()});
          }
        }
        loop = builder.finish();
        RC_ASSERT(isSame(loop.segments(), plain));
      }
      RC_ASSERT(loop.runs().size() <= plain.size() / 8 + 2);
    });
    QVERIFY(isHeld);
  }

  // A cut shares what it does not meet with the section of before: a few runs are new.
  void aCutSharesTheOtherRuns() {
    TurnedSection section(StockCylinder{50.0, 100.0, 0.0});
    const auto cut = [&](int i) {
      const ProfileSegment move{{26.0, 99.0 - 0.02 * i}, {20.0, 99.0 - 0.02 * i}, 0.0};
      for (const SectionCutter& cutter : cuttersOf(SweptShape{{{0.0, 0.0}}, 0.05}, move))
        QVERIFY(section.subtract(cutter, static_cast<std::uint32_t>(i)).has_value());
    };
    for (int i = 0; i < 4000; ++i) cut(i);
    QVERIFY(section.size() > 3000);
    const TurnedSection before = section;
    cut(4000);
    std::set<SectionRun::Pointer> old;
    for (const SharedLoop& loop : before.loops()) old.insert(loop.runs().begin(), loop.runs().end());
    std::size_t fresh = 0;
    for (const SharedLoop& loop : section.loops())
      for (const SectionRun::Pointer& run : loop.runs()) fresh += old.count(run) == 0 ? 1 : 0;
    QVERIFY(fresh <= 4);
    QVERIFY(old.size() < section.size() / 16);
  }
};

}  // namespace

HANDWHEEL_TEST(SharedLoopTest)
#include "SharedLoopTest.moc"

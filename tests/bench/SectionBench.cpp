// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL before Open CASCADE, which defines a macro with the name of one of its classes.
#include "support/ExactSection.h"

#include "base/ThreadClock.h"
#include "bench/Bars.h"
#include "bench/OccSection.h"

using namespace handwheel;

namespace {

bench::Bars bars;

struct Cut {
  SweptShape shape;
  ProfileSegment move;
};

struct Workload {
  const char* name;
  StockCylinder stock;
  std::vector<Cut> cuts;
};

const SweptShape kInsert{{{0.8, 0.8}, {12.0324, 1.7827}, {13.0151, 13.0151}, {1.7827, 12.0324}}, 0.8};  // CNMG 120408

// 20 passes of four moves to shoulders 4 mm apart, and plunges every 0.2 mm that leave feed marks: round values.
Workload steps() {
  Workload work{"steps, 200 moves of an insert", {50.0, 100.0, 0.0}, {}};
  const auto line = [&](const ProfilePoint& a, const ProfilePoint& b) { work.cuts.push_back({kInsert, {a, b, 0.0}}); };
  for (int pass = 0; pass < 20; ++pass) {
    const double r = 24.5 - 0.5 * pass, z = 10.0 + 4.0 * pass;
    line({26.0, 102.0}, {r, 102.0});
    line({r, 102.0}, {r, z});
    line({r, z}, {r + 0.5, z});
    line({r + 0.5, z}, {26.0, z + 2.0});
  }
  for (int mark = 0; mark < 120; ++mark) {
    const double z = 10.0 + 0.2 * mark;
    line({25.5, z}, {20.0, z});
  }
  return work;
}

// A round nose along a wave, 0.05 mm from point to point.
Workload wave(int moves) {
  Workload work{"wave, moves of a nose", {41.2, 120.0, 0.0}, {}};
  const auto at = [](int i) {
    const double z = 110.0 - 0.05 * i;
    return ProfilePoint(20.8 + 0.5 * std::sin(0.7 * z), z);
  };
  for (int i = 0; i < moves; ++i) work.cuts.push_back({{{{0.0, 0.0}}, 0.8}, {at(i), at(i + 1), 0.0}});
  return work;
}

// Quarters of circles of radii from 1 to 6 mm along the bar, by a nose and by the insert.
Workload arcs() {
  Workload work{"quarters, 48 arcs", {50.0, 120.0, 0.0}, {}};
  for (int i = 0; i < 48; ++i) {
    const double radius = 1.0 + i % 6, z = 112.0 - 2.0 * i, bulge = std::tan(M_PI / 8.0);
    const bool isHollow = i % 2 == 0;
    const SweptShape shape = i % 4 == 3 ? kInsert : SweptShape{{{0.0, 0.0}}, 0.8};
    const ProfilePoint from(24.0, z), to(24.0 - radius, z - radius);
    work.cuts.push_back({shape, {from, to, isHollow ? bulge : -bulge}});
  }
  return work;
}

// The half section as TurnedSection, with the interface of the two others.
class OwnSection {
 public:
  OwnSection(double radius, double length) : m_section(StockCylinder{2.0 * radius, length, 0.0}) {}
  void cut(const SweptShape& shape, const ProfileSegment& move) {
    for (const SectionCutter& cutter : cuttersOf(shape, move))
      if (!m_section.subtract(cutter, 0)) ++m_failures;
  }
  double area() const { return m_section.area(); }
  double volume() const { return m_section.volume(); }
  std::vector<SectionSegment> boundary() const {
    std::vector<SectionSegment> all;
    for (const SharedLoop& loop : m_section.loops()) {
      const SectionLoop segments = loop.segments();
      all.insert(all.end(), segments.begin(), segments.end());
    }
    return all;
  }
  int failures() const { return m_failures; }

 private:
  TurnedSection m_section;
  int m_failures = 0;
};

// Returns the largest distance of points of one boundary from another.
double farthest(const std::vector<SectionSegment>& from, const std::vector<SectionSegment>& to) {
  double largest = 0.0;
  for (const SectionSegment& segment : from) {
    for (const double share : {0.0, 0.31, 0.5, 0.83}) {
      const ProfilePoint p = segment.at(share * segment.length());
      double least = std::numeric_limits<double>::infinity();
      for (const SectionSegment& other : to) least = std::min(least, (other.nearest(p) - p).norm());
      largest = std::max(largest, least);
    }
  }
  return largest;
}

template <class Section>
double secondsOf(const Workload& work, Section& section) {
  return 1e-3 * cpuMilliseconds([&] {
           for (const Cut& cut : work.cuts) section.cut(cut.shape, cut.move);
         });
}

// Compares with another kernel, after the same moves in the same run.
template <class Section>
void compare(benchmark::State& state, const std::string& kernel, const Workload& work) {
  const std::string what = kernel + ", " + work.name + ": ";
  const double r = 0.5 * work.stock.diameter, length = work.stock.length;
  const auto count = static_cast<double>(work.cuts.size());
  bench::Fastest fastest;
  for (int run = 0; run < 3; ++run) {
    OwnSection timed(r, length);
    fastest.add(secondsOf(work, timed));
  }
  OwnSection own(r, length);
  secondsOf(work, own);
  Section other(r, length);
  double seconds = 0.0;
  try {
    seconds = secondsOf(work, other);
  } catch (const std::exception& error) {
    bars.skipped(state, what, error.what());
    return;
  }
  bars.tell(what + "ms per move", 1e3 * seconds / count);
  bars.tell(what + "the same of TurnedSection, ms", 1e3 * fastest.seconds / count);
  bars.tell(what + "its time as a multiple of ours", seconds / fastest.seconds);
  bars.tell(what + "segments", static_cast<double>(other.boundary().size()));
  bars.tell(what + "segments of TurnedSection", static_cast<double>(own.boundary().size()));
  bars.atMost(what + "moves that TurnedSection could not subtract", 0.0, own.failures());
  if constexpr (requires { other.failures(); }) bars.tell(what + "moves that it could not subtract", other.failures());
  bars.tell(what + "area, difference, mm²", std::abs(own.area() - other.area()));
  bars.tell(what + "volume, difference, mm³", std::abs(own.volume() - other.volume()));
  bars.tell(what + "boundary, largest distance, mm",
            std::max(farthest(own.boundary(), other.boundary()), farthest(other.boundary(), own.boundary())));
}

void cgal(benchmark::State& state) {
  for (auto _ : state)
    for (const Workload& work : {steps(), wave(200), arcs()}) compare<test::ExactSection>(state, "CGAL", work);
}

void openCascade(benchmark::State& state) {
  for (auto _ : state)
    for (const Workload& work : {steps(), wave(200), arcs()}) compare<bench::OccSection>(state, "OCCT", work);
}

void longWave(benchmark::State& state) {
  for (auto _ : state) {
    const Workload work = wave(2000);
    OwnSection own(0.5 * work.stock.diameter, work.stock.length);
    const double seconds = secondsOf(work, own);
    bars.atMost("wave, 2,000 moves of a nose: moves that could not be subtracted", 0.0, own.failures());
    bars.tell("the same, ms per move", 1e3 * seconds / 2000.0);
  }
}

}  // namespace

BENCHMARK(longWave)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(cgal)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(openCascade)->Iterations(1)->Unit(benchmark::kMillisecond);

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}

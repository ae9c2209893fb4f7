// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace handwheel::bench {

double secondsOf(auto&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The duration of the shortest of several runs. It is the run that other work on the machine has disturbed least.
struct Fastest {
  double seconds = std::numeric_limits<double>::infinity();
  void add(double run) { seconds = std::min(seconds, run); }
};

// Returns the ratio of a value of Handwheel to that of another program. The result is NaN if the other program has no
// result; it then breaks every bar.
inline double ratioTo(double ours, double theirs) {
  return std::isfinite(theirs) && theirs > 0.0 ? ours / theirs : std::nan("");
}

// The bars (required limits) of a benchmark program and its measured values. They are printed as a table at the end of
// the program.
class Bars {
 public:
  // Sets the upper limit and the measured value of a quantity. Google Benchmark calls a benchmark several times; the
  // last call counts.
  void atMost(const std::string& what, double bar, double measured) { put({what, bar, measured}); }

  // Sets the upper limit and the measured value of a count or maximum over several cases. The bar is broken if there
  // are no cases.
  void atMostOver(std::size_t cases, const std::string& what, double bar, double measured) {
    if (cases > 0)
      atMost(what, bar, measured);
    else
      put({what, bar, std::nan(""), "NO: not measured, there was no case"});
  }

  // Adds a value without a bar to the table.
  void tell(const std::string& what, double measured) {
    atMost(what, std::numeric_limits<double>::infinity(), measured);
  }

  // Breaks a bar with a reason, because a measurement failed that should have been possible.
  void failed(benchmark::State& state, const std::string& what, const std::string& why) {
    state.SkipWithError(why.c_str());
    put({what, std::nan(""), std::nan(""), "NO: " + why});
  }

  // Reports that nothing could be measured, for example because data is missing. Breaks no bar.
  void skipped(benchmark::State& state, const std::string& what, const std::string& why) {
    state.SkipWithError(("SKIPPED: " + why).c_str());
    put({what, std::nan(""), std::nan(""), "SKIPPED: " + why, true});
  }

  // Reports missing data that may not be distributed with Handwheel. Breaks the bar if HANDWHEEL_DATA is set, because
  // its folder must contain the data; otherwise the measurement is skipped.
  void missing(benchmark::State& state, const std::string& what, const std::string& why) {
    std::getenv("HANDWHEEL_DATA") ? failed(state, what, why) : skipped(state, what, why);
  }

  // Prints the table and returns the exit code of the program. It is 1 if a bar was broken, if there are no rows, or if
  // everything was skipped although HANDWHEEL_DATA is set.
  int print() const {
    bool ok = !m_rows.empty();
    std::printf("\n%-76s %9s %9s  %s\n", "what", "bar", "measured", "ok");
    for (const Row& row : m_rows) {
      const bool kept = row.isSkipped || row.measured <= row.bar;  // false for NaN
      if (!row.why.empty())
        std::printf("%-76s %9s %9s  %s\n", row.what.c_str(), "", "", row.why.c_str());
      else if (std::isinf(row.bar))
        std::printf("%-76s %9s %9.3g\n", row.what.c_str(), "", row.measured);
      else
        std::printf("%-76s %9.3g %9.3g  %s\n", row.what.c_str(), row.bar, row.measured, kept ? "yes" : "NO");
      ok &= kept;
    }
    const auto skips = std::count_if(m_rows.begin(), m_rows.end(), [](const Row& row) { return row.isSkipped; });
    if (skips > 0) std::printf("%td SKIPPED: not measured, and so not promised\n", skips);
    const bool nothing = static_cast<std::size_t>(skips) == m_rows.size();
    if (nothing) std::printf("SKIPPED: nothing was measured\n");
    return ok && !(nothing && std::getenv("HANDWHEEL_DATA")) ? 0 : 1;
  }

 private:
  struct Row {
    std::string what;
    double bar;
    double measured;
    std::string why = {};  // reason why there are no values
    bool isSkipped = false;
  };

  void put(const Row& row) {
    const auto at = std::find_if(m_rows.begin(), m_rows.end(), [&](const Row& old) { return old.what == row.what; });
    if (at == m_rows.end())
      m_rows.push_back(row);
    else
      *at = row;
  }

  std::vector<Row> m_rows;
};

inline int run(int argc, char** argv, const Bars& bars) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return bars.print();
}

}  // namespace handwheel::bench

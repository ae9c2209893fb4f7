// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace handwheel::bench {

double secondsOf(auto&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The shortest of several runs, which other work on the machine has disturbed least.
struct Fastest {
  double seconds = std::numeric_limits<double>::infinity();
  void add(double run) { seconds = std::min(seconds, run); }
};

// What a benchmark program promises, and what it measured, as a table at its end.
class Bars {
 public:
  // Google Benchmark calls a benchmark several times; the last call counts.
  void atMost(const std::string& what, double bar, double measured) {
    const auto at = std::find_if(m_rows.begin(), m_rows.end(), [&](const Row& row) { return row.what == what; });
    const Row row{what, bar, measured};
    if (at == m_rows.end())
      m_rows.push_back(row);
    else
      *at = row;
  }

  // What is promised to nobody, and said beside what is.
  void tell(const std::string& what, double measured) {
    atMost(what, std::numeric_limits<double>::infinity(), measured);
  }

  // The exit code of the program.
  int print() const {
    bool ok = true;
    std::printf("\n%-76s %9s %9s  %s\n", "what", "bar", "measured", "ok");
    for (const Row& row : m_rows) {
      const bool kept = row.measured <= row.bar;  // not so for NaN
      if (std::isinf(row.bar))
        std::printf("%-76s %9s %9.3g\n", row.what.c_str(), "", row.measured);
      else
        std::printf("%-76s %9.3g %9.3g  %s\n", row.what.c_str(), row.bar, row.measured, kept ? "yes" : "NO");
      ok &= kept;
    }
    return ok ? 0 : 1;
  }

 private:
  struct Row {
    std::string what;
    double bar;
    double measured;
  };
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

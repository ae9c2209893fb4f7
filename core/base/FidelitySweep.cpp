// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/FidelitySweep.h"

#include "base/NumberText.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

namespace handwheel {
namespace {

// Rounds the value to two digits, if the range allows it: presets follow from these values, and people read them.
double plain(const FidelitySetting& setting, double value) {
  if (setting.scale != FidelityScale::Logarithmic || value == setting.least || value == setting.largest) return value;
  char text[32];
  const char* end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, 1).ptr;
  std::from_chars(text, end, value);
  return setting.whole ? std::round(value) : value;
}

struct Measured {
  double error = 0.0;
  std::vector<double> costs;
};

FidelityRow rowOf(const FidelitySetting& setting, const FidelityCase& testCase, double value, const Measured& measured,
                  std::uint64_t seed) {
  FidelityRow row;
  row.setting = setting.id;
  row.value = value;
  row.testCase = testCase.name;
  row.error = measured.error;
  row.errorUnit = setting.error.unit;
  row.cost = median(measured.costs);
  row.costUnit = setting.cost.unit;
  row.spread = medianDeviation(measured.costs);
  row.repeats = static_cast<int>(measured.costs.size());
  row.seed = seed;
  row.truth = testCase.truth;
  return row;
}

// Quotes a field according to RFC 4180.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace

std::vector<double> sweepValues(const FidelitySetting& setting, int steps) {
  std::vector<double> values(setting.presets.begin(), setting.presets.end());
  values.push_back(setting.standard);
  const int n = setting.scale == FidelityScale::Choices ? static_cast<int>(setting.choices.size()) : std::max(steps, 2);
  for (int i = 0; i < n; ++i) {
    const double value = plain(setting, valueAt(setting, i / double(n - 1)));
    // A step that differs from a preset by rounding alone is no value of its own.
    const auto isSame = [&](double v) {
      return std::abs(scalePositionOf(setting, v) - scalePositionOf(setting, value)) < 1e-9;
    };
    if (std::none_of(values.begin(), values.end(), isSame)) values.push_back(value);
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

Result<std::vector<FidelityRow>> sweep(const FidelitySetting& setting, std::span<const FidelityCase> cases,
                                       const SweepOptions& options, Progress progress) {
  const std::vector<double> values = sweepValues(setting, options.steps);
  const int repeats = std::max(options.repeats, 1);
  const double runs = static_cast<double>(cases.size() * values.size()) * repeats;
  std::vector<FidelityRow> rows;
  double done = 0.0;
  for (const FidelityCase& testCase : cases) {
    std::vector<Measured> measured(values.size());
    for (int repeat = 0; repeat < repeats; ++repeat) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        const FidelitySample sample =
            testCase.run(values[i], options.seed, progress.part(done / runs, (done + 1) / runs));
        if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
        measured[i].error = sample.error;
        measured[i].costs.push_back(sample.cost);
        progress.set(++done / runs);
      }
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      rows.push_back(rowOf(setting, testCase, values[i], measured[i], options.seed));
    }
  }
  return rows;
}

double median(std::vector<double> values) {
  assert(!values.empty());
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double medianDeviation(const std::vector<double>& values) {
  const double centre = median(values);
  std::vector<double> deviations;
  deviations.reserve(values.size());
  for (double v : values) deviations.push_back(std::abs(v - centre));
  return median(deviations);
}

std::string csvOf(const FidelitySetting& setting, std::span<const FidelityRow> rows) {
  std::string text;
  for (const FidelityRow& r : rows) {
    text += field(r.setting) + ',' + field(textOf(setting, r.value)) + ',' + field(r.testCase) + ',' +
            shortestText(r.error) + ',' + field(r.errorUnit) + ',' + shortestText(r.cost) + ',' + field(r.costUnit) +
            ',' + shortestText(r.spread) + ',' + std::to_string(r.repeats) + ',' + std::to_string(r.seed) + ',' +
            field(r.truth) + '\n';
  }
  return text;
}

}  // namespace handwheel

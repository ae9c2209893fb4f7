// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "base/Progress.h"

#include <cstdint>
#include <functional>

namespace handwheel {

// The error and the cost measured in one run.
struct FidelitySample {
  double error = 0.0;  // infinite: the value gave no result
  double cost = 0.0;
};

// A test case on which a setting is measured. run() works with the value on input that the seed determines, so that the
// error is reproducible, and measures the cost itself (cpuMilliseconds(), bytes, counts). Its result is invalid if
// cancelled.
struct FidelityCase {
  std::string name;   // short English text: "sphere, torn along a meridian"
  std::string truth;  // the reference for the error: "closed form", "run ten times finer", ...
  std::function<FidelitySample(double value, std::uint64_t seed, Progress progress)> run;
};

// The settings of a program with their test cases. The registry is created by the app library, and passed on by
// reference.
class FidelityRegistry {
 public:
  struct Entry {
    FidelitySetting setting;
    std::vector<FidelityCase> cases;
  };

  // Adds a setting with its test cases. The setting must have a name, limits in ascending order (above zero if the
  // scale is logarithmic), and a default and presets within the limits. Its id must be new.
  void add(FidelitySetting setting, std::vector<FidelityCase> cases);
  const std::vector<Entry>& entries() const { return m_entries; }
  const Entry* find(std::string_view id) const;  // returns null if the id is unknown

 private:
  std::vector<Entry> m_entries;
};

// Parses the values chosen for settings, as users and options files write them. The text consists of the word of a
// preset ("draft", "balanced", "exact"), followed by single values, separated by commas: "draft,mesh.fill_method=fair".
// An empty text means the defaults. Errors: ReferenceMissing {"the setting", id}, NumberMalformed {text},
// ValueOutOfRange.
Result<FidelityValues> readValues(const FidelityRegistry& registry, std::string_view text);
std::string textOf(const FidelityRegistry& registry, const FidelityValues& values);

}  // namespace handwheel

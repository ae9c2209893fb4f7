// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// How the values of a setting are spread over its range.
enum class FidelityScale { Linear, Logarithmic, Choices };

enum class FidelityPreset { Draft, Balanced, Exact };
inline constexpr std::array kFidelityPresets{FidelityPreset::Draft, FidelityPreset::Balanced, FidelityPreset::Exact};
std::string_view wordFor(FidelityPreset preset);  // "Draft"; lower-case where people type it

// What the cost of a setting is taken from, where that can run out.
enum class FidelityBudget {
  None,
  Core,   // µs of CPU time in a second: of one core, which the servo loop may keep busy
  Tick,   // µs of a tick of the servo loop, between which and the next there is only the period
  Rate,   // ticks a second of the servo loop
  Frame,  // ms of a frame, as what is done between two pictures delays the second
  Wait,   // ms until something is there that the user waits for
  Fill,   // the same, of holes that are filled: settings of one piece of work, each of which makes all of it longer
};

// What is measured, in words, and its unit: "ms", "us", "MB", "mm", or what is counted ("vertices").
struct FidelityMeasure {
  std::string name;
  std::string unit;
};

// A place where speed trades with accuracy, described so that it can be chosen, measured and shown. Described by the
// room whose code reads the value.
struct FidelitySetting {
  std::string id;     // stable, for files and the command line: "mesh.near_weld"
  std::string label;  // English, translated where it is shown (context "Fidelity")
  std::string unit = {};
  FidelityScale scale = FidelityScale::Linear;
  double least = 0.0;
  double largest = 0.0;
  bool whole = false;                     // takes whole numbers only
  std::vector<std::string> choices = {};  // words; the value is the index of one
  double standard = 0.0;                  // the default: what holds where nobody chose
  std::array<double, 3> presets = {};     // by FidelityPreset; follow from resources/fidelity/ID.json
  FidelityMeasure error;
  FidelityMeasure cost;
  FidelityBudget budget = FidelityBudget::None;

  double presetValue(FidelityPreset preset) const { return presets[static_cast<std::size_t>(preset)]; }
};

// A setting of choices: range and scale follow from the words.
void setChoices(FidelitySetting& setting, std::vector<std::string> words);

// Whether the setting can take the value. Error: ValueOutOfRange {id, value, least, largest}.
Status checkValue(const FidelitySetting& setting, double value);

// The value as it is written and read everywhere: a choice's word, or the shortest digits that read back the same.
std::string textOf(const FidelitySetting& setting, double value);
// Errors: NumberMalformed {text}, ValueOutOfRange.
Result<double> valueOf(const FidelitySetting& setting, std::string_view text);

// Where a value lies on its scale: 0 at least, 1 at largest. And back, rounded where only whole numbers are taken.
double placeOf(const FidelitySetting& setting, double value);
double valueAt(const FidelitySetting& setting, double place);

// What somebody chose: a preset or the defaults, and single values that override it. A value; documents and the
// program's options hold one.
class FidelityValues {
 public:
  FidelityValues() = default;  // the defaults
  explicit FidelityValues(FidelityPreset preset) : m_preset(preset) {}

  double of(const FidelitySetting& setting) const;
  // Error: ValueOutOfRange; then nothing changes.
  Status set(const FidelitySetting& setting, double value);

  std::optional<FidelityPreset> preset() const { return m_preset; }
  const std::map<std::string, double>& overrides() const { return m_overrides; }
  bool operator==(const FidelityValues&) const = default;

 private:
  std::optional<FidelityPreset> m_preset;  // none: the defaults
  std::map<std::string, double> m_overrides;
};

}  // namespace handwheel

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

// The distribution of the values of a setting over its range.
enum class FidelityScale { Linear, Logarithmic, Choices };

// Predefined trade-offs between speed and accuracy.
enum class FidelityPreset { Draft, Balanced, Exact };
inline constexpr std::array kFidelityPresets{FidelityPreset::Draft, FidelityPreset::Balanced, FidelityPreset::Exact};
std::string_view wordFor(FidelityPreset preset);  // "Draft"; lower-case where people type it

// The limited resource that a setting consumes.
enum class FidelityBudget {
  None,
  Core,   // µs of CPU time per second, of one core, which the servo loop may keep busy
  Tick,   // µs per tick of the servo loop; a tick has only the period of the loop
  Rate,   // ticks of the servo loop per second
  Frame,  // ms per frame: work done between two frames delays the second
  Wait,   // ms until a result is available that the user waits for
  Fill,   // ms to fill the holes: the settings affect one computation, and each makes all of it longer
};

// The name and unit of a measured quantity. The unit is "ms", "us", "MB", "mm", or what is counted ("vertices").
struct FidelityMeasure {
  std::string name;
  std::string unit;
};

// A parameter that trades speed for accuracy. With its description it can be chosen, measured and shown; the
// description is in the module whose code reads the value.
struct FidelitySetting {
  std::string id;     // stable, for files and the command line: "mesh.near_weld"
  std::string label;  // English, translated where it is shown (context "Fidelity")
  std::string unit = {};
  FidelityScale scale = FidelityScale::Linear;
  double least = 0.0;
  double largest = 0.0;
  bool whole = false;                     // takes whole numbers only
  std::vector<std::string> choices = {};  // words; the value is the index of one
  double standard = 0.0;                  // the default value
  std::array<double, 3> presets = {};     // by FidelityPreset; follow from resources/fidelity/ID.json
  FidelityMeasure error;
  FidelityMeasure cost;
  FidelityBudget budget = FidelityBudget::None;

  double presetValue(FidelityPreset preset) const { return presets[static_cast<std::size_t>(preset)]; }
};

// Sets the choices of a setting. Range and scale follow from the words.
void setChoices(FidelitySetting& setting, std::vector<std::string> words);

// Checks whether a setting can take a value. Error: ValueOutOfRange {id, value, least, largest}.
Status checkValue(const FidelitySetting& setting, double value);

// Formats a value of a setting as text, as in all input and output. A choice's word, or the shortest digits that read
// back the same.
std::string textOf(const FidelitySetting& setting, double value);
// Parses the text of a value. Errors: NumberMalformed {text}, ValueOutOfRange.
Result<double> valueOf(const FidelitySetting& setting, std::string_view text);

// Converts a value to its position on the scale, and back. The position is 0 at least and 1 at largest; values are
// rounded where only whole numbers are allowed.
double scalePositionOf(const FidelitySetting& setting, double value);
double valueAt(const FidelitySetting& setting, double position);

// The values chosen for settings. A preset or the defaults, and single values that override it. A value type; documents
// and the program's options hold one.
class FidelityValues {
 public:
  FidelityValues() = default;  // the defaults
  explicit FidelityValues(FidelityPreset preset) : m_preset(preset) {}

  double of(const FidelitySetting& setting) const;
  // Overrides the value of one setting. Error: ValueOutOfRange; then nothing changes.
  Status set(const FidelitySetting& setting, double value);

  std::optional<FidelityPreset> preset() const { return m_preset; }
  const std::map<std::string, double>& overrides() const { return m_overrides; }
  bool operator==(const FidelityValues&) const = default;

 private:
  std::optional<FidelityPreset> m_preset;  // none: the defaults
  std::map<std::string, double> m_overrides;
};

}  // namespace handwheel

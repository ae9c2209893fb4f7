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
std::string_view wordFor(FidelityPreset preset);  // "Draft"; users may type it in lower case

// The limited resource that a setting consumes.
enum class FidelityBudget {
  None,
  Core,   // CPU time of one core that the servo loop may use, µs per second
  Tick,   // time within a tick of the servo loop, which has only the period of the loop, µs
  Rate,   // ticks of the servo loop per second
  Frame,  // time per frame, by which the next frame is delayed, ms
  Wait,   // time until a result that the user waits for, ms
  Fill,   // time to fill the holes, ms; each setting multiplies the time of the same computation
};

// The name and unit of a measured quantity. The unit is "ms", "us", "MB", "mm", or the name of the things counted
// ("vertices").
struct FidelityMeasure {
  std::string name;
  std::string unit;
};

// A parameter that trades speed for accuracy. By its description it can be chosen, measured and displayed. The
// description is in the module whose code reads the value.
struct FidelitySetting {
  std::string id;     // permanent id for files and the command line: "mesh.near_weld"
  std::string label;  // English text, translated in the context "Fidelity"
  std::string unit = {};
  FidelityScale scale = FidelityScale::Linear;
  double least = 0.0;
  double largest = 0.0;
  bool whole = false;                     // true: only whole numbers are allowed
  std::vector<std::string> choices = {};  // words of the choices; the value is an index of this list
  double standard = 0.0;                  // the default value
  std::array<double, 3> presets = {};     // indexed by FidelityPreset; derived from resources/fidelity/ID.json
  FidelityMeasure error;
  FidelityMeasure cost;
  FidelityBudget budget = FidelityBudget::None;

  double presetValue(FidelityPreset preset) const { return presets[static_cast<std::size_t>(preset)]; }
};

// Sets the choices of a setting. Its range and scale follow from the words.
void setChoices(FidelitySetting& setting, std::vector<std::string> words);

// Checks whether a setting can have a value. Error: ValueOutOfRange {id, value, least, largest}.
Status checkValue(const FidelitySetting& setting, double value);

// Formats a value of a setting as text, as in all input and output. The text is the word of a choice, or the fewest
// digits from which the value can be restored.
std::string textOf(const FidelitySetting& setting, double value);
// Parses the text of a value. Errors: NumberMalformed {text}, ValueOutOfRange.
Result<double> valueOf(const FidelitySetting& setting, std::string_view text);

// Convert between a value and its position on the scale of a setting. The position is 0 at least and 1 at largest. The
// value is rounded if only whole numbers are allowed.
double scalePositionOf(const FidelitySetting& setting, double value);
double valueAt(const FidelitySetting& setting, double position);

// The values chosen for settings. They are those of a preset, or the defaults, with overrides for single settings.
// FidelityValues is a value type; it is stored in documents and in the options of the program.
class FidelityValues {
 public:
  FidelityValues() = default;  // the defaults
  explicit FidelityValues(FidelityPreset preset) : m_preset(preset) {}

  double of(const FidelitySetting& setting) const;
  // Overrides the value of one setting. Error: ValueOutOfRange, in which case nothing changes.
  Status set(const FidelitySetting& setting, double value);

  std::optional<FidelityPreset> preset() const { return m_preset; }
  const std::map<std::string, double>& overrides() const { return m_overrides; }
  bool operator==(const FidelityValues&) const = default;

 private:
  std::optional<FidelityPreset> m_preset;  // nullopt: the defaults
  std::map<std::string, double> m_overrides;
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/measure/IsoTolerance.h"

#include <array>
#include <charconv>
#include <cstddef>

namespace handwheel {

namespace {

constexpr std::size_t kSizeSteps = 8;
using Row = std::array<int, kSizeSteps>;  // micrometres

// The last size of each step, mm.
constexpr std::array<double, kSizeSteps> kStepEnds = {3, 6, 10, 18, 30, 50, 80, kLargestToleratedSize};

// Table 1 of ISO 286-1.
constexpr int kFirstGrade = 5;
constexpr std::array<Row, 8> kGrades = {{{4, 5, 6, 8, 9, 11, 13, 15},
                                         {6, 8, 9, 11, 13, 16, 19, 22},
                                         {10, 12, 15, 18, 21, 25, 30, 35},
                                         {14, 18, 22, 27, 33, 39, 46, 54},
                                         {25, 30, 36, 43, 52, 62, 74, 87},
                                         {40, 48, 58, 70, 84, 100, 120, 140},
                                         {60, 75, 90, 110, 130, 160, 190, 220},
                                         {100, 120, 150, 180, 210, 250, 300, 350}}};

// The fundamental deviation of shafts, ISO 286-1, tables 4 and 5: the upper deviation of those below the nominal size,
// the lower deviation of those above it.
struct Fundamental {
  std::string_view letter;
  bool isUpper;
  Row deviation;
};
constexpr std::array<Fundamental, 9> kFundamentals = {{
    {"d", true, {-20, -30, -40, -50, -65, -80, -100, -120}},
    {"e", true, {-14, -20, -25, -32, -40, -50, -60, -72}},
    {"f", true, {-6, -10, -13, -16, -20, -25, -30, -36}},
    {"g", true, {-2, -4, -5, -6, -7, -9, -10, -12}},
    {"h", true, {0, 0, 0, 0, 0, 0, 0, 0}},
    {"k", false, {0, 1, 1, 1, 2, 2, 2, 3}},  // for grades up to 7; above them 0
    {"m", false, {2, 4, 6, 7, 8, 9, 11, 13}},
    {"n", false, {4, 8, 10, 12, 15, 17, 20, 23}},
    {"p", false, {6, 12, 15, 18, 22, 26, 32, 37}},
}};
constexpr int kLastGradeOfK = 7;

constexpr double kMicrometre = 1e-3;  // mm

std::optional<std::size_t> stepOf(double nominal) {
  if (!(nominal > 0.0)) return std::nullopt;
  for (std::size_t i = 0; i < kSizeSteps; ++i) {
    if (nominal <= kStepEnds[i]) return i;
  }
  return std::nullopt;
}

bool isLower(char c) {
  return c >= 'a' && c <= 'z';
}

bool isUpper(char c) {
  return c >= 'A' && c <= 'Z';
}

std::optional<SizeDeviations> shaft(std::string_view letter, int grade, std::size_t step, double width) {
  for (const Fundamental& each : kFundamentals) {
    if (each.letter != letter) continue;
    const bool isNone = letter == "k" && grade > kLastGradeOfK;
    const double deviation = isNone ? 0.0 : kMicrometre * each.deviation[step];
    if (each.isUpper) return SizeDeviations{deviation - width, deviation};
    return SizeDeviations{deviation, deviation + width};
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> standardTolerance(double nominal, int grade) {
  const auto step = stepOf(nominal);
  const int row = grade - kFirstGrade;
  if (!step || row < 0 || row >= static_cast<int>(kGrades.size())) return std::nullopt;
  return kMicrometre * kGrades[static_cast<std::size_t>(row)][*step];
}

std::optional<SizeDeviations> isoDeviations(double nominal, std::string_view toleranceClass) {
  std::size_t letters = 0;
  while (letters < toleranceClass.size() && (isLower(toleranceClass[letters]) || isUpper(toleranceClass[letters])))
    ++letters;
  const std::string_view digits = toleranceClass.substr(letters);
  if (letters == 0 || letters > 2 || digits.empty() || digits.size() > 2) return std::nullopt;
  int grade = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), grade);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  const auto width = standardTolerance(nominal, grade);
  if (!width) return std::nullopt;

  char lowered[2] = {};
  std::size_t upperCount = 0;
  for (std::size_t i = 0; i < letters; ++i) {
    const char c = toleranceClass[i];
    upperCount += isUpper(c) ? 1 : 0;
    lowered[i] = isUpper(c) ? static_cast<char>(c - 'A' + 'a') : c;
  }
  if (upperCount != 0 && upperCount != letters) return std::nullopt;
  const std::string_view letter(lowered, letters);
  if (letter == "js" || letter == "it") return SizeDeviations{-0.5 * *width, 0.5 * *width};
  const auto ofShaft = shaft(letter, grade, *stepOf(nominal), *width);
  if (upperCount == 0 || !ofShaft) return ofShaft;
  // Holes below the nominal size are left out: they have corrections that depend on the grade.
  if (letter > "h") return std::nullopt;
  return SizeDeviations{-ofShaft->upper, -ofShaft->lower};
}

}  // namespace handwheel

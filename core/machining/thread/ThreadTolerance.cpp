// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/thread/ThreadTolerance.h"

#include "base/NumberText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace handwheel {

namespace {

constexpr double kOfTable = 1e-3;     // mm
constexpr double kSameNumber = 1e-9;  // mm, of the numbers of the tables
constexpr double kOnDrawing = 1e-3;   // mm, of nominal sizes on drawings

// The preferred numbers R40, in which the tolerances of ISO 965-1 are stepped.
constexpr std::array kPreferred = {100, 106, 112, 118, 125, 132, 140, 150, 160, 170, 180, 190, 200, 212,
                                   224, 236, 250, 265, 280, 300, 315, 335, 355, 375, 400, 425, 450, 475,
                                   500, 530, 560, 600, 630, 670, 710, 750, 800, 850, 900, 950};

// Returns the preferred number so many steps beyond another one, µm.
double stepsBeyond(double number, int steps) {
  const int count = static_cast<int>(kPreferred.size());
  int decade = 0;
  while (number >= 1000.0) number /= 10.0, ++decade;
  while (number < 99.5) number *= 10.0, --decade;
  const auto nearest = std::min_element(kPreferred.begin(), kPreferred.end(),
                                        [&](int a, int b) { return std::abs(a - number) < std::abs(b - number); });
  const int at = static_cast<int>(nearest - kPreferred.begin()) + steps;
  const int wrapped = ((at % count) + count) % count;
  decade += (at - wrapped) / count;
  return std::round(kPreferred[static_cast<std::size_t>(wrapped)] * std::pow(10.0, decade));
}

// By the pitch (mm), in µm: the tolerances of the crests for grade 6, which are those of the major diameter of external
// threads and of the minor diameter of internal ones (0: grades below 6 only), and the fundamental deviations of the
// positions e, f and g (0: none). ISO 965-1, tables 1, 3 and 4.
struct PitchRow {
  double pitch, external, internal, e, f, g;
};
constexpr std::array<PitchRow, 25> kPitches = {
    {{0.2, 56, 0, 0, 32, 17},        {0.25, 67, 71, 0, 33, 18},    {0.3, 75, 85, 0, 33, 18},
     {0.35, 85, 100, 0, 34, 19},     {0.4, 95, 112, 0, 34, 19},    {0.45, 100, 125, 0, 35, 20},
     {0.5, 106, 140, 50, 36, 20},    {0.6, 125, 160, 53, 36, 21},  {0.7, 140, 180, 56, 38, 22},
     {0.75, 140, 190, 56, 38, 22},   {0.8, 150, 200, 60, 38, 24},  {1.0, 180, 236, 60, 40, 26},
     {1.25, 212, 265, 63, 42, 28},   {1.5, 236, 300, 67, 45, 32},  {1.75, 265, 335, 71, 48, 34},
     {2.0, 280, 375, 71, 52, 38},    {2.5, 335, 450, 80, 58, 42},  {3.0, 375, 500, 85, 63, 48},
     {3.5, 425, 560, 90, 70, 53},    {4.0, 475, 600, 95, 75, 60},  {4.5, 500, 670, 100, 80, 63},
     {5.0, 530, 710, 106, 85, 71},   {5.5, 560, 750, 112, 90, 75}, {6.0, 600, 800, 118, 95, 80},
     {8.0, 710, 1000, 140, 118, 100}}};

const PitchRow* rowOf(double pitch) {
  const auto row = std::find_if(kPitches.begin(), kPitches.end(),
                                [&](const PitchRow& each) { return std::abs(each.pitch - pitch) < kSameNumber; });
  return row == kPitches.end() ? nullptr : &*row;
}

// Tolerances of the pitch diameter of external threads for grade 6, µm, by the range of nominal diameters (mm, above
// the first and up to the second) and the pitch. ISO 965-1, table 6.
struct PitchDiameterRow {
  double above, upTo, pitch, tolerance;
};
constexpr std::array<PitchDiameterRow, 43> kPitchDiameters = {
    {{0.99, 1.4, 0.2, 48},    {0.99, 1.4, 0.25, 53},   {0.99, 1.4, 0.3, 56},    {1.4, 2.8, 0.2, 50},
     {1.4, 2.8, 0.25, 56},    {1.4, 2.8, 0.35, 63},    {1.4, 2.8, 0.4, 67},     {1.4, 2.8, 0.45, 71},
     {2.8, 5.6, 0.35, 67},    {2.8, 5.6, 0.5, 75},     {2.8, 5.6, 0.6, 85},     {2.8, 5.6, 0.7, 90},
     {2.8, 5.6, 0.75, 90},    {2.8, 5.6, 0.8, 95},     {5.6, 11.2, 0.75, 100},  {5.6, 11.2, 1.0, 112},
     {5.6, 11.2, 1.25, 118},  {5.6, 11.2, 1.5, 132},   {11.2, 22.4, 1.0, 118},  {11.2, 22.4, 1.25, 132},
     {11.2, 22.4, 1.5, 140},  {11.2, 22.4, 1.75, 150}, {11.2, 22.4, 2.0, 160},  {11.2, 22.4, 2.5, 170},
     {22.4, 45.0, 1.0, 125},  {22.4, 45.0, 1.5, 150},  {22.4, 45.0, 2.0, 170},  {22.4, 45.0, 3.0, 200},
     {22.4, 45.0, 3.5, 212},  {22.4, 45.0, 4.0, 224},  {22.4, 45.0, 4.5, 236},  {45.0, 90.0, 1.5, 160},
     {45.0, 90.0, 2.0, 180},  {45.0, 90.0, 3.0, 212},  {45.0, 90.0, 4.0, 236},  {45.0, 90.0, 5.0, 250},
     {45.0, 90.0, 5.5, 265},  {45.0, 90.0, 6.0, 280},  {90.0, 180.0, 2.0, 190}, {90.0, 180.0, 3.0, 224},
     {90.0, 180.0, 4.0, 250}, {90.0, 180.0, 6.0, 300}, {90.0, 180.0, 8.0, 335}}};

// The coarse threads of ISO 261, mm: nominal diameter and pitch.
constexpr std::array<std::array<double, 2>, 43> kCoarse = {
    {{1.0, 0.25}, {1.1, 0.25}, {1.2, 0.25}, {1.4, 0.3},  {1.6, 0.35},  {1.8, 0.35}, {2.0, 0.4},  {2.2, 0.45},
     {2.5, 0.45}, {3.0, 0.5},  {3.5, 0.6},  {4.0, 0.7},  {4.5, 0.75},  {5.0, 0.8},  {6.0, 1.0},  {7.0, 1.0},
     {8.0, 1.25}, {9.0, 1.25}, {10.0, 1.5}, {11.0, 1.5}, {12.0, 1.75}, {14.0, 2.0}, {16.0, 2.0}, {18.0, 2.5},
     {20.0, 2.5}, {22.0, 2.5}, {24.0, 3.0}, {27.0, 3.0}, {30.0, 3.5},  {33.0, 3.5}, {36.0, 4.0}, {39.0, 4.0},
     {42.0, 4.5}, {45.0, 4.5}, {48.0, 5.0}, {52.0, 5.0}, {56.0, 5.5},  {60.0, 5.5}, {64.0, 6.0}, {68.0, 6.0},
     {72.0, 6.0}, {76.0, 6.0}, {80.0, 6.0}}};

// The steps of R40 between grade 6 and others: a factor of 1.25 is four.
constexpr int kStepsOfGrade = 4, kStepsOfNut = 5;

struct ThreadGrades {
  int pitchDiameter = 0, crest = 0;
  char position = 'h';  // position of both
};

struct ParsedThread {
  double diameter = 0.0, pitch = 0.0;
  ThreadGrades grades;
  std::string threadClass;
};

bool isThreadPosition(char c) {
  return std::string_view("efghGH").find(c) != std::string_view::npos;
}

// Reads "6g" or "5g6g".
std::optional<ThreadGrades> threadGradesIn(std::string_view text) {
  const auto isGrade = [&](std::size_t at) {
    return text[at] >= '3' && text[at] <= '9' && isThreadPosition(text[at + 1]);
  };
  if ((text.size() != 2 && text.size() != 4) || !isGrade(0) || !isGrade(text.size() - 2)) return std::nullopt;
  if (text[1] != text[text.size() - 1]) return std::nullopt;
  return ThreadGrades{text[0] - '0', text[text.size() - 2] - '0', text[1]};
}

// Returns the fundamental deviation (mm), upwards for internal threads and downwards for external ones.
std::optional<double> fundamentalDeviation(char position, double pitch) {
  if (position == 'h' || position == 'H') return 0.0;
  const PitchRow* const row = rowOf(pitch);
  const double deviation = !row ? 0.0 : position == 'e' ? row->e : position == 'f' ? row->f : row->g;
  return deviation > 0.0 ? std::optional(kOfTable * deviation) : std::nullopt;
}

std::optional<double> toleranceOfCrest(double pitch, int grade, bool isInner) {
  const PitchRow* const row = rowOf(pitch);
  const bool isGrade = isInner ? grade >= 4 && grade <= 8 : grade == 4 || grade == 6 || grade == 8;
  if (!row || !isGrade || (isInner && row->internal == 0.0)) return std::nullopt;
  return kOfTable * stepsBeyond(isInner ? row->internal : row->external, kStepsOfGrade * (grade - 6));
}

std::optional<double> toleranceOfPitchDiameter(double diameter, double pitch, int grade, bool isInner) {
  const auto row = std::find_if(kPitchDiameters.begin(), kPitchDiameters.end(), [&](const PitchDiameterRow& each) {
    return diameter > each.above && diameter <= each.upTo && std::abs(each.pitch - pitch) < kSameNumber;
  });
  if (row == kPitchDiameters.end() || (isInner && (grade < 4 || grade > 8))) return std::nullopt;
  return kOfTable * stepsBeyond(row->tolerance, kStepsOfGrade * (grade - 6) + (isInner ? kStepsOfNut : 0));
}

std::optional<double> coarsePitch(double diameter) {
  const auto found = std::find_if(kCoarse.begin(), kCoarse.end(),
                                  [&](const auto& each) { return std::abs(each[0] - diameter) < kSameNumber; });
  return found == kCoarse.end() ? std::nullopt : std::optional((*found)[1]);
}

std::optional<double> sizeIn(std::string_view text) {
  double number = 0.0;
  ErrorCode why;
  if (!parseDecimal(text, number, why) || !std::isfinite(number) || !(number > 0.0)) return std::nullopt;
  return number;
}

// Returns a text without blanks, with "x" for the sign between diameter and pitch.
std::string withoutBlanks(std::string_view text) {
  static constexpr std::string_view kTimes = "×", kDash = "–";
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (text.substr(i).starts_with(kTimes)) {
      result += 'x', i += kTimes.size();
    } else if (text.substr(i).starts_with(kDash)) {
      result += '-', i += kDash.size();
    } else {
      if (text[i] != ' ') result += text[i] == '*' || text[i] == 'X' ? 'x' : text[i];
      ++i;
    }
  }
  return result;
}

std::optional<ParsedThread> parsedThread(std::string_view designation) {
  std::string text = withoutBlanks(designation);
  if (text.ends_with("-LH")) text.erase(text.size() - 3);
  const std::size_t dash = text.rfind('-');
  if (!text.starts_with('M') || dash == text.npos) return std::nullopt;
  const std::string size = text.substr(1, dash - 1);
  ParsedThread thread;
  thread.threadClass = text.substr(dash + 1);
  const auto grades = threadGradesIn(thread.threadClass);
  const std::size_t times = size.find('x');
  const auto diameter = sizeIn(std::string_view(size).substr(0, times));
  if (!grades || !diameter) return std::nullopt;
  const auto pitch = times == size.npos ? coarsePitch(*diameter) : sizeIn(std::string_view(size).substr(times + 1));
  if (!pitch) return std::nullopt;
  thread.diameter = *diameter;
  thread.pitch = *pitch;
  thread.grades = *grades;
  return thread;
}

double toMicrometre(double mm) {
  return std::round(mm / kOfTable) * kOfTable;
}

std::optional<ThreadTolerance> limitsOf(const ParsedThread& thread) {
  const double d = thread.diameter, p = thread.pitch, height = 0.5 * std::numbers::sqrt3 * p;
  ThreadTolerance t;
  t.isInner = thread.grades.position == 'G' || thread.grades.position == 'H';
  const auto crest = toleranceOfCrest(p, thread.grades.crest, t.isInner);
  const auto flank = toleranceOfPitchDiameter(d, p, thread.grades.pitchDiameter, t.isInner);
  const auto deviation = fundamentalDeviation(thread.grades.position, p);
  if (!crest || !flank || !deviation) return std::nullopt;
  const double shift = *deviation;
  t.grade = thread.threadClass;
  t.designation = "M" + roundedText(d) + "×" + roundedText(p) + "-" + thread.threadClass;
  const double d2 = toMicrometre(d - 0.75 * height), d1 = toMicrometre(d - 1.25 * height);
  const double error = toMicrometre(0.5 * *flank * std::tan(std::numbers::pi / 6.0));
  t.pitch = {p, p - error, p + error};
  if (t.isInner) {
    t.major = {d, d + shift, {}};
    t.pitchDiameter = {d2, d2 + shift, d2 + shift + *flank};
    t.minor = {d1, d1 + shift, d1 + shift + *crest};
    return t;
  }
  const double d3 = toMicrometre(d2 - 2.0 / 3.0 * height);
  t.major = {d, d - shift - *crest, d - shift};
  t.pitchDiameter = {d2, d2 - shift - *flank, d2 - shift};
  t.minor = {d3, toMicrometre(d2 - shift - *flank - 0.75 * height), d3 - shift};
  return t;
}

}  // namespace

std::optional<ThreadTolerance> threadTolerance(std::string_view designation) {
  const auto thread = parsedThread(designation);
  return thread ? limitsOf(*thread) : std::nullopt;
}

std::string_view threadClassIn(std::string_view text) {
  const std::string_view first = text.substr(0, text.find(' '));
  return threadGradesIn(first) ? first : std::string_view();
}

std::optional<ThreadTolerance> coarseThreadWith(ThreadDiameter which, double nominal, std::string_view threadClass) {
  for (const auto& [diameter, pitch] : kCoarse) {
    const auto thread = threadTolerance("M" + roundedText(diameter) + "-" + std::string(threadClass));
    if (!thread) continue;
    const ToleratedSize& size = which == ThreadDiameter::Major   ? thread->major
                                : which == ThreadDiameter::Pitch ? thread->pitchDiameter
                                                                 : thread->minor;
    if (std::abs(size.nominal - nominal) <= kOnDrawing) return thread;
  }
  return std::nullopt;
}

}  // namespace handwheel

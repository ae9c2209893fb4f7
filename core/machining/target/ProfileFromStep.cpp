// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/ProfileFromStep.h"

#include "base/NumberText.h"
#include "machining/target/CurveFit.h"
#include "machining/target/OutlineJoining.h"
#include "machining/target/TargetErrors.h"
#include "process/IsolatedReader.h"
#include "xml/XmlNumbers.h"

#include <array>
#include <charconv>
#include <cmath>

namespace handwheel {

namespace {

constexpr const char* kLibrary = "Open CASCADE";
constexpr double kTolerance = 1e-4;  // mm, tolerance of arcs that replace other curves
constexpr double kEdgeGap = 2e-3;    // mm: faces meet within the tolerance of their file
constexpr std::size_t kMostStepPoints = 1'000'000;
constexpr std::array kKinds{"plane", "cylinder", "cone", "sphere", "torus", "spline", "extrusion", "surface"};

Error nonsense() {
  return {ErrorCode::LibraryFailed, {kLibrary, "its answer is not understood"}, {}, {}};
}

// Reads words and numbers of the answer.
class Answer {
 public:
  explicit Answer(std::string_view text) : m_rest(text) {}

  bool isAtEnd() const { return m_rest.find_first_not_of(" \n") == m_rest.npos; }
  std::string_view word() { return takeWord(m_rest); }
  bool number(double& value) {
    ErrorCode why = ErrorCode::NumberMalformed;
    const std::string_view text = word();
    return !text.empty() && parseDecimal(text, value, why) && std::abs(value) <= TargetProfile::kLargestCoordinate;
  }
  bool count(std::size_t& value) {
    const std::string_view text = word();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
  }
  bool points(std::vector<ProfilePoint>& all, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      double r = 0.0, z = 0.0;
      if (!number(r) || !number(z)) return false;
      all.emplace_back(r, z);
    }
    return true;
  }

 private:
  std::string_view m_rest;
};

Error notTurned(Answer& answer) {
  std::size_t face = 0;
  if (!answer.count(face)) return nonsense();
  const std::string_view given = answer.word();
  std::string kind = "surface";
  for (const char* known : kKinds)
    if (given == known) kind = known;
  Error error{TargetError::NotTurned, {std::to_string(face), kind}, {}, {}};
  for (int i = 0; i < 3; ++i) {
    double value = 0.0;
    if (!answer.number(value)) return nonsense();
    error.arguments.push_back(shownText(value));
  }
  return error;
}

// Adds the segments of one line; returns false if it is not understood.
bool addMeridian(Answer& answer, std::size_t& left, std::vector<ProfileSegment>& all) {
  const std::string_view word = answer.word();
  std::size_t count = word == "line" ? 2 : word == "arc" ? 3 : 0;
  if (word == "points" && !answer.count(count)) return false;
  if (count < 2 || count > left) return false;
  left -= count;
  std::vector<ProfilePoint> points;
  if (!answer.points(points, count)) return false;
  if (word == "points") {
    const auto fitted = fitSegments(points, kTolerance);
    all.insert(all.end(), fitted.begin(), fitted.end());
  } else if (word == "line") {
    all.push_back({points[0], points[1], 0.0});
  } else if (const auto arc = arcThrough(points[0], points[1], points[2])) {
    all.push_back(*arc);
  }
  return true;
}

// Pieces on the axis are left out.
Result<TargetProfile> joined(std::vector<ProfileSegment> all, Progress progress) {
  for (ProfileSegment& s : all) {
    for (ProfilePoint* p : {&s.from, &s.to})
      if (std::abs(p->x()) <= kEdgeGap) p->x() = 0.0;
  }
  std::erase_if(all, [](const ProfileSegment& s) { return !s.isArc() && s.from.x() == 0.0 && s.to.x() == 0.0; });
  Result<std::vector<ProfileSegment>> outline = joinedOutline(all, kEdgeGap, progress.part(0.0, 0.5));
  if (!outline) return outline.error();
  return TargetProfile::make(std::move(outline.value()), progress.part(0.5, 1.0));
}

}  // namespace

Result<ProfileFromStep> profileFromStepAnswer(std::string_view text, Progress progress) {
  Answer answer(text);
  const std::string_view word = answer.word();
  std::size_t count = 0;
  if (word == "no-axis") return Error{TargetError::NoAxis, {}, {}, {}};
  if (word == "face") return notTurned(answer);
  if (word == "solids" && answer.count(count)) return Error{TargetError::NotOneSolid, {std::to_string(count)}, {}, {}};
  if (word != "turned" || !answer.count(count)) return nonsense();
  std::vector<ProfileSegment> all;
  std::size_t left = kMostStepPoints;
  while (!answer.isAtEnd()) {
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    if (!addMeridian(answer, left, all)) return nonsense();
  }
  Result<TargetProfile> target = joined(std::move(all), progress);
  if (!target) return target.error();
  return ProfileFromStep{std::move(target.value()), count};
}

Result<ProfileFromStep> readProfileFromStep(std::string_view bytes, UnturnedFaces others, Progress progress) {
  const std::string option = others == UnturnedFaces::Ignore ? "turned-lenient" : "turned";
  IsolatedReader reader{readerProgram("step"), kLibrary, {}};
  reader.limits.mostOutput = std::size_t{64} << 20;
  const Result<std::string> answer = readIsolated(reader, {option}, bytes, progress.part(0.0, 0.95));
  if (!answer) return answer.error();
  return profileFromStepAnswer(*answer, progress.part(0.95, 1.0));
}

}  // namespace handwheel

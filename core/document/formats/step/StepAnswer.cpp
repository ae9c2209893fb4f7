// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/step/StepAnswer.h"

#include "base/NumberText.h"
#include "document/formats/ply/PlyReader.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::size_t kLongestLine = 256;  // bytes, and those of the unit in it:
constexpr std::size_t kLongestUnit = 32;
constexpr std::string_view kOwnUnit = "millimetre";  // name in the library

// The first line of the answer of plugins/formats/step.
struct StepSummary {
  // numbers of: parts in the file, parts read, solids, open shells, faces, lost faces
  std::array<std::size_t, 6> counts{};
  double chord = 0.0;  // mm
  std::string unit;

  std::size_t parts() const { return counts[0]; }
  std::size_t partsRead() const { return counts[1]; }
  std::size_t solids() const { return counts[2]; }
  std::size_t openShells() const { return counts[3]; }
  std::size_t faces() const { return counts[4]; }
  std::size_t facesLost() const { return counts[5]; }
};

// Parses the next word of a line as a number. Returns false if it is none.
template <class Number>
bool takeNumber(std::string_view& line, Number& number) {
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
  if (error != std::errc() || end == line.data() + line.size() || *end != ' ') return false;
  line.remove_prefix(static_cast<std::size_t>(end + 1 - line.data()));
  return true;
}

std::optional<StepSummary> summaryOf(std::string_view line) {
  StepSummary summary;
  for (std::size_t& count : summary.counts) {
    if (!takeNumber(line, count)) return {};
  }
  if (!takeNumber(line, summary.chord) || !(summary.chord > 0.0 && std::isfinite(summary.chord))) return {};
  if (line.size() > kLongestUnit) return {};
  if (summary.partsRead() > summary.parts() || summary.facesLost() > summary.faces()) return {};
  const auto isPrintable = [](char c) { return c >= ' ' && c <= '~'; };
  if (!std::all_of(line.begin(), line.end(), isPrintable)) return {};
  summary.unit = line.empty() ? "unknown" : line;
  return summary;
}

// Returns the unreadable parts of the file.
std::vector<Error> damageOf(const StepSummary& summary) {
  std::vector<Error> damage;
  const auto compare = [&](const char* what, std::size_t expected, std::size_t found) {
    if (found == expected) return;
    damage.push_back({ErrorCode::CountMismatch, {what, std::to_string(expected), std::to_string(found)}, {}, {}});
  };
  compare("parts that can be read", summary.parts(), summary.partsRead());
  compare("faces that can be triangulated", summary.faces(), summary.faces() - summary.facesLost());
  return damage;
}

std::vector<Note> notesOn(const StepSummary& summary) {
  constexpr int kDigits = 3;
  std::vector<Note> notes{
      {QT_TRANSLATE_NOOP("Note",
                         "A STEP file contains exact surfaces and no mesh: its faces (%1) were triangulated; the "
                         "triangles are at most about %2 mm from them."),
       {std::to_string(summary.faces() - summary.facesLost()), roundedText(summary.chord, kDigits)}},
      {QT_TRANSLATE_NOOP("Note", "Solids: %1. Surfaces that belong to none: %2."),
       {std::to_string(summary.solids()), std::to_string(summary.openShells())}}};
  if (summary.unit != kOwnUnit)
    notes.push_back({QT_TRANSLATE_NOOP("Note", "Its lengths (%1) were converted to millimetres."), {summary.unit}});
  return notes;
}

}  // namespace

Result<MeshFile> meshIn(std::string_view answer, const ReadOptions& options, Progress progress) {
  const Error senseless{ErrorCode::LibraryFailed, {kStepLibrary, "its answer is not valid"}, {}, {}};
  const std::size_t end = answer.substr(0, kLongestLine).find('\n');
  if (end == std::string_view::npos) return senseless;
  const std::optional<StepSummary> summary = summaryOf(answer.substr(0, end));
  if (!summary) return senseless;
  std::vector<Error> damage = damageOf(*summary);
  if (!options.partial && !damage.empty()) return damage.front();
  Result<MeshFile> file = readPly(answer.substr(end + 1), {}, progress);
  if (!file && (file.error().code == ErrorCode::Cancelled || file.error().code == ErrorCode::OutOfMemory)) return file;
  if (!file || !file->damage.empty()) return senseless;
  file->damage = std::move(damage);
  file->lost = {LostAttribute::ExactSurfaces};
  file->hasUnit = true;
  file->notes = notesOn(*summary);
  return file;
}

}  // namespace handwheel

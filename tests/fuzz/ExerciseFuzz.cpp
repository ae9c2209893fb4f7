// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/JsonText.h"
#include "document/exercise/ExerciseKind.h"
#include "document/volume/exercise/DrillingSubject.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/exercise/DescribedPasses.h"
#include "document/workpiece/exercise/TurningSubject.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is the description of an
// exercise. The passes of its solution are cut from a small bar of few samples, so that an input takes milliseconds.

namespace {

using namespace handwheel;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "ExerciseFuzz: %s\n", what);
  std::abort();
}

const ExerciseKind& turningExercises() {
  static const ExerciseKind kKind = [] {
    std::vector<std::unique_ptr<ExerciseSubject>> subjects;
    subjects.push_back(std::make_unique<TurningSubject>());
    subjects.push_back(std::make_unique<DrillingSubject>());
    return ExerciseKind(std::move(subjects));
  }();
  return kKind;
}

// Writes an exercise that was read, and reads it again as the same.
void judgeDescription(const nlohmann::json& description) {
  const Result<SnapshotPointer> made = turningExercises().fromDescription(description, {});
  if (!made) return;
  const auto described = ExerciseKind::description(static_cast<const ExerciseSnapshot&>(**made));
  const Result<SnapshotPointer> again = turningExercises().fromDescription(described, {});
  require(again.hasValue(), "what was written is refused");
  require(ExerciseKind::description(static_cast<const ExerciseSnapshot&>(**again)) == described, "it is another one");
}

void judgePasses(const nlohmann::json& solution) {
  constexpr double kSpacing = 1.0, kSpindle = 600.0;  // mm, r/min
  WorkpieceSnapshot work;
  work.stock = {40.0, 100.0, 0.0};
  work.mesh = std::make_shared<const StockMesh>(work.stock, work.chord);
  Result<std::vector<TurningPass>> passes = describedPasses(solution, kSpindle, partOf(work, kSpacing).profile);
  if (!passes) return;
  for (const TurningPass& pass : *passes) {
    require(!pass.path.empty() && pass.times.size() == pass.path.size(), "points without times");
    for (std::size_t i = 0; i < pass.path.size(); ++i)
      require(pass.path[i].allFinite() && std::isfinite(pass.times[i]), "a point that is none");
  }
  const bool isNone = passes->empty();
  const auto part = withPasses(work, std::move(*passes), kSpacing);
  require(isNone == !part, "no part");
  if (!part) return;
  require(part->finish.size() == part->profile.size(), "a finish of another part");
  require(part->volume() <= work.stock.volume() * (1.0 + 1e-9), "a part that grew");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Result<nlohmann::json> read = parseJson({reinterpret_cast<const char*>(data), size}, "exercise");
  if (!read) return 0;
  nlohmann::json description = *read;
  if (description.is_object() && description.contains("solution")) {
    judgePasses(description["solution"]);
    description.erase("solution");
  }
  judgeDescription(description);
  return 0;
}

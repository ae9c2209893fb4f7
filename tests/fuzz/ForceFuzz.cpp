// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/ForceCsv.h"
#include "machining/force/training/ForceTraining.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is a model of forces, or a
// table of cuts.

namespace {

using namespace handwheel;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "ForceFuzz: %s\n", what);
  std::abort();
}

// Checks for any file: finite forces everywhere, and the same model from its own text.
void judgeModel(const TrainedForceModel& model) {
  constexpr double kValues[] = {0.0, 1e-300, 1e-9, 0.1, 1.0, 100.0, 1e9, 1e300, -1.0, NAN, INFINITY};
  for (const double d : kValues) {
    for (const double f : kValues) {
      const CutForces forces = model.at({d, f, f});
      require(std::isfinite(forces.norm()) && forces.cutting >= 0.0, "a force that is none");
    }
  }
  const std::string text = toJson(model);
  const auto again = forceModelFromJson(text);
  require(again && toJson(*again) == text, "another model after writing");
}

void judgeTable(const ForceSamples& table) {
  require(table.samples.size() <= table.rows && table.rows <= kMostForceRows, "more cuts than rows");
  for (const ForceSample& sample : table.samples)
    require(sample.cut.depth > 0.0 && sample.cut.feed > 0.0 && sample.cut.speed > 0.0 && sample.force > 0.0 &&
                std::isfinite(sample.cut.depth + sample.cut.feed + sample.cut.speed + sample.force),
            "a cut that is none");
  TrainingOptions options;
  options.epochs = 3;
  const auto training = trainForceModel(table, options, {});
  if (training) judgeModel(training->model);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto model = forceModelFromJson(text)) judgeModel(*model);
  if (const auto table = forceSamplesFromCsv(text, size % 2 == 0 ? 0.0 : 50.0)) judgeTable(*table);
  return 0;
}

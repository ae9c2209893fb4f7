// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "fidelity/Cases.h"
#include "machining/force/ForceFidelity.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr const char* kTaughtSteel = "medium-carbon-steel";

struct TabledForce {
  CutConditions cut;
  double force = 0.0;  // N
};

// The feeds of a table of specific forces, at 2 mm and 120 m/min.
std::vector<TabledForce> forcesOf(const WorkMaterial& material) {
  std::vector<TabledForce> forces;
  for (const auto& [feed, kc] : material.measured) forces.push_back({{2.0, feed, 120.0}, kc * 2.0 * feed});
  return forces;
}

// The values of six sources for 2 mm, 0.2 mm and 150 m/min in medium carbon steel: a handbook, four makers of tools and
// a textbook. Their mean is the best available; none is right alone.
std::vector<TabledForce> meanOfSources() {
  return {{{2.0, 0.2, 150.0}, (846.0 + 855.0 + 824.0 + 957.0 + 1080.0 + 640.0) / 6.0}};
}

FidelityCase caseOf(const std::string& name, const std::string& truth, const std::string& material,
                    const std::vector<TabledForce>& forces) {
  return {name, truth, [material, forces](double value, std::uint64_t, Progress) {
            constexpr int kForces = 20'000;
            const WorkMaterials& materials = WorkMaterials::standard();
            const auto model =
                forceModelFor(static_cast<ForceLaw>(static_cast<int>(value)), *materials.find(material), {});
            FidelitySample sample;
            for (const TabledForce& tabled : forces) {
              const double share = model->at(tabled.cut).cutting / tabled.force - 1.0;
              sample.error = std::max(sample.error, 100.0 * std::abs(share));
            }
            volatile double kept = 0.0;  // so that the calls are made
            sample.cost = cpuMilliseconds([&] {
                            for (int i = 0; i < kForces; ++i)
                              kept = kept + model->at({0.2 + 1e-4 * i, 0.2, 120.0}).cutting;
                          }) *
                          1e3 / kForces;
            return sample;
          }};
}

}  // namespace

std::vector<FidelityCase> forceModelCases() {
  const WorkMaterials& materials = WorkMaterials::standard();
  std::vector<FidelityCase> cases{
      caseOf("medium carbon steel, six sources", "mean of six published figures", kTaughtSteel, meanOfSources())};
  for (const char* id : {"medium-steel-620", "nickel-chrome-molybdenum-steel-900", "grey-iron-200hb"})
    cases.push_back(caseOf(std::string(id) + ", feeds of 0.1 to 0.6 mm", "table of the tool's maker", id,
                           forcesOf(*materials.find(id))));
  return cases;
}

}  // namespace handwheel

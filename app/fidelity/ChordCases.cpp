// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "base/Translatable.h"
#include "fidelity/Cases.h"
#include "nurbs/CylinderDistance.h"
#include "nurbs/Tessellation.h"

#include <limits>
#include <optional>

namespace handwheel {
namespace {

FidelityCase caseOn(const std::string& name, const StockCylinder& stock) {
  return {name, "closed form", [stock](double chord, std::uint64_t, Progress progress) {
            std::optional<Result<TriangleSoup>> soup;
            FidelitySample sample;
            TessellationOptions options;
            options.chord = chord;
            sample.cost = cpuMilliseconds([&] { soup = tessellate(stock.profile(), options, progress); });
            sample.error = *soup ? distanceToCylinder(**soup, stock) : std::numeric_limits<double>::infinity();
            return sample;
          }};
}

}  // namespace

FidelitySetting chordSetting() {
  FidelitySetting s;
  s.id = "nurbs.chord_mm";
  s.label = translatable("Fidelity", "Largest deviation of triangles from a curved surface");
  s.unit = "mm";
  s.scale = FidelityScale::Logarithmic;
  s.least = 1e-4;
  s.largest = 1.0;
  s.standard = TessellationOptions().chord;
  s.presets = {0.1, 0.022, 1e-4};
  s.error = {translatable("Fidelity", "largest distance of the triangles from the surface"), "mm"};
  s.cost = {translatable("Fidelity", "CPU time of a tessellation"), "ms"};
  s.budget = FidelityBudget::Frame;
  return s;
}

std::vector<FidelityCase> chordCases() {
  return {caseOn("bar 50 x 100 mm", {50.0, 100.0, 0.0}), caseOn("disc 300 x 20 mm", {300.0, 20.0, 0.0})};
}

}  // namespace handwheel

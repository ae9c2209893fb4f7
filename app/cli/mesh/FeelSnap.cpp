// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/FeelSnap.h"

#include "haptics/snap/SnapFidelity.h"
#include "tools/mesh/BoundarySnapFeatures.h"

#include <algorithm>
#include <array>

namespace handwheel {

namespace {

// In the order of SnapShape and SnapMethod.
constexpr std::array<std::string_view, 4> kShapes{"spring", "triangle", "quadratic", "gaussian"};
constexpr std::array<std::string_view, 2> kMethods{"proxy", "force"};

template <class Choice>
bool takeWord(std::string_view word, const auto& words, Choice& choice) {
  const auto at = std::find(words.begin(), words.end(), word);
  if (at == words.end()) return false;
  choice = static_cast<Choice>(at - words.begin());
  return true;
}

}  // namespace

std::string readSnap(const Arguments& arguments, SnapRequest& request) {
  const std::string shape = arguments.valueOf("snap");
  request.isOn = arguments.has("snap") && shape != "none";
  if (request.isOn && !takeWord(shape, kShapes, request.shape))
    return "--snap takes none, spring, triangle, quadratic or gaussian.";
  for (const char* option : {"snap-method", "snap-stiffness"})
    if (arguments.has(option) && !request.isOn)
      return "--" + std::string(option) + " needs a profile: choose one with --snap.";
  if (arguments.has("snap-method") && !takeWord(arguments.valueOf("snap-method"), kMethods, request.method))
    return "--snap-method takes proxy or force.";
  return {};
}

std::optional<SnapAttraction> snapAttraction(const SnapRequest& request, const HalfEdgeMesh& mesh,
                                             std::span<const BoundaryLoop> loops, const FidelityValues& values,
                                             Progress progress) {
  LoopSnapField boundary = boundarySnapFeatures(mesh, loops, {}, progress);
  if (boundary.field.empty()) return std::nullopt;
  const SnapProfile profile(request.shape, request.stiffness, boundary.distance(values));
  return SnapAttraction{std::move(boundary.field), profile, request.method,
                        static_cast<std::size_t>(values.of(snapFeaturesSetting()))};
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/TurnedPartBlobs.h"

#include "document/container/Blobs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

namespace handwheel {

namespace {

constexpr const char* kRadii = "workpiece/radii";
constexpr std::size_t kMostPasses = 100'000;
constexpr std::size_t kPointNumbers = 3;  // time, r, z
// Samples below the passes that are cut once more, each time that they are passed: some ten seconds.
constexpr std::uint64_t kMostCutAgain = 1'000'000'000;

std::string passName(std::size_t i) {
  char number[32];
  std::snprintf(number, sizeof number, "%04zu", i);
  return std::string("workpiece/passes/") + number;
}

std::uint64_t countIn(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number_unsigned() ? found->get<std::uint64_t>() : 0;
}

double numberIn(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : 0.0;
}

Error lost(const char* what, std::uint64_t expected, std::uint64_t found) {
  return {ErrorCode::DataTruncated, {what, std::to_string(expected), std::to_string(found)}, {}, {}};
}

std::optional<TurningPass> readPass(const nlohmann::json& entry, const Container& container, const std::string& name) {
  TurningPass pass;
  if (!entry.is_object()) return std::nullopt;
  pass.noseRadius = numberIn(entry, "nose_radius");
  const std::uint64_t count = countIn(entry, "points");
  if (!(pass.noseRadius > 0.0 && pass.noseRadius <= StockCylinder::kLargestSize)) return std::nullopt;
  if (count == 0 || count > TurningPass::kMostPoints) return std::nullopt;
  const ReadArray<double> read = readArray<double>(container, name, count, kPointNumbers);
  if (!read.lost.empty() || read.values.size() != kPointNumbers * count) return std::nullopt;
  if (!std::all_of(read.values.begin(), read.values.end(), [](double v) { return std::isfinite(v); }))
    return std::nullopt;
  for (std::size_t i = 0; i < count; ++i) {
    const double* point = &read.values[kPointNumbers * i];
    pass.times.push_back(std::max(point[0], i == 0 ? 0.0 : pass.times.back()));
    pass.path.emplace_back(point[1], point[2]);
  }
  return pass;
}

// How many of the samples are there, and can be of a part from this bar.
std::uint64_t soundRadii(const ReadArray<double>& radii, const StockCylinder& stock) {
  const std::size_t there = radii.values.size();
  auto count = std::count_if(radii.values.begin(), radii.values.end(),
                             [&](double r) { return r >= 0.0 && r <= 0.5 * stock.diameter; });
  for (const IndexRange& lost : radii.lost) count -= std::min(lost.end, there) - std::min(lost.begin, there);
  return static_cast<std::uint64_t>(count);
}

// The part that the passes cut from the bar; null where that would take too long, as only a hostile file can make it.
std::optional<TurnedProfile> cutOnceMore(const std::vector<std::shared_ptr<const TurningPass>>& passes,
                                         const StockCylinder& stock, std::uint64_t samples, Progress progress) {
  TurnedProfile profile = TurnedProfile::fromRadii(std::vector<double>(samples, 0.5 * stock.diameter), stock.length);
  std::uint64_t work = 0;
  for (const auto& pass : passes) work += samplesUnder(profile, *pass);
  if (work > kMostCutAgain) return std::nullopt;
  for (const auto& pass : passes) cut(profile, *pass, progress);
  return profile;
}

}  // namespace

void writeTurnedPart(const WorkpieceSnapshot& workpiece, Container& container) {
  nlohmann::json& turned = (*container.manifest)["document"]["turned"];
  turned = nullptr;
  if (!workpiece.part) return;
  const TurnedProfile& profile = workpiece.part->profile;
  std::vector<double> radii(profile.size());
  for (std::size_t i = 0; i < profile.size(); ++i) radii[i] = profile.radius(i);
  writeArray<double>(container, kRadii, radii);
  nlohmann::json passes = nlohmann::json::array();
  for (std::size_t i = 0; i < workpiece.part->passes.size(); ++i) {
    const TurningPass& pass = *workpiece.part->passes[i];
    std::vector<double> points;
    points.reserve(kPointNumbers * pass.path.size());
    for (std::size_t k = 0; k < pass.path.size(); ++k) {
      points.insert(points.end(), {pass.times[k], pass.path[k].x(), pass.path[k].y()});
    }
    writeArray<double>(container, passName(i), points, kPointNumbers);
    passes.push_back({{"nose_radius", pass.noseRadius}, {"points", pass.path.size()}});
  }
  turned = {{"samples", profile.size()}, {"passes", std::move(passes)}};
}

Result<std::shared_ptr<const TurnedPart>> readTurnedPart(const nlohmann::json& document,
                                                         const WorkpieceSnapshot& workpiece, const Container& container,
                                                         std::vector<Error>& damage, Progress progress) {
  const auto turned = document.find("turned");
  if (turned == document.end() || turned->is_null()) return std::shared_ptr<const TurnedPart>();
  const std::uint64_t samples = turned->is_object() ? countIn(*turned, "samples") : 0;
  if (samples < 2 || samples > TurnedProfile::kMostSamples) {
    damage.push_back(
        {ErrorCode::ElementMalformed, {"turned", "the number of samples is missing or impossible"}, {}, {}});
    return std::shared_ptr<const TurnedPart>();
  }
  std::vector<std::shared_ptr<const TurningPass>> passes;
  const nlohmann::json listed = turned->value("passes", nlohmann::json::array());
  const std::size_t count = std::min(listed.size(), kMostPasses);
  for (std::size_t i = 0; listed.is_array() && i < count; ++i) {
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    if (auto pass = readPass(listed[i], container, passName(i)))
      passes.push_back(std::make_shared<const TurningPass>(std::move(*pass)));
  }
  const bool hasAllPasses = passes.size() == listed.size();
  if (!hasAllPasses) damage.push_back(lost("passes", listed.size(), passes.size()));

  const ReadArray<double> radii = readArray<double>(container, kRadii, samples);
  const StockCylinder& stock = workpiece.stock;
  const std::uint64_t sound = soundRadii(radii, stock);
  std::optional<TurnedProfile> profile;
  if (sound == samples) {
    profile = TurnedProfile::fromRadii(radii.values, stock.length);
  } else {
    damage.push_back(lost("samples of the profile", samples, sound));
    if (!hasAllPasses) return std::shared_ptr<const TurnedPart>();
    profile = cutOnceMore(passes, stock, samples, progress);
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    if (!profile) {
      damage.push_back({ErrorCode::ElementMalformed, {"passes", "cutting them again would take too long"}, {}, {}});
      return std::shared_ptr<const TurnedPart>();
    }
  }
  TurnedSurface surface(*profile, workpiece.chord);
  return std::make_shared<const TurnedPart>(TurnedPart{std::move(*profile), std::move(surface), std::move(passes)});
}

}  // namespace handwheel

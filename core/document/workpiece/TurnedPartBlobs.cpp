// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/TurnedPartBlobs.h"

#include "document/container/Blobs.h"
#include "machining/lathe/LatheJson.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace handwheel {

namespace {

constexpr const char* kRadii = "workpiece/radii";
constexpr const char* kInner = "workpiece/inner";
constexpr const char* kFinish = "workpiece/finish";
constexpr const char* kPath = "workpiece/path";  // of all passes
constexpr const char* kBore = "bore";            // value of "side"
constexpr const char* kPoles = "poles";          // value of "method"
constexpr std::size_t kMostPasses = 100'000;
constexpr std::size_t kPointNumbers = 3;  // time, r, z
// Samples below the passes that are cut once more, each time that they are passed: some ten seconds.
constexpr std::uint64_t kMostCutAgain = 1'000'000'000;

std::uint64_t countIn(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number_unsigned() ? found->get<std::uint64_t>() : 0;
}

double numberIn(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : 0.0;
}

// Of a pass as it is listed; 0 where that is malformed.
std::uint64_t pointsIn(const nlohmann::json& entry) {
  const std::uint64_t count = entry.is_object() ? countIn(entry, "points") : 0;
  return count <= TurningPass::kMostPoints ? count : 0;
}

Error lost(const char* what, std::uint64_t expected, std::uint64_t found) {
  return {ErrorCode::DataTruncated, {what, std::to_string(expected), std::to_string(found)}, {}, {}};
}

// Whether a range of points is there whole.
bool isWhole(const ReadArray<double>& path, std::uint64_t begin, std::uint64_t end) {
  if (path.values.size() < kPointNumbers * end) return false;
  return std::none_of(path.lost.begin(), path.lost.end(),
                      [&](const IndexRange& lost) { return lost.begin < end && begin < lost.end; });
}

// The pass whose points begin there in the path of all passes.
std::optional<TurningPass> readPass(const nlohmann::json& entry, const ReadArray<double>& path, std::uint64_t begin) {
  TurningPass pass;
  if (!entry.is_object()) return std::nullopt;
  pass.noseRadius = numberIn(entry, "nose_radius");
  const std::uint64_t count = pointsIn(entry);
  if (const auto side = entry.find("side"); side != entry.end()) {
    if (*side != kBore) return std::nullopt;
    pass.side = TurningSide::Bore;
  }
  if (const auto method = entry.find("method"); method != entry.end()) {
    pass.method = TurningMethod::Poles;
    pass.resolution = numberIn(entry, "resolution");
    const bool isSound = pass.resolution >= PoleCut::kLeastResolution && pass.resolution <= PoleCut::kLargestResolution;
    if (*method != kPoles || !isSound) return std::nullopt;
  }
  if (const auto tool = entry.find("tool"); tool != entry.end()) {
    Result<LatheTool> read = latheToolFrom(*tool);
    if (!read) return std::nullopt;
    pass.tool = std::make_shared<const LatheTool>(std::move(*read));
  }
  if (!(pass.noseRadius >= 0.0 && pass.noseRadius <= StockCylinder::kLargestSize)) return std::nullopt;
  if (count == 0) return std::nullopt;
  if (!isWhole(path, begin, begin + count)) return std::nullopt;
  const double* const first = &path.values[kPointNumbers * begin];
  if (!std::all_of(first, first + kPointNumbers * count, [](double v) { return std::isfinite(v); }))
    return std::nullopt;
  for (std::size_t i = 0; i < count; ++i) {
    const double* point = first + kPointNumbers * i;
    pass.times.push_back(std::max(point[0], i == 0 ? 0.0 : pass.times.back()));
    pass.path.emplace_back(point[1], point[2]);
  }
  return pass;
}

// How many of the samples are there, and can be of a part from this bar. inner: empty where it is not bored.
std::uint64_t soundSamples(const ReadArray<double>& radii, const ReadArray<double>& inner, bool isBored,
                           std::uint64_t samples, const StockCylinder& stock) {
  const auto isLost = [](const ReadArray<double>& array, std::size_t i) {
    return i >= array.values.size() || std::any_of(array.lost.begin(), array.lost.end(), [i](const IndexRange& lost) {
             return i >= lost.begin && i < lost.end;
           });
  };
  std::uint64_t sound = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    if (isLost(radii, i) || (isBored && isLost(inner, i))) continue;
    const double outer = radii.values[i], hollow = isBored ? inner.values[i] : 0.0;
    sound += hollow >= 0.0 && outer >= hollow && outer <= 0.5 * stock.diameter ? 1 : 0;  // not so for NaN
  }
  return sound;
}

// The part that the passes cut from the bar; null where that would take too long, as only a hostile file can make it.
std::optional<TurnedProfile> cutOnceMore(const TurningPasses& passes, const StockCylinder& stock, std::uint64_t samples,
                                         Progress progress) {
  TurnedProfile profile = TurnedProfile::fromRadii(std::vector<double>(samples, 0.5 * stock.diameter), stock.length);
  std::uint64_t work = 0;
  for (const auto& pass : passes) work += samplesUnder(profile, *pass);
  if (work > kMostCutAgain) return std::nullopt;
  for (const auto& pass : passes) cut(profile, *pass, progress);
  return profile;
}

// Outside, then in the bore; -1: not known.
std::vector<float> roughnessOf(const TurnedPart& part) {
  std::vector<float> all;
  for (const TurningSide side : {TurningSide::Outside, TurningSide::Bore}) {
    for (std::size_t i = 0; i < part.profile.size(); ++i) {
      const double radius = side == TurningSide::Outside ? part.profile.radius(i) : part.profile.inner(i);
      all.push_back(static_cast<float>(part.finish->at(side, i, radius).value_or(-1.0)));
    }
  }
  return all;
}

// What is lost or impossible of it is not known: the finish is no part of the shape.
std::shared_ptr<const SurfaceFinish> readFinish(const Container& container, const TurnedProfile& profile) {
  const ReadArray<float> array = readArray<float>(container, kFinish, 2 * profile.size());
  auto finish = std::make_shared<SurfaceFinish>(profile.size());
  const auto isLost = [&](std::size_t i) {
    return std::any_of(array.lost.begin(), array.lost.end(),
                       [i](const IndexRange& lost) { return i >= lost.begin && i < lost.end; });
  };
  for (std::size_t i = 0; i < 2 * profile.size() && i < array.values.size(); ++i) {
    const bool isOuter = i < profile.size();
    const std::size_t sample = isOuter ? i : i - profile.size();
    if (isLost(i) || !(array.values[i] >= 0.0f)) continue;
    finish->set(isOuter ? TurningSide::Outside : TurningSide::Bore, sample,
                isOuter ? profile.radius(sample) : profile.inner(sample), array.values[i]);
  }
  return finish;
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
  if (profile.isBored()) {
    for (std::size_t i = 0; i < profile.size(); ++i) radii[i] = profile.inner(i);
    writeArray<double>(container, kInner, radii);
  }
  nlohmann::json passes = nlohmann::json::array();
  std::vector<double> points;
  for (const auto& shared : workpiece.part->passes) {
    const TurningPass& pass = *shared;
    for (std::size_t k = 0; k < pass.path.size(); ++k) {
      points.insert(points.end(), {pass.times[k], pass.path[k].x(), pass.path[k].y()});
    }
    nlohmann::json entry = {{"nose_radius", pass.noseRadius}, {"points", pass.path.size()}};
    if (pass.tool) entry["tool"] = toJson(*pass.tool);
    if (pass.side == TurningSide::Bore) entry["side"] = kBore;
    if (pass.method == TurningMethod::Poles) {
      entry["method"] = kPoles;
      entry["resolution"] = pass.resolution;
    }
    passes.push_back(std::move(entry));
  }
  writeArray<double>(container, kPath, points, kPointNumbers);
  turned = {{"samples", profile.size()}, {"passes", std::move(passes)}};
  if (profile.isBored()) turned["bored"] = true;
  if (!workpiece.part->finish) return;
  writeArray<float>(container, kFinish, roughnessOf(*workpiece.part));
  turned["finish"] = true;
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
  TurningPasses passes;
  const nlohmann::json listed = turned->value("passes", nlohmann::json::array());
  const std::size_t count = listed.is_array() ? std::min(listed.size(), kMostPasses) : 0;
  std::uint64_t points = 0;
  for (std::size_t i = 0; i < count; ++i) points += pointsIn(listed[i]);
  const ReadArray<double> path = readArray<double>(container, kPath, points, kPointNumbers);
  std::uint64_t begin = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    if (auto pass = readPass(listed[i], path, begin))
      passes.push_back(std::make_shared<const TurningPass>(std::move(*pass)));
    begin += pointsIn(listed[i]);
  }
  const bool hasAllPasses = passes.size() == listed.size();
  if (!hasAllPasses) damage.push_back(lost("passes", listed.size(), passes.size()));

  const nlohmann::json bored = turned->value("bored", nlohmann::json(false));
  const bool isBored = bored.is_boolean() && bored.get<bool>();
  const ReadArray<double> radii = readArray<double>(container, kRadii, samples);
  const ReadArray<double> inner = isBored ? readArray<double>(container, kInner, samples) : ReadArray<double>();
  const StockCylinder& stock = workpiece.stock;
  const std::uint64_t sound = soundSamples(radii, inner, isBored, samples, stock);
  std::optional<TurnedProfile> profile;
  if (sound == samples) {
    profile = TurnedProfile::fromRadii(radii.values, inner.values, stock.length);
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
  std::shared_ptr<const SurfaceFinish> finish;
  if (const auto kept = turned->find("finish"); kept != turned->end() && *kept == true)
    finish = readFinish(container, *profile);
  return std::make_shared<const TurnedPart>(
      TurnedPart{std::move(*profile), std::move(surface), std::move(passes), std::move(finish)});
}

}  // namespace handwheel

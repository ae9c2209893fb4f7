// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/blobs/TurnedPartBlobs.h"

#include "base/JsonText.h"
#include "document/container/Blobs.h"
#include "document/workpiece/blobs/FinishBlobs.h"
#include "document/workpiece/blobs/PassBlobs.h"
#include "document/workpiece/blobs/SectionBlobs.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

namespace handwheel {

namespace {

constexpr const char* kRadii = "workpiece/radii";
constexpr const char* kInnerBlob = "workpiece/inner";
// Keys of a turned part.
constexpr const char *kTurned = "turned", *kSamples = "samples", *kBored = "bored", *kPasses = "passes",
                     *kFinish = "finish", *kSection = "section";
Error lost(const char* what, std::uint64_t expected, std::uint64_t found) {
  return {ErrorCode::DataTruncated, {what, std::to_string(expected), std::to_string(found)}, {}, {}};
}

// Returns the number of leading samples that were read and are possible for a part from this bar. inner: empty if it is
// not bored.
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
  std::uint32_t number = 0;
  for (const auto& pass : passes) cut(profile, pass, number++, progress);
  return profile;
}

// Returns true if a section has the samples of a part. After passes by hand the two may differ by a sample beside a
// face, and by a little where the path of the hand was unsteady.
bool isSectionOf(const TurnedSection& section, const TurnedProfile& samples) {
  constexpr std::size_t kBeside = 2;  // samples
  constexpr double kSlack = 0.02;     // mm
  double largest = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) largest = std::max(largest, samples.radius(i));
  TurnedProfile sampled = TurnedProfile::barOf({2.0 * largest, samples.length(), 0.0}, samples.size());
  section.sample(sampled, {0, sampled.size()});
  const auto isWithin = [&](std::size_t i, auto radiusOf) {
    const std::size_t last = std::min(i + kBeside, samples.size() - 1);
    double least = radiusOf(samples, i), most = least;
    for (std::size_t k = i - std::min(i, kBeside); k <= last; ++k) {
      least = std::min(least, radiusOf(samples, k));
      most = std::max(most, radiusOf(samples, k));
    }
    const double r = radiusOf(sampled, i);
    return r >= least - kSlack && r <= most + kSlack;
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const bool isEmpty = !samples.hasMaterial(i) && !sampled.hasMaterial(i);
    const auto outer = [](const TurnedProfile& part, std::size_t k) {
      return part.hasMaterial(k) ? part.radius(k) : 0.0;
    };
    const auto inner = [](const TurnedProfile& part, std::size_t k) {
      return part.hasMaterial(k) ? part.inner(k) : 0.0;
    };
    if (!isEmpty && !(isWithin(i, outer) && isWithin(i, inner))) return false;
  }
  return true;
}

// Returns the source of the section that the passes cut from the bar.
SectionSource::Pointer sectionOfPasses(const TurningPasses& passes, const StockCylinder& stock,
                                       const TurnedProfile& samples) {
  SectionSource::Pointer source = SectionSource::of(TurnedSection(stock));
  std::uint32_t number = 0;
  for (const auto& pass : passes) {
    if (!pass->thread) source = SectionSource::after(source, pass, number, samples);
    ++number;
  }
  return source;
}

}  // namespace

void writeTurnedPart(const WorkpieceSnapshot& workpiece, Container& container) {
  nlohmann::json& turned = (*container.manifest)["document"][kTurned];
  turned = nullptr;
  if (!workpiece.part) return;
  const TurnedProfile& profile = workpiece.part->profile;
  std::vector<double> radii(profile.size());
  for (std::size_t i = 0; i < profile.size(); ++i) radii[i] = profile.radius(i);
  writeArray<double>(container, kRadii, radii);
  if (profile.isBored()) {
    for (std::size_t i = 0; i < profile.size(); ++i) radii[i] = profile.inner(i);
    writeArray<double>(container, kInnerBlob, radii);
  }
  turned = {{kSamples, profile.size()}, {kPasses, writePasses(workpiece.part->passes, container)}};
  if (profile.isBored()) turned[kBored] = true;
  turned[kSection] = writeSection(workpiece.part->section(), container);
  if (workpiece.part->finish.size() == profile.size()) {
    writeFinish(workpiece.part->finish, profile, container);
    turned[kFinish] = true;
  }
}

Result<std::shared_ptr<const TurnedPart>> readTurnedPart(const nlohmann::json& document,
                                                         const WorkpieceSnapshot& workpiece, const Container& container,
                                                         std::vector<Error>& damage, Progress progress) {
  const auto turned = document.find(kTurned);
  if (turned == document.end() || turned->is_null()) return std::shared_ptr<const TurnedPart>();
  const std::uint64_t samples = countAt(*turned, kSamples);
  if (samples < 2 || samples > TurnedProfile::kMostSamples) {
    damage.push_back(
        {ErrorCode::ElementMalformed, {kTurned, "the number of samples is missing or impossible"}, {}, {}});
    return std::shared_ptr<const TurnedPart>();
  }
  const nlohmann::json listed = turned->value(kPasses, nlohmann::json::array());
  Result<TurningPasses> read = readPasses(listed, container, progress);
  if (!read) return read.error();
  TurningPasses passes = std::move(read.value());
  const bool hasAllPasses = passes.size() == listed.size();
  if (!hasAllPasses) damage.push_back(lost(kPasses, listed.size(), passes.size()));

  const bool isBored = turned->value(kBored, nlohmann::json()) == true;
  const ReadArray<double> radii = readArray<double>(container, kRadii, samples);
  const ReadArray<double> inner = isBored ? readArray<double>(container, kInnerBlob, samples) : ReadArray<double>();
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
      damage.push_back({ErrorCode::ElementMalformed, {kPasses, "cutting them again would take too long"}, {}, {}});
      return std::shared_ptr<const TurnedPart>();
    }
  }
  // Early versions of the program wrote no section.
  auto section = readSection(container, countAt(*turned, kSection), stock);
  if (section && isSectionOf(*section, *profile))
    profile->setSection(SectionSource::of(std::move(*section)));
  else if (hasAllPasses)
    profile->setSection(sectionOfPasses(passes, stock, *profile));
  else
    profile->setSection(SectionSource::fitted(*profile));
  if (!profile->section()->prepare(progress)) return Error{ErrorCode::Cancelled, {}, {}, {}};
  auto part = TurnedPart::of(std::move(*profile), std::move(passes), workpiece.chord);
  // If passes are lost, the others have other numbers.
  if (turned->value(kFinish, nlohmann::json()) == true && hasAllPasses)
    part.finish = readFinish(container, part.profile, part.passes.size());
  return std::make_shared<const TurnedPart>(std::move(part));
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/ImageLabels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

namespace handwheel {
namespace {

// Returns how often each value occurs; nothing if there are more than `most` values, or if one is not an integer.
std::optional<std::map<double, std::size_t>> countsOf(const ImageVolume& image, std::size_t most) {
  return image.visitSamples([&](auto samples) -> std::optional<std::map<double, std::size_t>> {
    std::map<double, std::size_t> counts;
    for (std::size_t i = 0; i < samples.size();) {
      const auto value = samples[i];
      if (static_cast<double>(value) != std::trunc(static_cast<double>(value))) return {};
      std::size_t end = i + 1;  // values come in runs
      while (end < samples.size() && samples[end] == value) ++end;
      counts[static_cast<double>(value)] += end - i;
      if (counts.size() > most) return {};
      i = end;
    }
    return counts;
  });
}

// Returns a name that can be shown and saved: UTF-8 without control characters, of limited length.
std::string cleaned(const std::string& name) {
  constexpr std::size_t kLongest = 200;
  using Json = nlohmann::json;
  const std::string text = Json(name.substr(0, kLongest)).dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string clean = Json::parse(text).get<std::string>();
  std::erase_if(clean, [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; });
  return clean;
}

}  // namespace

bool looksLikeLabels(const ImageVolume& image) {
  constexpr std::size_t kMost = 256;
  const auto counts = countsOf(image, kMost);
  if (!counts || counts->size() < 2 || counts->begin()->first != 0.0) return false;
  const auto width = static_cast<std::size_t>(image.grid().size[0]);
  return image.visitSamples([&](auto samples) {
    std::size_t sudden = 0, between = 0;
    for (std::size_t row = 0; row < samples.size(); row += width)
      for (std::size_t x = row + 1; x + 1 < row + width; ++x) {
        const auto before = samples[x - 1], here = samples[x], after = samples[x + 1];
        if ((before < here && here < after) || (before > here && here > after)) ++between;
        if (before == here && here != after && (x + 2 == row + width || samples[x + 2] == after)) ++sudden;
      }
    return sudden > 0 && sudden >= 2 * between;
  });
}

void markLabels(ImageVolume& image, const std::vector<ImageLabel>& names) {
  const auto counts = countsOf(image, kMostLabels + 1);
  if (!counts) return;
  std::vector<ImageLabel> labels;
  for (const auto& [value, samples] : *counts) {
    if (value == 0.0) continue;
    const auto named =
        std::find_if(names.begin(), names.end(), [v = value](const ImageLabel& label) { return label.value == v; });
    labels.push_back({value, named == names.end() ? std::string() : cleaned(named->name)});
  }
  if (!labels.empty()) image.setLabels(std::move(labels));
}

std::vector<LabelRegion> regionsOf(const ImageVolume& image) {
  std::vector<LabelRegion> regions;
  const auto counts = countsOf(image, std::numeric_limits<std::size_t>::max());
  const double sample = std::abs(image.grid().steps.determinant());
  for (const ImageLabel& label : image.labels()) {
    const auto found = counts ? counts->find(label.value) : decltype(counts->find(0.0)){};
    const std::size_t samples = counts && found != counts->end() ? found->second : 0;
    regions.push_back({label, samples, sample * static_cast<double>(samples)});
  }
  return regions;
}

ValueRange rangeOfLabels(const ImageVolume& image) {
  return {image.labels().front().value, std::numeric_limits<double>::infinity()};
}

}  // namespace handwheel

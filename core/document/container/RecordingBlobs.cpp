// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/container/RecordingBlobs.h"

#include "base/JsonText.h"

#include "document/container/Blobs.h"
#include "haptics/recording/RecordingBytes.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using nlohmann::json;

constexpr const char* kList = "recordings";
constexpr std::size_t kPartDigits = 4, kMostKeyDigits = 9;

std::string partName(const std::string& key, std::size_t part) {
  const std::string digits = std::to_string(part);
  return kRecordingFolder + key + "/" + std::string(kPartDigits - std::min(kPartDigits, digits.size()), '0') + digits;
}

bool isKey(const std::string& key) {
  return key.size() >= kPartDigits && key.size() <= kMostKeyDigits &&
         std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
}

double forceAt(const json& object, const char* key) {
  const auto found = object.find(key);
  const double force = found != object.end() && found->is_number() ? found->get<double>() : 0.0;
  return force > 0.0 && std::isfinite(force) ? force : 0.0;
}

// Reads all parts that exist and are readable.
Recording readTicks(const std::string& key, const Container& container) {
  Recording ticks;
  const std::string folder = kRecordingFolder + key + "/";
  for (auto blob = container.blobs.lower_bound(folder);
       blob != container.blobs.end() && blob->first.starts_with(folder); ++blob) {
    if (const Result<Recording> part = recordingFromBytes(blob->second)) ticks.append(*part);
  }
  return ticks;
}

}  // namespace

void listRecordings(const std::vector<StoredRecording>& recordings, json& manifest) {
  for (const StoredRecording& each : recordings) {
    manifest[kList][each.key] = {
        {"name", each.name}, {"device", each.device}, {"force_limit", each.forceLimit}, {"ticks", each.ticks.size()}};
  }
}

void writeRecordings(const std::vector<StoredRecording>& recordings, Container& container) {
  for (const StoredRecording& each : recordings) {
    std::size_t first = 0;
    for (std::size_t part = 0; part == 0 || first < each.ticks.size(); ++part) {
      const std::size_t last = std::min(first + kChunkElements, each.ticks.size());
      container.blobs[partName(each.key, part)] = recordingBytes(each.ticks, first, last);
      first = last;
    }
  }
}

std::vector<StoredRecording> readRecordings(const Container& container, std::vector<Error>& damage) {
  std::vector<StoredRecording> recordings;
  const auto list = container.manifest->find(kList);
  if (list == container.manifest->end() || !list->is_object()) return recordings;
  for (const auto& [key, entry] : list->items()) {
    if (!isKey(key) || !entry.is_object()) continue;
    StoredRecording recording{key, stringAt(entry, "name", key), stringAt(entry, "device", {}),
                              forceAt(entry, "force_limit"), readTicks(key, container)};
    const auto announced = entry.find("ticks");
    const std::size_t found = recording.ticks.size();
    const std::uint64_t all =
        announced != entry.end() && announced->is_number_unsigned() ? announced->get<std::uint64_t>() : found;
    if (found < all) {
      const std::string what = "ticks of the recording '" + recording.name + "'";
      damage.push_back({ErrorCode::DataTruncated, {what, std::to_string(all), std::to_string(found)}, {}, {}});
    }
    recordings.push_back(std::move(recording));
  }
  return recordings;
}

}  // namespace handwheel

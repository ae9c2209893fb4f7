// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/target/TargetBlobs.h"

#include "base/Utf8.h"
#include "document/container/Blobs.h"

#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

constexpr const char* kTargetBlob = "workpiece/target";
constexpr const char *kTargetKey = "target", *kSegmentsKey = "segments", *kSourceKey = "source";
constexpr std::size_t kSegmentNumbers = 5;
constexpr std::size_t kLongestSource = 1000;  // bytes

}  // namespace

void writeTarget(const WorkpieceSnapshot& workpiece, Container& container) {
  nlohmann::json& entry = (*container.manifest)["document"][kTargetKey];
  entry = nullptr;
  if (!workpiece.target) return;
  std::vector<double> numbers;
  for (const ProfileSegment& s : workpiece.target->profile.segments())
    numbers.insert(numbers.end(), {s.from.x(), s.from.y(), s.to.x(), s.to.y(), s.bulge});
  writeArray<double>(container, kTargetBlob, numbers, kSegmentNumbers);
  entry = {{kSegmentsKey, workpiece.target->profile.segments().size()}, {kSourceKey, workpiece.target->source}};
}

std::shared_ptr<const WorkpieceTarget> readTarget(const nlohmann::json& document, const Container& container,
                                                  std::vector<Error>& damage) {
  const auto found = document.find(kTargetKey);
  if (found == document.end() || found->is_null()) return nullptr;
  const nlohmann::json count = found->is_object() ? found->value(kSegmentsKey, nlohmann::json()) : nlohmann::json();
  if (!count.is_number_unsigned() || count.get<std::uint64_t>() > TargetProfile::kMostSegments) {
    damage.push_back(
        {ErrorCode::ElementMalformed, {"target", "the number of segments is missing or impossible"}, {}, {}});
    return nullptr;
  }
  const auto expected = count.get<std::uint64_t>();
  const ReadArray<double> read = readArray<double>(container, kTargetBlob, expected, kSegmentNumbers);
  const std::size_t there = read.values.size() / kSegmentNumbers;
  if (!read.lost.empty() || there != expected) {
    damage.push_back({ErrorCode::DataTruncated, {"segments", std::to_string(expected), std::to_string(there)}, {}, {}});
    return nullptr;
  }
  std::vector<ProfileSegment> segments;
  for (std::size_t i = 0; i < there; ++i) {
    const double* s = &read.values[kSegmentNumbers * i];
    segments.push_back({{s[0], s[1]}, {s[2], s[3]}, s[4]});
  }
  Result<TargetProfile> profile = TargetProfile::make(std::move(segments));
  if (!profile) {
    damage.push_back(profile.error());
    return nullptr;
  }
  const nlohmann::json source = found->value(kSourceKey, nlohmann::json());
  std::string name = source.is_string() ? source.get<std::string>() : std::string();
  if (name.size() > kLongestSource || !isUtf8(name)) name.clear();
  return std::make_shared<const WorkpieceTarget>(WorkpieceTarget{std::move(profile.value()), std::move(name)});
}

}  // namespace handwheel

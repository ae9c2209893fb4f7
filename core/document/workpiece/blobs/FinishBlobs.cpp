// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/blobs/FinishBlobs.h"

#include "document/container/Blobs.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr const char* kFinishBlob = "workpiece/finish";
constexpr std::size_t kMarkNumbers = 3;  // roughness, feed, pass
constexpr float kNoPass = -1.0f;         // replaces the index of a pass
// Beyond it a float does not have all whole numbers.
constexpr std::uint32_t kExactPasses = 1u << 24;

bool hasSide(const TurnedProfile& profile, TurningSide side) {
  return side == TurningSide::Outside || profile.isBored();
}

bool isRoughness(float value) {
  return value >= 0.0f || value == FinishMark::kUnknown;  // not so for NaN
}

// Returns an unknown mark for impossible numbers.
FinishMark markFrom(const float* numbers, std::size_t passes) {
  const float roughness = numbers[0], feed = numbers[1], pass = numbers[2];
  const FinishMark unknown{FinishMark::kUnknown, 0.0f, FinishMark::kNoPass};
  if (!isRoughness(roughness) || !(feed >= 0.0f)) return unknown;
  if (pass == kNoPass) return {roughness, feed, FinishMark::kNoPass};
  const bool isOfPass = pass >= 0.0f && pass < static_cast<float>(passes) && pass == std::floor(pass);
  return isOfPass ? FinishMark{roughness, feed, static_cast<std::uint32_t>(pass)} : unknown;
}

}  // namespace

void writeFinish(const SurfaceFinish& finish, const TurnedProfile& profile, Container& container) {
  std::vector<float> numbers;
  for (const TurningSide side : {TurningSide::Outside, TurningSide::Bore}) {
    for (std::size_t i = 0; i < profile.size() && hasSide(profile, side); ++i) {
      const FinishMark mark = finish.at(side, i);
      const bool hasPass = mark.pass < kExactPasses;
      numbers.insert(numbers.end(), {mark.roughness, mark.feed, hasPass ? static_cast<float>(mark.pass) : kNoPass});
    }
  }
  writeArray<float>(container, kFinishBlob, numbers, kMarkNumbers);
}

SurfaceFinish readFinish(const Container& container, const TurnedProfile& profile, std::size_t passes) {
  const std::size_t sides = profile.isBored() ? 2 : 1, count = sides * profile.size();
  ReadArray<float> array = readArray<float>(container, kFinishBlob, count, kMarkNumbers);
  array.values.resize(kMarkNumbers * count, std::nanf(""));
  for (const IndexRange& lost : array.lost) {
    const auto first = array.values.begin() + static_cast<std::ptrdiff_t>(kMarkNumbers * std::min(lost.begin, count));
    const auto last = array.values.begin() + static_cast<std::ptrdiff_t>(kMarkNumbers * std::min(lost.end, count));
    std::fill(first, last, std::nanf(""));
  }
  SurfaceFinish finish(profile.size());
  for (const TurningSide side : {TurningSide::Outside, TurningSide::Bore}) {
    const std::size_t first = side == TurningSide::Outside ? 0 : profile.size();
    for (std::size_t i = 0; i < profile.size() && hasSide(profile, side); ++i)
      finish.set(side, i, markFrom(&array.values[kMarkNumbers * (first + i)], passes));
  }
  return finish;
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/blobs/SectionBlobs.h"

#include "document/container/Blobs.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr const char* kSectionBlob = "workpiece/section";
// The numbers of a segment: point, direction and radius of its carrier, its start, its pass (-1: the bar), and 1 if it
// is the first of a loop.
constexpr std::size_t kNumbersOfSegment = 9;
constexpr double kSectionSlack = 1e-6;     // mm
constexpr std::size_t kMostLoops = 1'000;  // a part has one for each of its pieces and hollows

bool isSound(const SectionLoop& loop, const StockCylinder& stock) {
  if (loop.size() < 2) return false;
  return std::all_of(loop.begin(), loop.end(), [&](const SectionSegment& segment) {
    const bool isOnCarrier = segment.carrier.distance(segment.from) <= kSectionSlack &&
                             segment.carrier.distance(segment.to) <= kSectionSlack;
    return isOnCarrier && segment.from.x() >= -kSectionSlack &&
           segment.from.x() <= 0.5 * stock.diameter + kSectionSlack && segment.from.y() >= -kSectionSlack &&
           segment.from.y() <= stock.length + kSectionSlack;
  });
}

}  // namespace

std::uint64_t writeSection(const TurnedSection& section, Container& container) {
  std::vector<double> values;
  for (const SharedLoop& loop : section.loops()) {
    bool isFirst = true;
    for (const SectionSegment& segment : loop.segments()) {
      const SectionCarrier& carrier = segment.carrier;
      const double pass = segment.pass == SectionSegment::kBar ? -1.0 : segment.pass;
      values.insert(values.end(), {carrier.point.x(), carrier.point.y(), carrier.along.x(), carrier.along.y(),
                                   carrier.radius, segment.from.x(), segment.from.y(), pass, isFirst ? 1.0 : 0.0});
      isFirst = false;
    }
  }
  writeArray<double>(container, kSectionBlob, values, kNumbersOfSegment);
  return values.size() / kNumbersOfSegment;
}

std::optional<TurnedSection> readSection(const Container& container, std::uint64_t segments,
                                         const StockCylinder& stock) {
  if (segments == 0 || segments > TurnedSection::kMostSegments) return std::nullopt;
  const ReadArray<double> read = readArray<double>(container, kSectionBlob, segments, kNumbersOfSegment);
  if (!read.lost.empty() || read.values.size() < segments * kNumbersOfSegment) return std::nullopt;
  if (!std::all_of(read.values.begin(), read.values.end(), [](double value) { return std::isfinite(value); }))
    return std::nullopt;
  std::vector<SectionLoop> loops;
  for (std::uint64_t i = 0; i < segments; ++i) {
    const double* const v = &read.values[i * kNumbersOfSegment];
    SectionSegment segment;
    segment.carrier = {{v[0], v[1]}, {v[2], v[3]}, v[4]};
    segment.from = {v[5], v[6]};
    constexpr double kMostPassNumber = 1e9;
    if (v[7] > kMostPassNumber || std::abs(segment.carrier.along.norm() - 1.0) > kSectionSlack) return std::nullopt;
    segment.pass = v[7] < 0.0 ? SectionSegment::kBar : static_cast<std::uint32_t>(v[7]);
    if (v[8] != 0.0) loops.emplace_back();
    if (loops.size() > kMostLoops) return std::nullopt;
    if (loops.empty()) return std::nullopt;
    loops.back().push_back(segment);
  }
  for (SectionLoop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) loop[i].to = loop[(i + 1) % loop.size()].from;
    if (!isSound(loop, stock)) return std::nullopt;
  }
  return TurnedSection(loops);
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/section/SharedLoop.h"

#include "machining/section/SectionDifference.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

constexpr std::size_t kLeastShared = 16;  // segments; a shorter run is copied rather than shared
constexpr std::size_t kUsualRun = 64;

bool isOnCarrier(const SectionSegment& segment, const SectionCarrier& carrier) {
  constexpr double kSame = 1e-9;  // mm
  const double whole = segment.length();
  return carrier.distance(segment.from) <= SectionDifference::kSnap &&
         carrier.distance(segment.to) <= SectionDifference::kSnap &&
         carrier.distance(segment.at(0.5 * whole)) <= SectionDifference::kSnap &&
         (!carrier.isCircle() || (std::abs(carrier.radius - segment.carrier.radius) <= kSame &&
                                  (carrier.point - segment.carrier.point).norm() <= SectionDifference::kSnap));
}

// Returns two neighbours as one segment, if both are of one pass and on one carrier.
std::optional<SectionSegment> joined(const SectionSegment& before, const SectionSegment& next) {
  if (before.pass != next.pass || before.isOfTrailingEdge != next.isOfTrailingEdge) return std::nullopt;
  if (before.carrier.isCircle() != next.carrier.isCircle()) return std::nullopt;
  // Most neighbours are on circles that differ; that is seen without their angles.
  if (before.carrier.isCircle() && (before.carrier.point - next.carrier.point).norm() > SectionDifference::kSnap)
    return std::nullopt;
  if (before.carrier.direction(before.to).dot(next.carrier.direction(next.from)) < 1.0 - 1e-9) return std::nullopt;
  const bool isLonger = next.length() > before.length();
  const SectionCarrier& kept = isLonger ? next.carrier : before.carrier;
  if (!isOnCarrier(isLonger ? before : next, kept)) return std::nullopt;
  constexpr double kMostAngle = 1.75 * M_PI;  // an arc stays less than a full circle
  if (kept.isCircle() && before.length() + next.length() > kMostAngle * std::abs(kept.radius)) return std::nullopt;
  SectionSegment one = before;
  one.carrier = kept;
  one.to = next.to;
  return one;
}

}  // namespace

SectionRun::Pointer SectionRun::of(SectionLoop segments) {
  auto run = std::make_shared<SectionRun>();
  run->box = boxOf(segments);
  run->area = areaOf(segments);
  run->volume = volumeOf(segments);
  run->segments = std::move(segments);
  return run;
}

SharedLoop::SharedLoop(std::vector<SectionRun::Pointer> runs) : m_runs(std::move(runs)) {
  for (const SectionRun::Pointer& run : m_runs) {
    m_size += run->segments.size();
    m_box.extend(run->box);
    m_area += run->area;
    m_volume += run->volume;
  }
}

SharedLoop SharedLoop::of(const SectionLoop& loop) {
  SharedLoopBuilder builder;
  for (const SectionSegment& segment : loop) builder.add(segment);
  return builder.finish();
}

SectionLoop SharedLoop::segments() const {
  SectionLoop all;
  all.reserve(m_size);
  for (const SectionRun::Pointer& run : m_runs) all.insert(all.end(), run->segments.begin(), run->segments.end());
  return all;
}

ProfilePoint SharedLoop::pointOnBoundary() const {
  const SectionSegment& first = m_runs.front()->segments.front();
  return first.at(0.5 * first.length());
}

void SharedLoopBuilder::add(const SectionSegment& segment) {
  if (!joinToLast(segment)) append(segment);
}

void SharedLoopBuilder::add(const RunPart& part) {
  const std::size_t first = joinToLast(part.front()) ? part.first + 1 : part.first;
  const SectionLoop& all = part.run->segments;
  if (first > 0 || part.last < all.size() || all.size() < kLeastShared) {
    for (std::size_t i = first; i < part.last; ++i) append(all[i]);
    return;
  }
  const bool isShared = m_open.empty() || m_open.size() >= kLeastShared;
  // A few open segments become part of the run, so that the next one can be shared.
  if (!isShared) m_open.insert(m_open.end(), all.begin(), all.end());
  flush();
  if (isShared) m_runs.push_back(part.run);
}

SharedLoop SharedLoopBuilder::finish() {
  flush();
  if (m_runs.empty()) return SharedLoop({});
  const SectionLoop &first = m_runs.front()->segments, &last = m_runs.back()->segments;
  const bool isSeveral = m_runs.size() > 1 || first.size() > 2;
  if (const std::optional<SectionSegment> one = isSeveral ? joined(last.back(), first.front()) : std::nullopt) {
    SectionLoop begin = first;
    begin.front() = *one;
    m_runs.front() = SectionRun::of(std::move(begin));
    reopenLast();
    m_open.pop_back();
    flush();
  }
  return SharedLoop(std::exchange(m_runs, {}));
}

// Returns true if a segment was joined to the last one.
bool SharedLoopBuilder::joinToLast(const SectionSegment& segment) {
  if (m_open.empty() && m_runs.empty()) return false;
  const SectionSegment& last = m_open.empty() ? m_runs.back()->segments.back() : m_open.back();
  const std::optional<SectionSegment> one = joined(last, segment);
  if (!one) return false;
  if (m_open.empty()) reopenLast();
  m_open.back() = *one;
  return true;
}

void SharedLoopBuilder::append(const SectionSegment& segment) {
  if (m_open.size() >= kUsualRun) flush();
  m_open.push_back(segment);
}

// Long open segments become two runs.
void SharedLoopBuilder::flush() {
  if (m_open.empty()) return;
  constexpr std::size_t kMostOfRun = kUsualRun + kUsualRun / 2;
  if (m_open.size() > kMostOfRun) {
    const auto middle = m_open.begin() + static_cast<std::ptrdiff_t>(m_open.size() / 2);
    m_runs.push_back(SectionRun::of(SectionLoop(m_open.begin(), middle)));
    m_open.erase(m_open.begin(), middle);
  }
  m_runs.push_back(SectionRun::of(std::exchange(m_open, {})));
}

void SharedLoopBuilder::reopenLast() {
  m_open = m_runs.back()->segments;
  m_runs.pop_back();
}

}  // namespace handwheel

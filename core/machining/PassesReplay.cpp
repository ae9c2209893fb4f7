// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/PassesReplay.h"

#include "machining/PassSteps.h"
#include "machining/section/SectionSource.h"

#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

double durationOf(const TurningPass& pass) {
  return pass.times.size() == pass.path.size() && !pass.times.empty() ? std::max(0.0, pass.times.back()) : 0.0;
}

// Continues a pass from some of its points to more of them. before: the part at the begin of the pass.
void cutOn(TurnedProfile& profile, const std::shared_ptr<const TurningPass>& pass, std::uint32_t number,
           const TurnedProfile& before, std::size_t from, std::size_t to) {
  const PassSteps steps(*pass, number);
  for (std::size_t i = from; i < to; ++i) steps.cut(profile, i);
  if (to == pass->path.size()) settlePass(profile, before, pass, number);
}

}  // namespace

PassesReplay::PassesReplay(TurnedProfile bar, TurningPasses passes) : m_passes(std::move(passes)), m_begins{0.0} {
  std::shared_ptr<const PartThreads> threads;
  for (const auto& pass : m_passes) {
    m_begins.push_back(m_begins.back() + durationOf(*pass));
    m_threads.push_back(threads);
    if (pass->thread) threads = PartThreads::with(threads, *pass);
  }
  m_versions.push_back({0, 0, bar, bar});
}

std::optional<PassesReplay> PassesReplay::make(TurnedProfile bar, TurningPasses passes, Progress progress) {
  PassesReplay replay(std::move(bar), std::move(passes));
  std::size_t all = 0, done = 0;
  for (const auto& pass : replay.m_passes) all += pass->path.size();
  const std::size_t each = all / kVersions + 1;
  TurnedProfile profile = replay.m_versions.front().profile;
  for (std::size_t number = 0; number < replay.m_passes.size(); ++number) {
    const auto& pass = replay.m_passes[number];
    const TurnedProfile before = profile;
    for (std::size_t i = 0; i < pass->path.size(); ++i) {
      cutOn(profile, pass, static_cast<std::uint32_t>(number), before, i, i + 1);
      if (++done % each != 0) continue;
      if (progress.cancelled()) return std::nullopt;
      progress.set(static_cast<double>(done) / static_cast<double>(all));
      replay.m_versions.push_back({number, i + 1, profile, before});
    }
  }
  return replay;
}

std::size_t PassesReplay::reached(const TurningPass& pass, double seconds) {
  if (pass.times.size() != pass.path.size()) return pass.path.size();
  const auto after = std::upper_bound(pass.times.begin(), pass.times.end(), seconds);
  return static_cast<std::size_t>(after - pass.times.begin());
}

PassesReplay::Moment PassesReplay::at(double seconds) const {
  if (m_passes.empty()) return {m_versions.front().profile, nullptr, nullptr};
  const double time = std::clamp(seconds, 0.0, duration());
  const auto next = std::upper_bound(m_begins.begin(), m_begins.end() - 1, time);
  const auto number = static_cast<std::size_t>(next - m_begins.begin()) - 1;
  const TurningPass& pass = *m_passes[number];
  const double since = time - m_begins[number];
  // At the very end all is cut, for any rounding of the sum of times.
  const std::size_t points = time >= duration() ? pass.path.size() : reached(pass, since);
  const auto kept = std::upper_bound(m_versions.begin(), m_versions.end(), std::pair(number, points),
                                     [](const auto& position, const Version& version) {
                                       return position < std::pair(version.pass, version.points);
                                     }) -
                    1;
  Moment moment{kept->profile, nullptr, m_passes[number], number};
  std::size_t from = kept->points;
  TurnedProfile uncut = kept->before;
  for (std::size_t i = kept->pass; i < number; ++i, from = 0) {
    cutOn(moment.profile, m_passes[i], static_cast<std::uint32_t>(i), uncut, from, m_passes[i]->path.size());
    uncut = moment.profile;
  }
  cutOn(moment.profile, m_passes[number], static_cast<std::uint32_t>(number), uncut, from, points);
  if (pass.path.empty()) return moment;
  moment.position = pass.path[points == 0 ? 0 : points - 1];
  if (points > 0 && points < pass.path.size()) {
    const double before = pass.times[points - 1], interval = pass.times[points] - before;
    const double share = interval > 0.0 ? (since - before) / interval : 0.0;
    moment.position += share * (pass.path[points] - moment.position);
    PassSteps(pass, static_cast<std::uint32_t>(number)).cut(moment.profile, points, 0.0, share);
  }
  moment.threads = threadsAt(number, points, moment.position);
  return moment;
}

std::shared_ptr<const PartThreads> PassesReplay::threadsAt(std::size_t pass, std::size_t points,
                                                           const ProfilePoint& position) const {
  if (!m_passes[pass]->thread || points == 0) return m_threads[pass];
  TurningPass begun = *m_passes[pass];
  if (points < begun.path.size()) {
    begun.path.resize(points);
    begun.path.push_back(position);
    begun.times.resize(points);
    begun.times.push_back(begun.times.back());
    begun.speeds.clear();
    begun.askedSpeeds.clear();
  }
  return PartThreads::with(m_threads[pass], begun);
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/section/SectionSource.h"

#include "machining/PassSteps.h"
#include "machining/TurnedOutline.h"
#include "machining/refit/Refit.h"

#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

constexpr double kFitTolerance = 1e-3;  // mm, tolerance of a section that is fitted to samples

// Appends lines from the end of a loop to a point, unless it is there already.
void lineTo(SectionLoop& loop, ProfilePoint& at, const ProfilePoint& to) {
  if (at != to) loop.push_back(SectionSegment::line(at, to));
  at = to;
}

void appendSide(SectionLoop& loop, ProfilePoint& at, const std::vector<ProfileSegment>& side) {
  for (const ProfileSegment& curve : side) {
    lineTo(loop, at, curve.from);
    if (curve.from == curve.to) continue;
    loop.push_back(SectionSegment::of(curve));
    at = curve.to;
  }
}

// Returns the loop of an outline. What does not close around the axis is closed along it.
SectionLoop loopOf(const TurnedOutline& outline, double tolerance, double spacing) {
  SectionLoop loop;
  ProfilePoint start(0.0, outline.sides.front().front().y());
  if (outline.isClosed) start = outline.sides.front().front();
  ProfilePoint at = start;
  for (const auto& side : outline.sides) appendSide(loop, at, refitted(side, tolerance, spacing));
  if (!outline.isClosed) lineTo(loop, at, {0.0, at.y()});
  lineTo(loop, at, start);
  return loop;
}

SectionSource::Pointer sourceOf(const TurnedProfile& profile) {
  return profile.section() ? profile.section() : SectionSource::fitted(profile);
}

// Takes the samples that a cut changed from the section.
TurnedProfile::Range take(TurnedProfile& profile, TurnedSection section, const SectionRemoval& removal) {
  TurnedProfile::Range changed;
  if (removal.isEmpty()) {
    profile.setSection(SectionSource::of(std::move(section)));
    return changed;
  }
  const double beside = profile.spacing();
  const TurnedProfile::Range near =
      samplesWithin(profile, removal.gone.min().y() - beside, removal.gone.max().y() + beside);
  changed = section.sample(profile, near);
  profile.setSection(SectionSource::of(std::move(section)));
  return changed;
}

}  // namespace

TurnedSection fittedSection(const TurnedProfile& samples, double tolerance) {
  std::vector<SectionLoop> loops;
  for (const TurnedOutline& outline : outlinesOf(samples)) {
    loops.push_back(loopOf(outline, tolerance, samples.spacing()));
    for (const auto& cavity : outline.cavities) {
      SectionLoop loop;
      ProfilePoint at = cavity.front();
      appendSide(loop, at, refitted(cavity, tolerance, samples.spacing()));
      lineTo(loop, at, cavity.front());
      // The hollow is on the right of its boundary.
      if (areaOf(loop) > 0.0) {
        std::reverse(loop.begin(), loop.end());
        for (SectionSegment& segment : loop) segment = segment.reversed();
      }
      loops.push_back(std::move(loop));
    }
  }
  return TurnedSection(loops);
}

std::optional<ExactStep> cutExactly(TurnedProfile& profile, const TurningPass& how, const ProfileSegment& move,
                                    const WholeMove& whole, std::uint32_t number) {
  SectionSource::Pointer source = sourceOf(profile);
  const bool isBeside = !how.isOfProgram && isBesideMaterial(source->section(), how, move);
  if (isBeside || !mayCut(source->section(), how, move)) {
    profile.setSection(source);
    return ExactStep();
  }
  profile.setSection(nullptr);
  TurnedSection section = SectionSource::taken(std::move(source));
  const auto removal = cutMove(section, how, move, whole, number);
  // A section that could not be cut is no more the one of the part.
  if (!removal) return std::nullopt;
  return ExactStep{take(profile, std::move(section), *removal), *removal};
}

TurnedProfile::Range settlePass(TurnedProfile& after, const TurnedProfile& before, const SectionSource::Pass& pass,
                                std::uint32_t number, Progress progress) {
  const SectionSource::Pointer source = sourceOf(before);
  if (pass->thread) {
    after.setSection(source);
    return {};
  }
  if (pass->isExact) {
    TurnedSection section = source->section();
    after = before;
    std::uint64_t work = kWorkOfAPass;
    if (const auto removal = cutPass(section, *pass, number, work, progress))
      return take(after, std::move(section), *removal);
    TurnedProfile::Range changed;
    const PassSteps steps(*pass, number);
    for (std::size_t i = 0; i < pass->path.size() && !progress.cancelled(); ++i) changed.extend(steps.cut(after, i));
    return changed;
  }
  after.setSection(SectionSource::after(source, pass, number, after));
  return {};
}

SectionSource::Pointer SectionSource::of(TurnedSection section) {
  const std::shared_ptr<SectionSource> source(new SectionSource);
  source->m_section = std::move(section);
  source->m_isKnown = true;
  return source;
}

SectionSource::Pointer SectionSource::fitted(const TurnedProfile& samples) {
  return after(nullptr, nullptr, 0, samples);
}

SectionSource::Pointer SectionSource::after(Pointer before, Pass pass, std::uint32_t number,
                                            const TurnedProfile& after) {
  const std::shared_ptr<SectionSource> source(new SectionSource);
  source->m_before = std::move(before);
  source->m_pass = std::move(pass);
  source->m_number = number;
  auto samples = std::make_shared<TurnedProfile>(after);
  samples->setSection(nullptr);
  source->m_samples = std::move(samples);
  return source;
}

// A long chain of sources is taken apart one by one: each would otherwise destroy the next within its own destructor.
SectionSource::~SectionSource() {
  Pointer next = std::move(m_before);
  while (next && next.use_count() == 1) {
    Pointer before = std::move(next->m_before);
    next = std::move(before);
  }
}

TurnedSection SectionSource::taken(Pointer source) {
  const TurnedSection& section = source->section();
  if (source.use_count() > 1) return section;
  return std::move(*source->m_section);
}

const TurnedSection& SectionSource::section() const {
  prepare({});
  return *m_section;
}

bool SectionSource::prepare(Progress progress) const {
  const std::lock_guard lock(m_mutex);
  return m_section || compute(progress);
}

bool SectionSource::compute(Progress progress) const {
  std::vector<Pointer> chain;  // sources whose section is not known yet, the latest first
  std::optional<TurnedSection> section;
  for (Pointer at = m_before; at && !section;) {
    const std::lock_guard lock(at->m_mutex);
    section = at->m_section;
    chain.push_back(at);
    at = Pointer(chain.back()->m_before);
  }
  if (section) chain.pop_back();
  std::uint64_t work = 10 * kWorkOfAPass;  // the limit for all passes together
  const auto cut = [&](const SectionSource& source) {
    std::uint64_t ofPass = std::min(work, kWorkOfAPass);
    work -= ofPass;
    const bool isCut = section && source.m_pass && cutPass(*section, *source.m_pass, source.m_number, ofPass, progress);
    work += ofPass;
    if (!isCut && !progress.cancelled()) section = fittedSection(*source.m_samples, kFitTolerance);
  };
  // If there is too much work, only the samples of the last pass count.
  for (auto source = chain.rbegin(); source != chain.rend() && work > 0 && !progress.cancelled(); ++source)
    cut(**source);
  if (work == 0) section.reset();
  cut(*this);
  if (progress.cancelled()) return false;
  m_section = std::move(section);
  m_before.reset();
  m_isKnown = true;
  return true;
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/section/SectionCut.h"

#include <atomic>
#include <memory>
#include <mutex>

namespace handwheel {

// The exact section of a part, which is computed when it is first asked for.
//
// A pass made by hand has thousands of points. The window ends such a pass without waiting for its section; who
// measures, draws or exports the part computes it, usually in a job. All functions may be called on any thread.
class SectionSource {
 public:
  using Pointer = std::shared_ptr<const SectionSource>;
  using Pass = std::shared_ptr<const TurningPass>;

  static Pointer of(TurnedSection section);
  // Returns the section after one more pass. after: the samples of the part after the pass. If the pass cannot be
  // subtracted exactly, for example because it moved control points, lines and arcs are fitted to them.
  static Pointer after(Pointer before, Pass pass, std::uint32_t number, const TurnedProfile& after);
  // Returns a section that is fitted to samples.
  static Pointer fitted(const TurnedProfile& samples);

  ~SectionSource();
  SectionSource(const SectionSource&) = delete;
  SectionSource& operator=(const SectionSource&) = delete;

  const TurnedSection& section() const;       // blocks until it is computed
  bool isKnown() const { return m_isKnown; }  // section() returns at once
  // Computes the section. Returns false if it was cancelled.
  bool prepare(Progress progress) const;
  // Returns the section of a source that may be given up. It is copied only if the source has other owners.
  static TurnedSection taken(Pointer source);

 private:
  SectionSource() = default;
  bool compute(Progress progress) const;

  mutable std::mutex m_mutex;
  mutable std::optional<TurnedSection> m_section;
  mutable std::atomic<bool> m_isKnown = false;  // may be asked while another thread computes
  mutable Pointer m_before;                     // null once the section is known
  Pass m_pass;
  std::uint32_t m_number = 0;
  std::shared_ptr<const TurnedProfile> m_samples;
};

// One move of a pass, cut into the exact section of a part.
struct ExactStep {
  TurnedProfile::Range changed;  // samples that changed
  SectionRemoval removal;
};
// Cuts one move of an exact pass into the section of a part, and takes the changed samples from it. Returns nothing if
// the section could not be cut: the samples are as before, and the part has no section. A part without a section first
// gets one that is fitted to its samples.
// whole: the move that `move` is a piece of (cutMove()).
std::optional<ExactStep> cutExactly(TurnedProfile& profile, const TurningPass& how, const ProfileSegment& move,
                                    const WholeMove& whole, std::uint32_t number);

// Gives a part its section after a pass that has cut it step by step. before: the part before the pass. The samples of
// an exact pass (TurningPass::isExact) are taken from the section. Returns the samples that changed since `before`, if
// the pass is exact.
TurnedProfile::Range settlePass(TurnedProfile& after, const TurnedProfile& before, const SectionSource::Pass& pass,
                                std::uint32_t number, Progress progress = {});

// Returns the section of the samples of a part: lines and arcs that stay within `tolerance` (mm) of them. A part in
// several pieces gives several loops. O(samples log samples).
TurnedSection fittedSection(const TurnedProfile& samples, double tolerance);

}  // namespace handwheel

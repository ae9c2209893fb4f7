// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/thread/PartThreads.h"

#include <optional>
#include <vector>

namespace handwheel {

// A replay of the passes of a turned part. It shows what the part was like at any time of its passes, pauses between
// passes left out. It repeats the passes, so that the end is the part bit for bit. Immutable; any thread.
class PassesReplay {
 public:
  static constexpr std::size_t kVersions =
      256;  // that are kept at most, so that a moment costs such a part of the whole

  struct Moment {
    TurnedProfile profile;
    std::shared_ptr<const PartThreads> threads;  // null: none
    std::shared_ptr<const TurningPass> pass;     // that is being cut; null: there is none
    std::size_t number = 0;                      // of the pass, from 0
    ProfilePoint place{0.0, 0.0};                // mm: where its path is, (r, z)
  };

  // bar: before the first pass. None: cancelled. O(all that the passes cut).
  static std::optional<PassesReplay> make(TurnedProfile bar, TurningPasses passes, Progress progress = {});

  double duration() const { return m_begins.back(); }              // s
  double begin(std::size_t pass) const { return m_begins[pass]; }  // s
  const TurningPasses& passes() const { return m_passes; }
  Moment at(double seconds) const;  // before the begin it is the begin, after the end the end

 private:
  PassesReplay(TurnedProfile bar, TurningPasses passes);
  // The points of a pass that were reached at a time since its begin.
  static std::size_t reached(const TurningPass& pass, double seconds);
  std::shared_ptr<const PartThreads> threadsAt(std::size_t pass, std::size_t points, const ProfilePoint& place) const;

  struct Version {
    std::size_t pass = 0, points = 0;  // that were cut of this pass, and all passes before
    TurnedProfile profile;
  };
  TurningPasses m_passes;
  std::vector<double> m_begins;                               // s, of each pass, and the end
  std::vector<std::shared_ptr<const PartThreads>> m_threads;  // before each pass
  std::vector<Version> m_versions;                            // ascending; they share their pages
};

}  // namespace handwheel

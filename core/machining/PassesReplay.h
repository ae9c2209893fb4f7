// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/thread/PartThreads.h"

#include <optional>
#include <vector>

namespace handwheel {

// A replay of the passes of a turned part. It gives the part at any time of its passes; the pauses between passes do
// not count. It repeats the passes exactly, so that the last moment equals the part bit for bit. A replay is immutable
// and may be used on any thread.
class PassesReplay {
 public:
  static constexpr std::size_t kVersions =
      256;  // Largest number of versions that are kept. at() repeats at most about one part in kVersions of all passes.

  struct Moment {
    TurnedProfile profile;
    std::shared_ptr<const PartThreads> threads;  // null: none
    std::shared_ptr<const TurningPass> pass;     // the pass that is being cut; null: none
    std::size_t number = 0;                      // index of the pass, from 0
    ProfilePoint position{0.0, 0.0};             // position on the path of the pass, (r, z), mm
  };

  // Creates a replay. bar: the part before the first pass. Returns nothing if it was cancelled. O(samples that all
  // passes visit).
  static std::optional<PassesReplay> make(TurnedProfile bar, TurningPasses passes, Progress progress = {});

  double duration() const { return m_begins.back(); }              // s
  double begin(std::size_t pass) const { return m_begins[pass]; }  // s
  const TurningPasses& passes() const { return m_passes; }
  Moment at(double seconds) const;  // the time is clamped to 0 and duration()

 private:
  PassesReplay(TurnedProfile bar, TurningPasses passes);
  // Returns the number of points of a pass that were reached by a time (s), counted from the start of the pass.
  static std::size_t reached(const TurningPass& pass, double seconds);
  std::shared_ptr<const PartThreads> threadsAt(std::size_t pass, std::size_t points,
                                               const ProfilePoint& position) const;

  struct Version {
    std::size_t pass = 0, points = 0;  // pass and number of its points that were cut; earlier passes are complete
    TurnedProfile profile;
    TurnedProfile before;  // the part at the begin of the pass
  };
  TurningPasses m_passes;
  std::vector<double> m_begins;                               // s; start of each pass, and the end of the last one
  std::vector<std::shared_ptr<const PartThreads>> m_threads;  // threads before each pass
  std::vector<Version> m_versions;                            // in ascending order; all share their pages
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/finish/SurfaceFinish.h"

#include <deque>
#include <vector>

namespace handwheel {

// How far a tool went in the last revolution of the spindle while it cut. From point to point the hand and the clock of
// the mouse give anything.
class FeedMeter {
 public:
  void clear();
  // Of one more move. way: mm. mm per revolution; infinite while the spindle stands.
  double add(double way, double turns, bool isTurning);

 private:
  struct Move {
    double way, turns;
  };
  std::deque<Move> m_moves;
  double m_way = 0.0, m_turns = 0.0;
};

// Follows passes move by move and marks the finish that they leave. An edge leaves what its feed and nose leave:
// f²/(32 R); a drill what drills leave (drilledRoughness()). What is abrasive takes the crests off: those of a nose are
// four times as high as their Ra, f²/(8 R) and f²/(32 R), so that Ra falls by a quarter of what leaves; once as much
// has gone, the surface is that of the abrasive, which no further passes make finer. Only samples whose radius changes
// are marked; of an edge those alone of which it takes more than TurningPass::kTouch while it goes one way: work that
// has sprung back is touched by the tool on its way home, and stays as it is. The finish is a function of bar and
// passes: whoever follows the same moves gets the same. One thread.
class FinishMeter {
 public:
  // profile: the part before the next move. finish: of it; of another size: nothing is known. usualSpeed: r/min of
  // passes that do not tell theirs; 0: what these leave is not known.
  FinishMeter(TurnedProfile profile, SurfaceFinish finish, double usualSpeed = 0.0);

  // The move to point i of a pass, which is the one of this number in the part. profile: after it; changed: the samples
  // that may have. O(changed).
  void add(const TurningPass& pass, std::size_t i, std::uint32_t number, const TurnedProfile& profile,
           const TurnedProfile::Range& changed);

  const SurfaceFinish& finish() const { return m_finish; }
  // mm per revolution, of the last move; 0 where it cut nothing; infinite while the spindle stood.
  double feed() const { return m_feed; }

 private:
  FinishMark markOf(const TurningPass& pass, std::size_t i, const FinishMark& before, double removed) const;
  void follow(TurningSide side, std::size_t i, double radius);
  void endContact();

  TurnedProfile m_profile;
  SurfaceFinish m_finish;
  double m_usualSpeed;
  FeedMeter m_meter;
  std::uint32_t m_number = FinishMark::kNoPass;
  double m_feed = 0.0;
  std::vector<double> m_taken[2];  // mm, by side: off each sample in this contact
  TurnedProfile::Range m_touched;  // in this contact
  TurnedProfile::Range m_first;    // that the first point of the pass has changed, and no mark tells yet
};

// Cuts a pass as cut() does, and marks the finish. Incomplete when it was cancelled.
TurnedProfile::Range cut(TurnedProfile& profile, const TurningPass& pass, std::uint32_t number, FinishMeter& meter,
                         Progress progress = {});

}  // namespace handwheel

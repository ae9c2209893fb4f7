// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/finish/SurfaceFinish.h"

#include <deque>
#include <vector>

namespace handwheel {

// Measures the distance that a cutting tool covered in the last revolution of the spindle. The feed from point to point
// is useless, since hand movements and mouse timestamps are irregular.
class FeedMeter {
 public:
  void clear();
  // Adds one more move. distance: mm. Returns mm per revolution; infinite while the spindle stands.
  double add(double distance, double turns, bool isTurning);

 private:
  struct Move {
    double distance, turns;
  };
  std::deque<Move> m_moves;
  double m_distance = 0.0, m_turns = 0.0;
};

// Follows passes move by move and marks the finish that they leave. An edge leaves the roughness of its feed and nose,
// f²/(32 R); a drill that of drilling (drilledRoughness()). An abrasive tool removes the crests: those of a nose are
// four times as high as their Ra, f²/(8 R) and f²/(32 R), so that Ra falls by a quarter of the depth removed; once as
// much is removed, the surface is that of the abrasive, which no further passes make finer. Only samples whose radius
// changes are marked; by an edge only those of which it removes more than TurningPass::kTouch while it goes in one
// direction: work that has sprung back is touched by the returning tool, and keeps its finish. The finish is a function
// of bar and passes: the same moves give the same finish. One thread.
class FinishMeter {
 public:
  // profile: the part before the next move. finish: its finish; if it has another size, nothing is known. usualSpeed:
  // spindle speed of passes that do not record theirs, r/min; 0: their finish is not known.
  FinishMeter(TurnedProfile profile, SurfaceFinish finish, double usualSpeed = 0.0);

  // Adds the move to point i of a pass, which has this number in the part. profile: the part after the move; changed:
  // the samples that may have changed. O(changed).
  void add(const TurningPass& pass, std::size_t i, std::uint32_t number, const TurnedProfile& profile,
           const TurnedProfile::Range& changed);

  const SurfaceFinish& finish() const { return m_finish; }
  // Feed of the last move, mm per revolution; 0 if it cut nothing; infinite while the spindle stood.
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
  std::vector<double> m_taken[2];  // mm, by side: depth removed from each sample in this contact
  TurnedProfile::Range m_touched;  // samples touched in this contact
  TurnedProfile::Range m_first;    // samples that the first point of the pass has changed and that have no mark yet
};

// Cuts a pass like cut(), and marks the finish. Incomplete if it was cancelled.
TurnedProfile::Range cut(TurnedProfile& profile, const TurningPass& pass, std::uint32_t number, FinishMeter& meter,
                         Progress progress = {});

}  // namespace handwheel

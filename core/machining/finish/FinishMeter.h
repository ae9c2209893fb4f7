// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/finish/SurfaceFinish.h"

#include <deque>
#include <vector>

namespace handwheel {

// Measures the distance that a cutting tool covered in the last revolution of the spindle. The feed from point to point
// would be useless, because hand movements and mouse timestamps are irregular.
class FeedMeter {
 public:
  void clear();
  // Adds a move and returns the feed, mm per revolution. The feed is infinite while the spindle is at rest. distance:
  // the length of the move, mm. turns: the revolutions of the spindle during the move.
  double add(double distance, double turns, bool isTurning);

 private:
  struct Move {
    double distance, turns;
  };
  std::deque<Move> m_moves;
  double m_distance = 0.0, m_turns = 0.0;
};

// Follows passes move by move and marks the finish that they leave. An edge leaves the roughness of its feed and nose,
// f²/(32 R); a drill leaves the roughness of drilling (drilledRoughness()). An abrasive tool removes the crests. The
// crests of a nose are f²/(8 R) high, four times their Ra, so Ra falls by a quarter of the removed depth. It does not
// fall below the roughness of the abrasive, which no further passes make finer. Only samples whose radius changes are
// marked. An edge marks a sample only if it removes more than TurningPass::kTouch from the sample while it moves in one
// direction: work that has sprung back is touched by the returning tool, but keeps its finish. The finish is a function
// of bar and passes: the same moves give the same finish. A meter may be used by one thread at a time.
class FinishMeter {
 public:
  // profile: the part before the next move. finish: the finish of this part; if it has another number of samples, the
  // finish is taken as unknown. usualSpeed: the spindle speed of passes that do not record a speed, r/min; 0: the
  // finish of such passes is not known.
  FinishMeter(TurnedProfile profile, SurfaceFinish finish, double usualSpeed = 0.0);

  // Adds the move to point i of a pass. number: the index of the pass in the part. profile: the part after the move.
  // changed: the samples that may have changed. O(changed).
  void add(const TurningPass& pass, std::size_t i, std::uint32_t number, const TurnedProfile& profile,
           const TurnedProfile::Range& changed);

  // Continues with these samples of the part, for example after they were taken from its exact section.
  void renew(const TurnedProfile& profile) { m_profile = profile; }

  const SurfaceFinish& finish() const { return m_finish; }
  // Returns the feed of the last move, mm per revolution. The feed is 0 if the move cut nothing, and infinite if the
  // spindle was at rest.
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
  std::vector<double> m_taken[2];  // mm, depth removed from each sample in this contact, for each side
  TurnedProfile::Range m_touched;  // samples touched in this contact
  TurnedProfile::Range m_first;    // samples that the first point of the pass has changed and that have no mark yet
};

// Cuts a pass into the profile and marks the finish. Returns the samples that changed. If cancelled, only the first
// moves of the pass are cut.
TurnedProfile::Range cut(TurnedProfile& profile, const std::shared_ptr<const TurningPass>& pass, std::uint32_t number,
                         FinishMeter& meter, Progress progress = {});

}  // namespace handwheel

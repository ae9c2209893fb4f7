// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/program/ProgramObstacles.h"
#include "machining/program/ProgramSetup.h"
#include "machining/program/ToolPath.h"
#include "machining/section/SectionCut.h"
#include "machining/target/ProfileSegment.h"
#include "machining/thread/PartThreads.h"

#include <optional>
#include <set>
#include <utility>

namespace handwheel {

// A motion of a program that would damage the machine, such as a collision.
struct ProgramCollision {
  enum class Kind {
    RapidInMaterial,  // a rapid move through the part
    Chuck,            // the tip went beyond the face of the chuck
    SpindleAtRest,    // a feed into the part that does not turn
    Contact,          // contact of two parts of the lathe: a holder, a slide, the tailstock
  };
  Kind kind = Kind::RapidInMaterial;
  std::uint32_t line = 0;
  ProfilePoint at{0, 0};  // mm, (r, z) in the coordinates of the program, end of the move
  // mm, (r, z) from the lower end of the part; centre of the nose when it first took material, or position of a contact
  ProfilePoint position{0, 0};
  double time = 0.0;                          // s, program time at the end of the move
  LathePart moving = LathePart::CuttingEdge;  // for Kind::Contact
  LathePart struck = LathePart::Work;
  std::size_t passes = 0;  // number of passes of the program up to this time
};

// The state of the spindle after a thread was cut. The spindle keeps turning while threads follow one another.
struct ThreadLead {
  ProfilePoint end{0, 0};  // position of the tip after the last move
  double turns = 0.0;      // revolutions since the start of the first of these threads
  TurningSide side = TurningSide::Outside;
};

// The state that the next move of a program depends on, besides the profile of the part.
struct ProgramState {
  bool isDrilling = false;                     // the tool has drilled and is still on the axis
  int drill = -1;                              // number of the tool that moved last
  bool isBeyond = false;                       // true if that tool is beyond the axis
  std::optional<ThreadLead> lead;              // set if the last move was a thread
  std::shared_ptr<const PartThreads> threads;  // threads of the part; null: none
  std::size_t passes = 0;                      // number of passes that the part has, without one that may go on
};

// Returns the mirror image of a move at the axis.
ToolMove mirrored(const ToolMove& move);

// Cuts a part along the tool path of a program, move by move.
//
// The upper end of the part, without ProgramSetup::allowance, is z = 0 of the program. The chuck grips the lower end
// over ProgramSetup::grip, where no tool may be beside the part. A tool cuts with its nose, or as a point if it has
// none. Beyond the axis, at negative X, it cuts as its mirror image. It removes all material between the nose and the
// side of its shank, which is the outside, or the axis for a tool whose tip points outwards. A feed along the axis
// towards the chuck drills, with the nose as the drill, until the tool leaves the axis. Rapid moves, and feeds with the
// spindle at rest, cut as well; such a move is a collision if it meets material. A spindle that turns away from the
// edge is a note at the first such feed of a tool. A thread is a pass of its own. It does not change the profile, which
// is the envelope; its flanks are at 60°. If the body of a tool is known, contacts of its holder, its post and its
// slide are checked once in each millimetre of travel. A move costs what subtracting it from
// the section costs (TurnedSection). A simulation may be used by one
// thread at a time.
class ProgramSimulation {
 public:
  static constexpr std::size_t kMostCollisions = 1000;  // limit of stored collisions; collisionCount() counts all
  static constexpr double kChord = 1e-4;                // mm, chord tolerance of an arc

  // setup: the machine and its tools. before: the state of the part. done: number of moves of the path that were made
  // already. Path and setup must outlive the simulation.
  ProgramSimulation(TurnedProfile part, const ToolPath& path, const ProgramSetup& setup,
                    const ProgramState& before = {}, std::size_t done = 0);

  // Makes the next move, or the first part of it. Returns false after the last move. The changed samples are added to
  // the range that takeChanged() returns. share: part of the move, 0 < share ≤ 1; less than 1: no further move follows.
  bool step(double share = 1.0);
  // Makes all remaining moves. Returns false if it was cancelled.
  bool run(Progress progress);

  std::size_t done() const { return m_next; }  // number of moves made
  const TurnedProfile& part() const { return m_part; }
  ProgramState state() const;
  TurnedProfile::Range takeChanged() { return std::exchange(m_changed, {}); }
  double time() const { return m_time; }  // s, program time

  const std::vector<ProgramCollision>& collisions() const { return m_collisions; }
  std::size_t collisionCount() const { return m_collisionCount; }
  // Returns remarks on results that the author of a program may not expect, such as a drill without diameter.
  const std::vector<ToolPath::Note>& notes() const { return m_notes; }
  // Returns the cutting moves as passes that reproduce the part, and removes them from the simulation.
  std::vector<TurningPass> takePasses() { return std::move(m_passes); }

 private:
  struct Removal {
    double area = 0.0, depth = 0.0;  // mm², mm
  };
  const ToolMove* moveAfter(const ToolMove& move, std::size_t n) const;
  void followSide(const ToolMove& move);
  void followDrill(const ToolMove& move);
  TurningPass shapeOf(const ToolMove& move) const;
  double deepestOf(const ProfilePoint& a, const ProfilePoint& b, const TurningPass& shape) const;
  // The material that a move removed: its largest depth (mm, in r), and the first position of the nose in it.
  struct Taken {
    double deepest = 0.0;
    ProfilePoint position{0, 0};
  };
  // whole: the move as it is written.
  Taken cutMove(const ToolMove& move, const ToolMove& whole, const TurningPass& shape);
  ProfilePoint inwardEndOf(const ToolMove& whole, const TurningPass& shape);
  void judge(const ToolMove& move, const Taken& taken, double nose);
  void judgeSpin(const ToolMove& move);
  // Returns the vector from the centre of the nose to the tip in radii, (r, z), of the tool of a move or its mirror
  // image.
  ProfilePoint tipOf(const ToolMove& move) const;
  // A piece of a move: the path of the nose centre, or of the tip of a body.
  struct RecordedPiece {
    ProfileSegment move;
    double begin = 0.0, end = 0.0;  // s, program time
    double speed = 0.0;             // r/min
    bool isOfSameArc = false;       // the piece before is of the same move
  };
  Removal cutPiece(const TurningPass& shape, const ProfileSegment& piece, const WholeMove& whole, std::uint32_t number);
  bool isDrawnBack(const ToolMove& move, const TurningPass& shape, const ProfileSegment& path) const;
  Removal cutSamples(const TurningPass& shape, const ProfilePoint& a, const ProfilePoint& b);
  bool continuesPass(const TurningPass& shape, const ProfilePoint& a) const;
  void endPass();
  void record(const TurningPass& shape, const RecordedPiece& piece, bool isCut);
  void append(const RecordedPiece& piece);
  double zeroHeight() const { return m_part.length() - m_setup.allowance; }  // z of program zero in the part
  bool collide(ProgramCollision::Kind kind, const ToolMove& move, const ProfilePoint& position);
  static bool isThread(const ToolMove& move);
  TurningPass threadOf(const ToolMove& move) const;
  void cutThread(const ToolMove& move);
  bool leavesThread(const ToolMove& move) const;
  ProfilePoint toCentre(const ToolMove& move, double nose) const;
  bool isInChuck(const ProfilePoint& low, TurningSide side) const;
  void meetChuck(const ToolMove& move, double nose, TurningSide side, const ProfilePoint& position);
  int piecesOf(const ToolMove& move) const;
  void meetBody(const ToolMove& move, const ProfilePoint& centre, double nose);
  void followBody(const ToolMove& move);

  TurnedProfile m_part;
  const ToolPath& m_path;
  const ProgramSetup& m_setup;
  double m_largest;  // mm, initial radius of the part
  std::size_t m_next;
  std::size_t m_inwardMoves = 0;  // the moves before it go on inward from the last one, to m_inwardEnd
  ProfilePoint m_inwardEnd{0, 0};
  std::size_t m_sideMoves = 0;      // the moves before it are on the side of the axis where the tool is
  std::size_t m_axisMoves = 0;      // the moves before it are on the axis
  bool m_isFacingFromAxis = false;  // the tool then faces outward
  double m_time = 0.0;
  TurnedProfile::Range m_changed;
  std::vector<ProgramCollision> m_collisions;
  std::size_t m_collisionCount = 0;
  std::uint32_t m_lastCollision = 0;  // line of the last collision
  bool m_isInChuck = false;           // the tip was in the chuck at the end of the last move
  std::vector<ToolPath::Note> m_notes;
  std::set<int> m_wrongSpins;  // tools that cut while the spindle turned away from their edge
  ProgramState m_state;
  std::size_t m_passesBefore;  // number of passes of the part before the program
  ProgramObstacles m_obstacles;
  bool m_isTouching = false;  // the body of the tool touched something at the end of the last move
  std::vector<TurningPass> m_passes;
  bool m_isPassOpen = false;           // the next move may continue the last pass
  bool m_wasRapid = false;             // the last move was rapid
  std::vector<RecordedPiece> m_uncut;  // pieces of the last pass since its last cut
  double m_passBegin = 0.0;            // s, program time at the start of the last pass
};

}  // namespace handwheel

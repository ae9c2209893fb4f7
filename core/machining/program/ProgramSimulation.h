// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/force/ForcePeaks.h"
#include "machining/program/ProgramObstacles.h"
#include "machining/program/ProgramSetup.h"
#include "machining/program/ToolPath.h"
#include "machining/thread/PartThreads.h"

#include <optional>
#include <utility>

namespace handwheel {

// A motion of a program that would damage the machine, such as a collision.
struct ProgramCollision {
  enum class Kind {
    RapidInMaterial,  // a rapid move through the part
    Chuck,            // the tip beyond the face of the chuck
    SpindleAtRest,    // a feed into the part that does not turn
    SpindleReversed,  // a feed into the part that turns away from the edge (M4)
    Contact,          // contact of two parts of the lathe: a holder, a slide, the tailstock
  };
  Kind kind = Kind::RapidInMaterial;
  std::uint32_t line = 0;
  ProfilePoint at{0, 0};  // mm, (r, z) of the program, end of the move
  // mm, (r, z) from the lower end of the part: the nose where it first took material, or the position of a contact.
  ProfilePoint position{0, 0};
  double time = 0.0;                          // s, program time at the end of the move
  LathePart moving = LathePart::CuttingEdge;  // for Kind::Contact
  LathePart struck = LathePart::Work;
  std::size_t passes = 0;  // passes of the program by then
};

// A thread that was just cut: the spindle goes on turning while threads follow one another.
struct ThreadLead {
  ProfilePoint end{0, 0};  // position of the tip after the last move
  double turns = 0.0;      // revolutions since the first of them began
  TurningSide side = TurningSide::Outside;
};

// The state besides the part's profile that the next move of a program depends on.
struct ProgramState {
  bool isDrilling = false;                     // the tool is on the axis and has drilled there
  int drill = -1;                              // number of the drill
  std::optional<ThreadLead> lead;              // the last move was a thread
  std::shared_ptr<const PartThreads> threads;  // threads of the part, for forces; null: none
};

// Cuts a part along the tool path of a program, move by move.
//
// The upper end of the part is z = 0 of the program; it is gripped at the lower end, over ProgramSetup::grip, where no
// tool may be beside it. A tool cuts with its nose, or as a point if it has none, and removes all material between it
// and the side of its shank: the outside, or the axis for a tool whose tip points outwards. A feed along the axis
// towards the chuck drills, with the nose as the drill, until the tool leaves the axis. A rapid move cuts, too, and so
// does a feed with the spindle at rest or reversed; each is a collision where it meets material. A thread is a pass of
// its own, which leaves the profile, the envelope, as it is; its flanks are at 60°. If the body of a tool is known,
// contacts of its holder, its post and its slide are checked once a millimetre. Cost: O(samples below the moves). One
// thread.
class ProgramSimulation {
 public:
  static constexpr std::size_t kMostCollisions = 1000;  // limit of stored collisions; all are counted
  static constexpr double kChord = 1e-4;                // mm, chord tolerance of an arc

  // setup: for the tools. model: force law; may be null. before: the state after the moves before the path. Path, setup
  // and model must outlive the simulation.
  ProgramSimulation(TurnedProfile part, const ToolPath& path, const ProgramSetup& setup,
                    const CuttingForceModel* model = nullptr, const ProgramState& before = {});

  // Makes the next move; returns false after the last. Changed samples are added to changed().
  bool step();
  // Makes all remaining moves. Returns false when cancelled.
  bool run(Progress progress);

  std::size_t done() const { return m_next; }  // number of moves
  const TurnedProfile& part() const { return m_part; }
  const ProgramState& state() const { return m_state; }
  TurnedProfile::Range takeChanged() { return std::exchange(m_changed, {}); }
  double time() const { return m_time; }  // s

  const std::vector<ProgramCollision>& collisions() const { return m_collisions; }
  std::size_t collisionCount() const { return m_collisionCount; }
  // Remarks on results that the reader of a program may not expect, such as a drill without diameter.
  const std::vector<ToolPath::Note>& notes() const { return m_notes; }
  // Returns the largest force and power so far; zero without a model.
  ForcePeaks peaks();
  // Returns the cutting moves, as passes that reproduce the part.
  std::vector<TurningPass> takePasses() { return std::move(m_passes); }

 private:
  struct Removal {
    double area = 0.0, depth = 0.0, radius = 0.0;  // mm², mm, mm
  };
  void followDrill(const ToolMove& move);
  TurningPass shapeOf(const ToolMove& move) const;
  double deepestOf(const ProfilePoint& a, const ProfilePoint& b, const TurningPass& shape) const;
  // The material that a move removed: its largest depth (mm, in r), and the first position of the nose in it.
  struct Taken {
    double deepest = 0.0;
    ProfilePoint position{0, 0};
  };
  Taken cutMove(const ToolMove& move, const TurningPass& shape);
  void judge(const ToolMove& move, const Taken& taken, double nose);
  TurnedProfile::Range samplesBelow(const ProfilePoint& a, const ProfilePoint& b, double nose) const;
  Removal cutPiece(const TurningPass& shape, const ProfilePoint& a, const ProfilePoint& b);
  void record(const TurningPass& shape, const ProfilePoint& a, const ProfilePoint& b, double begin, double end,
              double speed);
  double zeroHeight() const { return m_part.length() - m_setup.allowance; }  // z of program zero in the part
  ForcePeakMeter& meterOf(const ToolMove& move);
  bool collide(ProgramCollision::Kind kind, const ToolMove& move, const ProfilePoint& position);
  static bool isThread(const ToolMove& move);
  TurningPass threadOf(const ToolMove& move) const;
  void cutThread(const ToolMove& move);
  void meetThread(const ToolMove& move, const TurningPass& pass, const ThreadGroove& groove);
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
  const CuttingForceModel* m_model;
  double m_largest;  // mm, initial radius of the part
  std::size_t m_next = 0;
  double m_time = 0.0;
  TurnedProfile::Range m_changed;
  std::vector<ProgramCollision> m_collisions;
  std::size_t m_collisionCount = 0;
  std::uint32_t m_lastCollision = 0;  // line of the last collision
  bool m_isInChuck = false;           // since the last move
  std::vector<ToolPath::Note> m_notes;
  ProgramState m_state;
  ProgramObstacles m_obstacles;
  bool m_isTouching = false;  // with a body, since the last move
  std::vector<TurningPass> m_passes;
  double m_passBegin = 0.0;  // s, program time at the begin of the last pass
  std::optional<ForcePeakMeter> m_meter;
  SpindleSetting m_spindle;
  ForcePeaks m_peaks;
};

}  // namespace handwheel

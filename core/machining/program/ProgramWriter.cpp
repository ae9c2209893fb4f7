// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramWriter.h"

#include "base/NumberText.h"
#include "base/Translatable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace handwheel {

namespace {

constexpr double kWritten = 1e-4;     // mm, resolution of a coordinate
constexpr double kSlowest = 1.0;      // mm/min
constexpr double kUsualFeed = 100.0;  // mm/min, if the times are not known
constexpr double kClearOfWall = 0.2;  // mm; clearance of a tool that goes into a bore or out of it

// Returns a number with four decimals and always a point: for Fanuc a number without one is in thousandths.
std::string decimal(double value) {
  const double rounded = std::round(value / kWritten) * kWritten;
  std::array<char, 40> text{};
  const int size = std::snprintf(text.data(), text.size(), "%.4f", rounded == 0.0 ? 0.0 : rounded);
  std::string digits(text.data(), static_cast<std::size_t>(std::max(size, 0)));
  while (digits.ends_with('0')) digits.pop_back();
  return digits;
}

// Writes the words of a program and keeps its modal state.
class Writer {
 public:
  Writer(ProgramDialect dialect, const std::string& title, std::span<const std::string> comments)
      : m_isFanuc(dialect == ProgramDialect::Fanuc) {
    line((m_isFanuc ? "%\nO0001 " : "") + comment(title));
    for (const std::string& text : comments) line(comment(text));
    line(m_isFanuc ? "G21 G18 G40 G99" : "G21 G18 G40 G49 G90 G91.1 G7");
  }

  void add(const ToolMove& move) {
    if (m_tool != move.tool) changeTool(move.tool);
    setSpindle(move);
    switch (move.kind) {
      case ToolMove::Kind::Rapid:
        line("G0" + coordinates(move));
        break;
      case ToolMove::Kind::Dwell:
        line(m_isFanuc ? "G4 U" + decimal(move.time) : "G4 P" + decimal(move.time));
        break;
      case ToolMove::Kind::Thread:
        line((m_isFanuc ? "G32" : "G33") + coordinates(move) +
             (m_isFanuc ? " F" + decimal(lead(move)) : " K" + decimal(move.feed)));
        m_feed = -1.0;
        break;
      case ToolMove::Kind::Feed:
        feed(move);
        break;
    }
    m_at = move.to;
  }

  std::string finish() {
    line(m_isFanuc ? "M30\n%" : "M2");
    return std::move(m_text);
  }

 private:
  void line(const std::string& words) { m_text += words + "\n"; }

  static std::string comment(const std::string& text) {
    std::string inside;
    for (const char c : text)
      if (c >= ' ' && c <= '~' && c != '(' && c != ')') inside += c;
    return "(" + inside + ")";
  }

  // Fanuc measures the lead along the longer axis.
  static double lead(const ToolMove& move) {
    const ProfilePoint along = move.to - move.from;
    return along.norm() > 0.0 ? move.feed * along.cwiseAbs().maxCoeff() / along.norm() : move.feed;
  }

  void changeTool(int tool) {
    m_tool = tool;
    std::array<char, 16> number{};
    std::snprintf(number.data(), number.size(), m_isFanuc ? "T%02d%02d" : "T%d M6 G43", tool % 100, tool % 100);
    line(number.data());
    m_spindle.clear();
  }

  void setSpindle(const ToolMove& move) {
    if (move.spin == 0) return;
    const std::string speed = roundedText(move.spindle, 6), most = roundedText(move.mostSpindle, 6);
    std::string words;
    if (!move.isSurfaceSpeed)
      words = "G97 S" + speed;
    else if (m_isFanuc)
      words = (move.mostSpindle > 0.0 ? "G50 S" + most + "\n" : "") + "G96 S" + speed;
    else
      words = "G96 S" + speed + (move.mostSpindle > 0.0 ? " D" + most : "");
    words += move.spin > 0 ? " M3" : " M4";
    if (words == m_spindle) return;
    m_spindle = words;
    line(words);
  }

  void feed(const ToolMove& move) {
    std::string words;
    if (m_feedMode != (move.isPerRevolution ? 1 : 0)) {
      m_feedMode = move.isPerRevolution ? 1 : 0;
      m_feed = -1.0;
      words = move.isPerRevolution ? (m_isFanuc ? "G99 " : "G95 ") : (m_isFanuc ? "G98 " : "G94 ");
    }
    words += move.turn == 0 ? "G1" : move.turn > 0 ? "G3" : "G2";
    words += coordinates(move);
    if (move.turn != 0)
      words += " I" + decimal(move.centre.x() - m_at.x()) + " K" + decimal(move.centre.y() - m_at.y());
    if (move.feed != m_feed) words += " F" + decimal(std::max(move.feed, kWritten));
    m_feed = move.feed;
    line(words);
  }

  static std::string coordinates(const ToolMove& move) {
    return " X" + decimal(2.0 * move.to.x()) + " Z" + decimal(move.to.y());
  }

  bool m_isFanuc;
  std::string m_text, m_spindle;
  int m_tool = -1, m_feedMode = -1;
  double m_feed = -1.0;
  ProfilePoint m_at{0, 0};
};

// Returns the tool number among these tools; 0: none of them.
int toolNumberIn(const std::vector<PassTool>& tools, const TurningPass& pass) {
  for (const PassTool& known : tools) {
    const bool isBoth = known.tool && pass.tool;
    const bool isSame =
        isBoth ? *known.tool == *pass.tool
               : !known.tool && !pass.tool && known.noseRadius == pass.noseRadius && known.side == pass.side;
    if (isSame) return known.number;
  }
  return 0;
}

// Returns the spindle revolutions in the move to each point of a pass; empty: not recorded.
std::vector<double> turnsOf(const TurningPass& pass) {
  if (pass.speeds.size() != pass.path.size() || pass.times.size() != pass.path.size()) return {};
  std::vector<double> turns(pass.path.size(), 0.0);
  double sum = 0.0;
  for (std::size_t i = 1; i < turns.size(); ++i)
    sum += turns[i] = (pass.times[i] - pass.times[i - 1]) * pass.speeds[i] / 60.0;
  return sum > 0.0 ? turns : std::vector<double>();
}

// Returns true if the tool was brought to a point faster than it cuts.
bool isTraverse(const std::vector<ProfilePoint>& path, const std::vector<double>& turns, std::size_t i) {
  constexpr double kFastestCut = 2.0;  // mm in a turn
  return !turns.empty() && (path[i] - path[i - 1]).norm() > kFastestCut * turns[i];
}

// Returns the feed in mm in a turn, from one point of a path to another, as it is written.
double feedBetween(const std::vector<ProfilePoint>& path, const std::vector<double>& turns, std::size_t from,
                   std::size_t to) {
  constexpr double kFastest = 10.0;  // mm in a turn, for a tool that moves clear of the work
  double distance = 0.0, sum = 0.0;
  for (std::size_t i = from + 1; i <= to; ++i) {
    distance += (path[i] - path[i - 1]).norm();
    sum += turns[i];
  }
  const double feed = sum > 0.0 ? std::clamp(distance / sum, kWritten, kFastest) : kFastest;
  return std::round(feed / kWritten) * kWritten;
}

// Returns the indices of the points of a path that are needed to stay within the tolerance of all. The point at which a
// tool begins to cut after a traverse stays.
std::vector<std::size_t> thinned(const std::vector<ProfilePoint>& path, const std::vector<double>& turns,
                                 double tolerance) {
  std::vector<std::size_t> kept{0};
  std::size_t from = 0;
  const auto fits = [&](std::size_t to) {
    const ProfilePoint along = path[to] - path[from];
    const double length = along.squaredNorm();
    for (std::size_t i = from + 1; i < to; ++i) {
      const ProfilePoint off = path[i] - path[from];
      const double t = length > 0.0 ? std::clamp(off.dot(along) / length, 0.0, 1.0) : 0.0;
      if ((off - t * along).norm() > tolerance) return false;
    }
    return true;
  };
  constexpr std::size_t kLongest = 1000;  // points of one line; the cost of a try is quadratic
  for (std::size_t to = 1; to < path.size(); ++to) {
    const bool isSame = to + 1 < path.size() && isTraverse(path, turns, to) == isTraverse(path, turns, to + 1);
    if (isSame && to + 1 - from < kLongest && fits(to + 1)) continue;
    kept.push_back(to);
    from = to;
  }
  return kept;
}

// Returns the path of the tip that repeats one start of a thread, as deep and in the same groove: the spindle runs
// forward, so a right-hand thread goes towards the chuck, and all passes begin a whole number of leads from one
// another, the starts a pitch.
std::vector<ProfilePoint> threadTips(const TurningPass& pass, const ProfilePoint& toTip, int start) {
  std::vector<ProfilePoint> tips;
  const double middle = pass.tool ? pass.tool->noseCentre().y() : 0.0;  // middle of the groove, from the path
  for (const ProfilePoint& point : pass.path) tips.emplace_back(point.x() + toTip.x(), point.y() + middle);
  if ((tips.front().y() < tips.back().y()) != pass.thread->isLeft) std::reverse(tips.begin(), tips.end());
  const double lead = pass.thread->lead(), offset = pass.thread->offset + start * pass.thread->pitch;
  const double turns = (tips.front().y() - offset) / lead;
  const double begin = offset + lead * (pass.thread->isLeft ? std::floor(turns) : std::ceil(turns));
  if (begin != tips.front().y()) tips.insert(tips.begin(), {tips.front().x(), begin});
  for (ProfilePoint& tip : tips) tip.y() += toTip.y() - middle;
  return tips;
}

// Returns the mean feed along the pass, mm/min.
double feedOf(const TurningPass& pass) {
  double distance = 0.0;
  for (std::size_t i = 1; i < pass.path.size(); ++i) distance += (pass.path[i] - pass.path[i - 1]).norm();
  const double seconds = pass.times.empty() ? 0.0 : pass.times.back() - pass.times.front();
  return seconds > 0.0 ? std::max(kSlowest, 60.0 * distance / seconds) : kUsualFeed;
}

bool isDrilled(const TurningPass& pass) {
  return pass.tool && pass.tool->kind == LatheToolKind::Drill;
}

// The moves that repeat recorded passes, one pass after another. Between them the tool is above the part, and for a
// bore in front of it.
class PassMoves {
 public:
  PassMoves(const StockCylinder& stock, double zero, const PassProgram& how, double spindle, std::uint16_t tool)
      : m_radius(0.5 * stock.diameter),
        m_above(m_radius + how.clearance),
        m_front(stock.length - zero + how.clearance),
        m_zero(zero),
        m_tolerance(how.tolerance) {
    m_move.tool = tool;
    m_move.spin = 1;
    m_move.spindle = spindle;
    m_move.from = m_move.to = {m_above, m_front};
    go(ToolMove::Kind::Rapid, m_move.to);
  }

  void add(const TurningPass& pass, std::uint16_t tool) {
    const bool isBored = pass.side == TurningSide::Bore;
    if (isBored)
      go(ToolMove::Kind::Rapid, {m_above, m_front});  // with the previous tool: a boring tool has no room elsewhere
    m_move.tool = tool;
    const double nose = pass.tool ? 0.0 : pass.noseRadius;  // the path of a tool is that of its tip
    const ProfilePoint toTip(isBored ? nose : -nose, -nose - m_zero);
    if (pass.thread) {
      for (int start = 0; start < pass.thread->starts; ++start) cutThread(threadTips(pass, toTip, start), pass);
      return;
    }
    const std::vector<double> turns = turnsOf(pass);
    std::vector<Stretch> path;
    std::size_t before = 0;
    for (const std::size_t i : thinned(pass.path, turns, m_tolerance)) {
      path.push_back({pass.path[i] + toTip, turns.empty() || i == 0 ? 0.0 : feedBetween(pass.path, turns, before, i)});
      before = i;
    }
    m_move.isPerRevolution = !turns.empty();
    if (turns.empty())
      for (Stretch& stretch : path) stretch.feed = feedOf(pass);
    else
      path.front().feed = path.size() > 1 ? path[1].feed : feedBetween(pass.path, turns, 0, pass.path.size() - 1);
    if (isBored)
      bore(path, isDrilled(pass));
    else
      turn(path);
    m_move.isPerRevolution = false;
  }

  std::vector<ToolMove> take() { return std::move(m_moves); }

 private:
  // A straight move of the tip.
  struct Stretch {
    ProfilePoint to{0, 0};
    double feed = 0.0;  // mm/min, or mm in a turn
  };

  void cutAlong(const std::vector<Stretch>& path) {
    for (const Stretch& stretch : path) {
      m_move.feed = stretch.feed;
      go(ToolMove::Kind::Feed, stretch.to);
    }
  }

  void go(ToolMove::Kind kind, const ProfilePoint& to) {
    m_move.kind = kind;
    m_move.from = m_move.to;
    m_move.to = to;
    m_moves.push_back(m_move);
  }

  void turn(const std::vector<Stretch>& path) {
    go(ToolMove::Kind::Rapid, {m_above, m_move.to.y()});
    go(ToolMove::Kind::Rapid, {m_above, path.front().to.y()});
    cutAlong(path);
    go(ToolMove::Kind::Feed, {std::max(m_above, m_move.to.x()), m_move.to.y()});
  }

  // Moves in and out along the axis, clear of the wall that it cuts and of the remains of earlier passes with the same
  // tool: a pass may begin in a groove behind a narrower mouth. A drill feeds all along the hole: a rapid move does not
  // drill. A path that ends beside the bar leaves upwards.
  void bore(const std::vector<Stretch>& path, bool isDrill) {
    double inner = path.front().to.x();
    for (const Stretch& stretch : path) inner = std::min(inner, stretch.to.x());
    inner = isDrill ? 0.0 : std::max(0.0, inner - kClearOfWall);
    double& narrowest = m_narrowest.try_emplace(m_move.tool, inner).first->second;
    inner = narrowest = std::min(narrowest, inner);
    go(ToolMove::Kind::Rapid, {inner, m_front});
    if (!isDrill) go(ToolMove::Kind::Rapid, {inner, std::min(m_front, path.front().to.y() + kClearOfWall)});
    cutAlong(path);
    const bool isBeside = m_move.to.x() >= m_radius;
    go(ToolMove::Kind::Feed, {isBeside ? m_above : inner, m_move.to.y()});
    go(ToolMove::Kind::Rapid, {m_move.to.x(), std::max(m_front, m_move.to.y())});
    go(ToolMove::Kind::Rapid, {m_above, m_move.to.y()});
  }

  // In a bore the tool comes from the front, as far from its thread as it was when it began.
  void cutThread(const std::vector<ProfilePoint>& tips, const TurningPass& pass) {
    double clear = m_above;
    m_move.feed = kUsualFeed;
    if (pass.side == TurningSide::Bore) {
      for (const ProfilePoint& tip : tips) clear = std::min(clear, tip.x());
      clear = std::max(0.0, clear - kClearOfWall - isoMetricDepth(pass.thread->pitch));
      go(ToolMove::Kind::Rapid, {clear, m_front});
    } else {
      go(ToolMove::Kind::Rapid, {clear, m_move.to.y()});
    }
    go(ToolMove::Kind::Rapid, {clear, tips.front().y()});
    go(ToolMove::Kind::Rapid, tips.front());
    for (std::size_t i = 1; i < tips.size(); ++i) {
      const ProfilePoint displacement = tips[i] - tips[i - 1];
      if (displacement.y() == 0.0) continue;
      m_move.feed = pass.thread->lead() * displacement.norm() / std::abs(displacement.y());
      go(ToolMove::Kind::Thread, tips[i]);
    }
    go(ToolMove::Kind::Rapid, {clear, m_move.to.y()});
    if (pass.side != TurningSide::Bore) return;
    go(ToolMove::Kind::Rapid, {clear, std::max(m_front, m_move.to.y())});
    go(ToolMove::Kind::Rapid, {m_above, m_move.to.y()});
  }

  double m_radius, m_above, m_front, m_zero, m_tolerance;  // mm, in the coordinates of the program
  std::map<std::uint16_t, double> m_narrowest;             // mm, narrowest bore that a tool has entered
  ToolMove m_move;
  std::vector<ToolMove> m_moves;
};

}  // namespace

void MeanSpindle::add(const TurningPass& pass) {
  for (const double turns : turnsOf(pass)) m_turns += turns;
  if (pass.speeds.empty()) return;
  for (std::size_t i = 1; i < std::min(pass.times.size(), pass.speeds.size()); ++i) {
    if (pass.speeds[i] > 0.0) m_seconds += pass.times[i] - pass.times[i - 1];
  }
}

double MeanSpindle::speed() const {
  const double mean = m_seconds > 0.0 && m_turns > 0.0 ? std::round(60.0 * m_turns / m_seconds) : kUsual;
  return std::isfinite(mean) ? std::clamp(mean, 1.0, kMostSpindle) : kUsual;
}

int PassTool::orientationIn(ProgramDialect dialect) const {
  if (tool) return handwheel::orientationOf(*tool, dialect);
  return side == TurningSide::Bore ? boreOrientation(dialect) : outsideOrientation(dialect);
}

std::vector<PassTool> toolsOf(std::span<const TurningPass> passes) {
  std::vector<PassTool> tools;
  for (const TurningPass& pass : passes) {
    if (toolNumberIn(tools, pass) != 0) continue;
    const double nose =
        pass.tool ? programToolOf(pass.tool, ProgramDialect::LinuxCnc).noseRadius : pass.noseRadius;  // in any dialect
    tools.push_back({static_cast<int>(tools.size()) + 1, nose, pass.tool, pass.side});
  }
  return tools;
}

std::string descriptionOf(const PassTool& tool, ProgramDialect dialect) {
  return "T" + std::to_string(tool.number) + ": " + (tool.tool ? tool.tool->designation + ", " : "") + "nose " +
         shortestText(tool.noseRadius) + ", orientation " + std::to_string(tool.orientationIn(dialect));
}

std::optional<PassRefusal> refusalToProgram(const TurningPass& pass) {
  const ThreadCut usual;
  if (pass.thread && (std::abs(pass.thread->angle - usual.angle) > 1e-6 || pass.thread->flat > 0.0))
    return PassRefusal::ThreadEdge;
  if (!pass.tool) return std::nullopt;
  if (pass.tool->isAbrasive()) return PassRefusal::Abrasive;
  const bool isBoring = pass.tool->kind == LatheToolKind::BoringBar || pass.tool->kind == LatheToolKind::Drill;
  const TurningSide side = isBoring ? TurningSide::Bore : pass.tool->side;
  return side == pass.side ? std::nullopt : std::optional(PassRefusal::WrongSide);
}

const char* sentenceOf(PassRefusal refusal) {
  switch (refusal) {
    case PassRefusal::Abrasive:
      return translatable("LathePart", "A file, paper or a disk follows the hand, not a program.");
    case PassRefusal::ThreadEdge:
      return translatable("LathePart", "Programs cut threads with a point of 60°, which this thread does not have.");
    case PassRefusal::WrongSide:
      break;
  }
  return translatable("LathePart", "The tool cut on a side that it is not made for.");
}

std::string programText(std::span<const ToolMove> moves, ProgramDialect dialect, const std::string& title,
                        std::span<const std::string> comments) {
  Writer writer(dialect, title, comments);
  for (const ToolMove& move : moves) writer.add(move);
  return writer.finish();
}

void setSpins(std::span<ToolMove> moves, const ProgramTools& tools, const ProgramPost& post) {
  for (ToolMove& move : moves) {
    const auto tool = tools.find(move.tool);
    const bool drills = tool != tools.end() && tool->second.body && tool->second.body->kind == LatheToolKind::Drill;
    if (move.spin != 0 && move.kind != ToolMove::Kind::Thread && !drills)
      move.spin = static_cast<std::int8_t>(post.cuttingSpin());
  }
}

std::vector<ToolMove> movesOf(std::span<const TurningPass> passes, const StockCylinder& stock, double zero,
                              const PassProgram& how) {
  if (passes.empty()) return {};
  const std::vector<PassTool> tools = toolsOf(passes);
  MeanSpindle recorded;
  for (const TurningPass& pass : passes) recorded.add(pass);
  const double spindle = how.spindle > 0.0 ? how.spindle : recorded.speed();
  PassMoves moves(stock, zero, how, spindle, static_cast<std::uint16_t>(toolNumberIn(tools, passes.front())));
  for (const TurningPass& pass : passes) {
    if (!pass.path.empty()) moves.add(pass, static_cast<std::uint16_t>(toolNumberIn(tools, pass)));
  }
  return moves.take();
}

}  // namespace handwheel

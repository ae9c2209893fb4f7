// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/arm/ReachSection.h"

#include "robot/arm/NumericalIk.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <set>

namespace handwheel {

namespace {

using Node = std::array<int, 2>;

constexpr double kPositionTolerance = 1e-3;  // mm
constexpr Node kSteps[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

// The grid in the plane, and its reached nodes.
class ReachGrid {
 public:
  ReachGrid(const SerialArm& arm, const Pose& tool, const Vec3& direction, const ReachSectionSettings& settings)
      : m_arm(arm.withTool(tool)), m_settings(settings), m_across(direction) {
    m_across.z() = 0.0;
    m_across = m_across.norm() > 0.0 ? Vec3(m_across.normalized()) : Vec3::UnitX();
    m_spacing = m_arm.reach() / settings.cells;
    m_most = settings.cells + 1;
  }

  Vec3 positionOf(const Node& node) const { return m_spacing * (node[0] * m_across + node[1] * Vec3::UnitZ()); }
  bool isReached(const Node& node) const { return m_reached.contains(node); }
  const std::map<Node, ArmValues>& reached() const { return m_reached; }

  // Returns joint values that bring the tool to a position; none: it is out of reach.
  std::optional<ArmValues> valuesAt(const Vec3& position, const ArmValues& start, std::uint32_t starts) const {
    Pose wanted = Pose::Identity();
    wanted.translation() = position;
    NumericalIkSettings ik{.tolerance = kPositionTolerance / 1000.0, .seconds = 1.0, .mostStarts = starts};
    ik.turnWeight = 0.0;
    const NumericalIkResult result = solvedNumerically(m_arm, wanted, start, ik);
    return result.isSolved ? std::optional(result.values) : std::nullopt;
  }

  // Proceeds from node to node, beginning near the present position of the arm.
  void flood(const ArmValues& start, Progress progress) {
    const Vec3 tool = m_arm.tipPose(start).translation();
    const Node first{static_cast<int>(std::lround(std::hypot(tool.x(), tool.y()) / m_spacing)),
                     static_cast<int>(std::lround(tool.z() / m_spacing))};
    std::deque<Node> open;
    std::set<Node> tried;
    const auto look = [&](const Node& node, const ArmValues& from) {
      const bool isOutside = std::max(std::abs(node[0]), std::abs(node[1])) > m_most;
      if (isOutside || !tried.insert(node).second) return;
      const auto values = valuesAt(positionOf(node), from, m_settings.starts);
      if (!values) return;
      m_reached[node] = *values;
      open.push_back(node);
    };
    look(first, start);
    for (const Node& step : kSteps) look({first[0] + step[0], first[1] + step[1]}, start);
    while (!open.empty() && !progress.cancelled()) {
      const Node node = open.front();
      open.pop_front();
      for (const Node& step : kSteps) look({node[0] + step[0], node[1] + step[1]}, m_reached[node]);
    }
  }

  // Returns the end of the reach between a reached node and its unreached neighbour.
  Vec3 endBetween(const Node& inside, const Node& outside) const {
    Vec3 near = positionOf(inside), far = positionOf(outside);
    ArmValues values = m_reached.at(inside);
    while ((far - near).norm() > m_settings.tolerance) {
      const Vec3 middle = 0.5 * (near + far);
      const auto there = valuesAt(middle, values, 2);
      if (there) values = *there;
      (there ? near : far) = middle;
    }
    return near;
  }

 private:
  SerialArm m_arm;
  ReachSectionSettings m_settings;
  Vec3 m_across;
  double m_spacing = 1.0;  // mm
  int m_most = 0;          // nodes to each side
  std::map<Node, ArmValues> m_reached;
};

// An end of the reach on an edge of the grid: the reached node, and the other one.
using End = std::pair<Node, Node>;

// The outlines as chains of ends (marching squares): around each cell the ends are joined in pairs, so that the reached
// region is on one side.
class Outlines {
 public:
  explicit Outlines(const ReachGrid& grid) : m_grid(grid) {
    std::set<Node> cells;
    for (const auto& [node, values] : grid.reached()) {
      for (const Node& step : {Node{0, 0}, Node{-1, 0}, Node{0, -1}, Node{-1, -1}})
        cells.insert({node[0] + step[0], node[1] + step[1]});
    }
    for (const Node& cell : cells) join(cell);
  }

  std::vector<std::vector<Vec3>> lines(Progress progress) {
    std::vector<std::vector<Vec3>> all;
    const double count = static_cast<double>(std::max<std::size_t>(1, m_next.size()));
    double done = 0.0;
    while (!m_next.empty() && !progress.cancelled()) {
      std::vector<Vec3> line;
      for (auto next = m_next.begin(); next != m_next.end();) {
        const auto [from, to] = *next;
        line.push_back(m_grid.endBetween(from.first, from.second));
        m_next.erase(next);
        next = m_next.find(to);
        progress.set(++done / count);
        if (progress.cancelled()) return {};
      }
      line.push_back(line.front());
      all.push_back(std::move(line));
    }
    return all;
  }

 private:
  // Goes round the cell from corner to corner: from the corner at which the reach is left, the outline continues to the
  // one at which it was last entered.
  void join(const Node& cell) {
    const std::array<Node, 4> corners{Node{cell[0], cell[1]}, Node{cell[0] + 1, cell[1]},
                                      Node{cell[0] + 1, cell[1] + 1}, Node{cell[0], cell[1] + 1}};
    for (std::size_t i = 0; i < 4; ++i) {
      const Node &here = corners[i], &there = corners[(i + 1) % 4];
      if (!m_grid.isReached(here) || m_grid.isReached(there)) continue;
      // The run of reached corners that ends here began at its entry.
      std::size_t begin = i;
      while (m_grid.isReached(corners[(begin + 3) % 4])) begin = (begin + 3) % 4;
      m_next[{here, there}] = {corners[begin], corners[(begin + 3) % 4]};
    }
  }

  const ReachGrid& m_grid;
  std::map<End, End> m_next;
};

}  // namespace

std::vector<std::vector<Vec3>> reachSection(const SerialArm& arm, const Pose& tool, const ArmValues& start,
                                            const Vec3& direction, const ReachSectionSettings& settings,
                                            Progress progress) {
  if (arm.size() == 0 || !(arm.reach() > 0.0) || !start.allFinite()) return {};
  ReachGrid grid(arm, tool, direction, settings);
  grid.flood(start, progress.part(0.0, 0.5));
  if (progress.cancelled()) return {};
  std::vector<std::vector<Vec3>> lines = Outlines(grid).lines(progress.part(0.5, 1.0));
  return progress.cancelled() ? std::vector<std::vector<Vec3>>() : lines;
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/cycles/RoughAndFinish.h"

#include <utility>

namespace handwheel {

// Collects the moves of the tip of an outside tool. Positions are positions of the centre of its nose, (r, z), mm.
class CyclePath {
 public:
  explicit CyclePath(const CycleSettings& settings) : m_toTip(-settings.nose, -settings.nose) {
    m_move.spin = 1;
    m_move.isSurfaceSpeed = true;
    m_move.spindle = settings.speed;
    m_move.mostSpindle = settings.mostSpindle;
    m_move.isPerRevolution = true;
  }
  void tool(int number, double feed) {
    m_move.tool = static_cast<std::uint16_t>(number);
    m_move.feed = feed;
  }
  void rapid(const ProfilePoint& to) { go(ToolMove::Kind::Rapid, 0, to, to); }
  void feed(const ProfilePoint& to) { go(ToolMove::Kind::Feed, 0, to, to); }
  void along(const ToolMove& move) { go(ToolMove::Kind::Feed, move.turn, move.to, move.centre); }
  const ProfilePoint& at() const { return m_at; }
  std::vector<ToolMove> take() { return std::move(m_moves); }

 private:
  void go(ToolMove::Kind kind, std::int8_t turn, const ProfilePoint& to, const ProfilePoint& centre) {
    if (turn == 0 && to == m_at && !m_moves.empty()) return;
    ToolMove move = m_move;
    move.kind = kind;
    move.turn = turn;
    move.from = m_at + m_toTip;
    move.to = to + m_toTip;
    move.centre = centre + m_toTip;
    if (kind == ToolMove::Kind::Rapid) move.feed = 0.0;
    m_moves.push_back(move);
    m_at = to;
  }
  ProfilePoint m_toTip, m_at{0, 0};
  ToolMove m_move;
  std::vector<ToolMove> m_moves;
};

}  // namespace handwheel

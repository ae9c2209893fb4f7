// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"

#include <cstdint>
#include <vector>

namespace handwheel {

// Edit that moves some joints of a cell.
class JointEdit : public Edit {
 public:
  struct Move {
    std::uint32_t dof;
    double value;  // rad, mm; within the limits
  };

  // moves: at least one move; no joint may occur twice.
  explicit JointEdit(std::vector<Move> moves) : m_moves(std::move(moves)) {}

  void exchange(Document& document) override;
  bool absorb(const Edit& later) override;  // Absorbs only an edit of the same joints
  std::size_t bytes() const override { return sizeof *this + m_moves.size() * sizeof(Move); }

 private:
  std::vector<Move> m_moves;
};

}  // namespace handwheel

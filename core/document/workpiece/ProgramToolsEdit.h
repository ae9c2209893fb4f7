// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "document/workpiece/WorkpieceSnapshot.h"

namespace handwheel {

// An edit that replaces the tool table for programs of a workpiece.
class ProgramToolsEdit : public Edit {
 public:
  explicit ProgramToolsEdit(std::shared_ptr<const ProgramTools> tools) : m_tools(std::move(tools)) {}

  void exchange(Document& document) override;
  std::size_t bytes() const override;

 private:
  std::shared_ptr<const ProgramTools> m_tools;
};

// An edit that replaces the tool post of the machine for programs of a workpiece.
class ProgramPostEdit : public Edit {
 public:
  explicit ProgramPostEdit(const ProgramPost& post) : m_post(post) {}

  void exchange(Document& document) override;
  std::size_t bytes() const override { return sizeof *this; }

 private:
  ProgramPost m_post;
};

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "document/workpiece/WorkpieceSnapshot.h"

namespace handwheel {

// An edit that replaces the part cut from a bar, for example after a pass. Versions of the part share unchanged data.
class TurnedPartEdit : public Edit {
 public:
  explicit TurnedPartEdit(std::shared_ptr<const TurnedPart> part) : m_part(std::move(part)) {}

  void exchange(Document& document) override;
  std::size_t bytes() const override;

 private:
  std::shared_ptr<const TurnedPart> m_part;
};

// Returns the part of a workpiece after one more pass. The passes stay the same if the new pass touches nothing.
// Returns null if cancelled. spacing: the distance between the samples of an uncut bar, mm.
std::shared_ptr<const TurnedPart> withPass(const WorkpieceSnapshot& workpiece, TurningPass pass, double spacing,
                                           Progress progress = {});

// Returns the part of a workpiece after several passes. The triangles are made only once. Returns null if cancelled or
// if there are no passes.
std::shared_ptr<const TurnedPart> withPasses(const WorkpieceSnapshot& workpiece, std::vector<TurningPass> passes,
                                             double spacing, Progress progress = {});

// Returns the present part of a workpiece. An uncut bar gives a part without passes, whose samples are `spacing` (mm)
// apart.
TurnedPart partOf(const WorkpieceSnapshot& workpiece, double spacing);

// Provides the present part of one document. The object keeps the triangles of an uncut bar, so that a view need not
// build them again, for example after undo of the only pass.
class PresentPart {
 public:
  explicit PresentPart(double spacing) : m_spacing(spacing) {}
  TurnedPart of(const WorkpieceSnapshot& workpiece) const;

 private:
  double m_spacing;                                  // mm, distance between the samples of a bar
  mutable std::shared_ptr<const StockMesh> m_stock;  // the bar that m_bar was made from
  mutable std::shared_ptr<const TurnedPart> m_bar;   // null: not made yet
};

}  // namespace handwheel

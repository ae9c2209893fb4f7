// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "document/workpiece/WorkpieceSnapshot.h"

namespace handwheel {

// An edit that replaces the part cut from a bar, for example after a pass. Versions share unchanged data.
class TurnedPartEdit : public Edit {
 public:
  explicit TurnedPartEdit(std::shared_ptr<const TurnedPart> part) : m_part(std::move(part)) {}

  void exchange(Document& document) override;
  std::size_t bytes() const override;

 private:
  std::shared_ptr<const TurnedPart> m_part;
};

// Returns the part of a workpiece after one more pass; the same passes if it touches nothing. Cancelled: null.
std::shared_ptr<const TurnedPart> withPass(const WorkpieceSnapshot& workpiece, TurningPass pass, double spacing,
                                           Progress progress = {});

// Does the same for several passes, and makes the triangles once. Also null if there are no passes.
std::shared_ptr<const TurnedPart> withPasses(const WorkpieceSnapshot& workpiece, std::vector<TurningPass> passes,
                                             double spacing, Progress progress = {});

// Returns the present part; for an uncut bar a part without passes, with samples at this distance (mm).
TurnedPart partOf(const WorkpieceSnapshot& workpiece, double spacing);

// The present part of one document, from version to version. An uncut bar keeps its triangles, for example after undo
// of the only pass, so that a view need not build them again.
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

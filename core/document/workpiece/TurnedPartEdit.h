// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "document/workpiece/WorkpieceSnapshot.h"

namespace handwheel {

// An edit that replaces the part cut from a bar, as by one pass. Versions share what did not change.
class TurnedPartEdit : public Edit {
 public:
  explicit TurnedPartEdit(std::shared_ptr<const TurnedPart> part) : m_part(std::move(part)) {}

  void exchange(Document& document) override;
  std::size_t bytes() const override;

 private:
  std::shared_ptr<const TurnedPart> m_part;
};

// The part of a workpiece after one more pass; the same passes where it touches nothing. Cancelled: null.
std::shared_ptr<const TurnedPart> withPass(const WorkpieceSnapshot& workpiece, TurningPass pass, double spacing,
                                           Progress progress = {});

// The same after several, whose triangles are made once; null where there are none, too.
std::shared_ptr<const TurnedPart> withPasses(const WorkpieceSnapshot& workpiece, std::vector<TurningPass> passes,
                                             double spacing, Progress progress = {});

// The present part; of an uncut bar a part without passes, with samples at this distance (mm).
TurnedPart partOf(const WorkpieceSnapshot& workpiece, double spacing);

// The present part of one document from version to version. An uncut bar keeps its triangles, as by undo of the only
// pass, so that a view has none of them to build again.
class PresentPart {
 public:
  explicit PresentPart(double spacing) : m_spacing(spacing) {}
  TurnedPart of(const WorkpieceSnapshot& workpiece) const;

 private:
  double m_spacing;                                  // mm, between the samples of a bar
  mutable std::shared_ptr<const StockMesh> m_stock;  // of m_bar
  mutable std::shared_ptr<const TurnedPart> m_bar;   // null: none was asked for yet
};

}  // namespace handwheel

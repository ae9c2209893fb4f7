// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "volume/segment/Segment.h"

namespace handwheel {

// An edit that replaces the segment of a scan. Segments share unchanged bricks, so the edit holds only the changed
// ones.
class SegmentEdit : public Edit {
 public:
  // before: the document's segment, from which the size of the edit is computed.
  SegmentEdit(Segment segment, const Segment& before)
      : m_segment(std::move(segment)),
        m_bytes(sizeof *this + m_segment.bytesBeside(before) + before.bytesBeside(m_segment)) {}

  void exchange(Document& document) override;
  std::size_t bytes() const override { return m_bytes; }

 private:
  Segment m_segment;
  std::size_t m_bytes;
};

}  // namespace handwheel

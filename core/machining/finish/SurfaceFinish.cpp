// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/finish/SurfaceFinish.h"

namespace handwheel {

namespace {

PagedArray<FinishMark> allOf(const FinishMark& mark, std::size_t samples) {
  PagedArray<FinishMark> marks;
  for (std::size_t i = 0; i < samples; ++i) marks.push_back(mark);
  return marks;
}

}  // namespace

SurfaceFinish::SurfaceFinish(std::size_t samples) : m_outer(allOf(FinishMark(), samples)) {}

SurfaceFinish SurfaceFinish::unknown(const TurnedProfile& profile) {
  SurfaceFinish finish;
  finish.m_outer = allOf({FinishMark::kUnknown, 0.0f, FinishMark::kNoPass}, profile.size());
  if (profile.isBored()) finish.m_bore = finish.m_outer;
  return finish;
}

FinishMark SurfaceFinish::at(TurningSide side, std::size_t i) const {
  const PagedArray<FinishMark>& marks = side == TurningSide::Outside ? m_outer : m_bore;
  return i < marks.size() ? marks[i] : FinishMark();
}

void SurfaceFinish::set(TurningSide side, std::size_t i, const FinishMark& mark) {
  if (i >= size()) return;
  if (side == TurningSide::Bore && m_bore.empty()) m_bore = allOf(FinishMark(), size());
  (side == TurningSide::Outside ? m_outer : m_bore).set(i, mark);
}

bool SurfaceFinish::operator==(const SurfaceFinish& other) const {
  if (size() != other.size()) return false;
  for (const TurningSide side : {TurningSide::Outside, TurningSide::Bore}) {
    for (std::size_t i = 0; i < size(); ++i) {
      if (!(at(side, i) == other.at(side, i))) return false;
    }
  }
  return true;
}

}  // namespace handwheel

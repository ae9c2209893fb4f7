// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/ThreadsBeingCut.h"

#include "machining/TurningPass.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace handwheel {

namespace {

constexpr int kPieces = 32;             // pieces of a section
constexpr std::int64_t kMostChips = 8;  // limit for one travel along the helix
constexpr double kSameHelix = 1e-6;     // mm
constexpr double kInMaterial = 1e-6;    // mm

// Returns the nose that a pass is recorded with.
double recordedNose(const LatheTool& tool) {
  return std::max(tool.noseRadius, TurningPass::kLeastNose);
}

// Returns the bottom of the groove of a tool with its tip here, (r, z), like ThreadGroove.
ProfilePoint bottomOf(const LatheTool& tool, const ProfilePoint& tip) {
  const double nose = recordedNose(tool);
  return tip + tool.noseCentre() + ProfilePoint(tool.side == TurningSide::Bore ? nose : -nose, 0.0);
}

double nowhere(TurningSide side) {
  return side == TurningSide::Bore ? 0.0 : std::numeric_limits<double>::infinity();
}

double deeper(TurningSide side, double a, double b) {
  return side == TurningSide::Bore ? std::max(a, b) : std::min(a, b);
}

double outward(TurningSide side) {
  return side == TurningSide::Bore ? -1.0 : 1.0;
}

// Returns the height of the material above the bottom of a groove, within the reach of its flanks, mm.
double heightIn(const TurnedProfile& part, TurningSide side, const ProfilePoint& bottom, const ThreadCut& form,
                double nose) {
  const auto above = [&](std::size_t i) {
    const double envelope = side == TurningSide::Bore ? part.inner(i) : part.radius(i);
    return part.hasMaterial(i) ? std::max(0.0, outward(side) * (envelope - bottom.x())) : 0.0;
  };
  const double at = std::clamp(std::round(bottom.y() / part.spacing()), 0.0, static_cast<double>(part.size() - 1));
  const double reach = form.distanceAt(above(static_cast<std::size_t>(at)), nose);
  const auto range = samplesWithin(part, bottom.y() - reach - part.spacing(), bottom.y() + reach + part.spacing());
  double height = 0.0;
  for (std::size_t i = range.first; i < range.last; ++i) height = std::max(height, above(i));
  return height;
}

}  // namespace

double* ThreadsBeingCut::Helix::at(double z, double spacing) {
  const double sample = std::round(z / spacing) + static_cast<double>(beyond);
  if (!(sample >= 0.0 && sample < static_cast<double>(bottoms.size()))) return nullptr;
  return &bottoms[static_cast<std::size_t>(sample)];
}

// mm from the axis: the envelope, or a deeper groove.
double ThreadsBeingCut::surfaceAt(const TurnedProfile& part, TurningSide side, double z, double angle) const {
  const double at = std::clamp(z / part.spacing(), 0.0, static_cast<double>(part.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(at), part.size() - 2);
  const double share = at - static_cast<double>(i);
  const double outer = std::lerp(part.radius(i), part.radius(i + 1), share);
  const double inner = std::lerp(part.inner(i), part.inner(i + 1), share);
  double surface = side == TurningSide::Bore ? inner : outer;
  if (m_threads) surface = m_threads->radius(side, surface, side == TurningSide::Bore ? outer : inner, z, angle);
  for (const Helix& helix : m_helices) {
    if (helix.side != side) continue;
    const double above = z - helix.thread.offset - helix.thread.rise() * angle / (2.0 * M_PI);
    const double distance = above - helix.thread.pitch * std::round(above / helix.thread.pitch);
    const double* const bottom = helix.at(z - distance, part.spacing());
    if (!bottom) continue;
    surface = deeper(side, surface, *bottom + outward(side) * helix.edge.heightAt(distance));
  }
  return surface;
}

ThreadChip ThreadsBeingCut::chipAt(const TurnedProfile& part, const LatheTool& tool, const ToolPosition& position,
                                   const ProfilePoint* stands) const {
  ThreadChip chip;
  const ThreadCut form;
  const TurningSide side = tool.side;
  const double nose = recordedNose(tool), out = outward(side);
  const ProfilePoint bottom = bottomOf(tool, position.tip);
  const double height = heightIn(part, side, bottom, form, nose);
  if (!(height > 0.0)) return chip;
  const ThreadEdge edge(form, nose);
  const double half = form.distanceAt(height, nose), step = 2.0 * half / kPieces;
  for (int i = 0; i < kPieces; ++i) {
    const double beside = -half + (i + 0.5) * step, z = bottom.y() + beside;
    const double sample = std::round(z / part.spacing());
    if (!(sample >= 0.0 && sample < static_cast<double>(part.size()))) continue;
    if (!part.hasMaterial(static_cast<std::size_t>(sample))) continue;
    double there = surfaceAt(part, side, z, position.angle);
    if (stands) {
      const ProfilePoint stood = bottomOf(tool, *stands);
      there = deeper(side, there, stood.x() + out * edge.heightAt(z - stood.y()));
    }
    const double removed = out * (there - bottom.x()) - edge.heightAt(beside);
    if (!(removed > kInMaterial)) continue;
    chip.section += removed * step;
    chip.radius += (there - 0.5 * out * removed) * removed * step;
    chip.depth = std::max(chip.depth, removed);
    const double rise =
        edge.heightAt(std::abs(beside) + 0.5 * step) - edge.heightAt(std::max(0.0, std::abs(beside) - 0.5 * step));
    chip.edge += std::hypot(step, rise);
  }
  if (chip.section > 0.0) chip.radius /= chip.section;
  return chip;
}

ThreadsBeingCut::Helix& ThreadsBeingCut::helixOf(const TurnedProfile& part, const LatheTool& tool,
                                                 const ThreadCut& thread) {
  const auto isSame = [&](const Helix& each) {
    const double apart = each.thread.offset - thread.offset, pitch = thread.pitch;
    return each.side == tool.side && each.thread.pitch == pitch && each.thread.isLeft == thread.isLeft &&
           each.nose == recordedNose(tool) && std::abs(apart - pitch * std::round(apart / pitch)) < kSameHelix;
  };
  const auto found = std::find_if(m_helices.begin(), m_helices.end(), isSame);
  if (found != m_helices.end()) return *found;
  if (m_helices.size() == kMostHelices) m_helices.pop_front();
  const double beyond = std::ceil(thread.pitch / part.spacing());
  const std::size_t count = part.size() + 2 * static_cast<std::size_t>(beyond);
  const double nose = recordedNose(tool);
  m_helices.push_back({thread, tool.side, nose, ThreadEdge(thread, nose), static_cast<std::ptrdiff_t>(beyond),
                       std::vector<double>(count, nowhere(tool.side))});
  return m_helices.back();
}

// Cuts sample by sample: the next step removes the rest of a sample.
ThreadsBeingCut::Cut ThreadsBeingCut::cut(const TurnedProfile& part, const LatheTool& tool, const ThreadCut& thread,
                                          double from, const ToolPosition& position) {
  Cut cut;
  const ProfilePoint to = position.tip;
  const double middle = bottomOf(tool, to).y(), shift = middle - to.y(), spacing = part.spacing();
  const auto [low, high] = std::minmax({from + shift, middle});
  const double before = -thread.pitch / spacing, last = static_cast<double>(part.size() - 1) - before;
  const auto begin = static_cast<std::int64_t>(std::max(std::round(low / spacing), std::ceil(before)));
  const auto end = static_cast<std::int64_t>(std::min(std::round(high / spacing), std::floor(last)));
  if (begin > end) return cut;
  const std::int64_t stride = (end - begin) / kMostChips + 1;
  for (std::int64_t i = begin; i <= end; i += stride) {
    const std::int64_t next = std::min(i + stride, end + 1);
    const double z = static_cast<double>(i) * spacing,
                 angle = position.angle + 2.0 * M_PI * (z - middle) / thread.rise();
    const ThreadChip chip = chipAt(part, tool, {{to.x(), z - shift}, angle});
    if (!(chip.section > 0.0)) continue;
    const double area = chip.section * static_cast<double>(next - i) * spacing / thread.lead();
    cut.removed.area += area;
    cut.removed.volume += 2.0 * M_PI * chip.radius * area;
    cut.removed.depth = std::max(cut.removed.depth, chip.depth);
    cut.edge = chip.edge;
  }
  Helix& helix = helixOf(part, tool, thread);
  for (std::int64_t i = begin; i <= end; ++i) {
    double* const bottom = helix.at(static_cast<double>(i) * spacing, spacing);
    if (bottom) *bottom = deeper(tool.side, *bottom, bottomOf(tool, to).x());
  }
  return cut;
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/TurnedPartEdit.h"

#include "document/workpiece/WorkpieceDocument.h"
#include "machining/finish/FinishMeter.h"

#include <algorithm>
#include <utility>

namespace handwheel {

void TurnedPartEdit::exchange(Document& document) {
  auto& owner = static_cast<WorkpieceDocument&>(document);
  WorkpieceSnapshot workpiece = owner.workpiece();
  std::swap(workpiece.part, m_part);
  owner.set(std::move(workpiece));
}

// Counts the data that only this edit may hold: the last pass, and the pages of samples that it changed.
std::size_t TurnedPartEdit::bytes() const {
  if (!m_part || m_part->passes.empty()) return sizeof *this;
  const std::size_t points = m_part->passes.back()->path.size();
  return sizeof *this + points * (sizeof(ProfilePoint) + sizeof(double)) +
         PagedArray<double>::kPageSize * (sizeof(double) + sizeof(FinishMark));
}

TurnedPart partOf(const WorkpieceSnapshot& workpiece, double spacing) {
  if (workpiece.part) return *workpiece.part;
  const TurnedProfile profile(workpiece.stock, spacing);
  TurnedPart bar = TurnedPart::of(profile, {}, workpiece.chord);
  bar.finish = SurfaceFinish(profile.size());
  return bar;
}

TurnedPart PresentPart::of(const WorkpieceSnapshot& workpiece) const {
  if (workpiece.part) return *workpiece.part;
  const bool isSame = std::exchange(m_stock, workpiece.mesh) == workpiece.mesh;
  if (!isSame) m_bar = std::make_shared<const TurnedPart>(partOf(workpiece, m_spacing));
  return *m_bar;
}

namespace {

bool cutsThread(const TurnedProfile& profile, const TurningPass& pass) {
  const std::vector<ThreadGroove> grooves = ThreadGroove::of(pass);
  return std::any_of(grooves.begin(), grooves.end(),
                     [&](const ThreadGroove& groove) { return groove.touches(profile); });
}

std::shared_ptr<const TurnedPart> withThread(TurnedPart part, TurningPass pass) {
  if (cutsThread(part.profile, pass)) {
    part.surface.setThreads(part.profile, PartThreads::with(part.threads(), pass), {0, part.profile.size()});
    part.passes.push_back(std::make_shared<const TurningPass>(std::move(pass)));
  }
  return std::make_shared<const TurnedPart>(std::move(part));
}

}  // namespace

std::shared_ptr<const TurnedPart> withPass(const WorkpieceSnapshot& workpiece, TurningPass pass, double spacing,
                                           Progress progress) {
  TurnedPart part = partOf(workpiece, spacing);
  if (pass.thread) return withThread(std::move(part), std::move(pass));
  FinishMeter meter(part.profile, part.finish);
  const auto number = static_cast<std::uint32_t>(part.passes.size());
  const auto shared = std::make_shared<const TurningPass>(std::move(pass));
  const TurnedProfile::Range changed = cut(part.profile, shared, number, meter, progress);
  if (progress.cancelled()) return nullptr;
  part.finish = meter.finish();
  part.surface.update(part.profile, changed);
  if (!changed.isEmpty()) part.passes.push_back(shared);
  return std::make_shared<const TurnedPart>(std::move(part));
}

std::shared_ptr<const TurnedPart> withPasses(const WorkpieceSnapshot& workpiece, std::vector<TurningPass> passes,
                                             double spacing, Progress progress) {
  if (passes.empty()) return nullptr;
  TurnedPart part = partOf(workpiece, spacing);
  FinishMeter meter(part.profile, part.finish);
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const auto number = static_cast<std::uint32_t>(part.passes.size());
    const auto share = [&](std::size_t n) { return static_cast<double>(n) / static_cast<double>(passes.size()); };
    const auto pass = std::make_shared<const TurningPass>(std::move(passes[i]));
    const bool isCut = pass->thread
                           ? cutsThread(part.profile, *pass)
                           : !cut(part.profile, pass, number, meter, progress.part(share(i), share(i + 1))).isEmpty();
    if (progress.cancelled()) return nullptr;
    if (isCut) part.passes.push_back(pass);
  }
  TurnedPart made = TurnedPart::of(std::move(part.profile), std::move(part.passes), workpiece.chord);
  made.finish = meter.finish();
  return std::make_shared<const TurnedPart>(std::move(made));
}

}  // namespace handwheel

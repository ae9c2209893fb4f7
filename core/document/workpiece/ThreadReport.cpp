// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/ThreadReport.h"

#include "base/NumberText.h"
#include "machining/drawing/DrawnThreads.h"
#include "machining/measure/ThreadMeasure.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

struct ThreadRange {
  double from, to;  // mm
};

// The part of a groove that is in the material: a thread runs up before the work and out behind it.
ThreadRange rangeInMaterial(const TurnedPart& part, const ThreadGroove& groove, double position) {
  const auto box = part.section().box();
  const auto within = [&](double z) { return box.isEmpty() ? z : std::clamp(z, box.min().y(), box.max().y()); };
  return {within(groove.from()) + position, within(groove.to()) + position};
}

nlohmann::json threadOf(const TurnedPart& part, const ThreadGroove& groove, double position) {
  const ThreadCut& cut = groove.cut();
  const ThreadRange range = rangeInMaterial(part, groove, position);
  nlohmann::json json = {{"from", range.from},
                         {"to", range.to},
                         {"pitch", cut.pitch},
                         {"starts", cut.starts},
                         {"hand", cut.isLeft ? "left" : "right"},
                         {"inner", groove.side() == TurningSide::Bore},
                         {"measured_pitch", nullptr},
                         {"major_diameter", nullptr},
                         {"pitch_diameter", nullptr},
                         {"minor_diameter", nullptr}};
  const auto reading = measureThread(part.profile, *part.threads(), groove.side(), {groove.from(), groove.to()});
  if (!reading) return json;
  json["measured_pitch"] = reading->pitch;
  json["major_diameter"] = reading->major;
  json["pitch_diameter"] = reading->pitchDiameter;
  json["minor_diameter"] = reading->minor;
  return json;
}

}  // namespace

std::string threadsText(const TurnedPart& part, double position) {
  std::string text;
  for (const ThreadGroove& groove : part.threads()->grooves()) {
    const ThreadRange range = rangeInMaterial(part, groove, position);
    text += (text.empty() ? "" : "; ") + ("pitch " + shownText(groove.cut().pitch)) + " mm, Z " +
            shownText(range.from) + " to " + shownText(range.to);
  }
  return text;
}

nlohmann::json threadsJson(const TurnedPart& part, double position) {
  nlohmann::json all = nlohmann::json::array();
  for (const ThreadGroove& groove : part.threads()->grooves()) all.push_back(threadOf(part, groove, position));
  return all;
}

std::vector<DrawnThread> threadsToDraw(const WorkpieceSnapshot& workpiece) {
  if (!workpiece.part || !workpiece.part->threads()) return {};
  return drawnThreads(workpiece.part->profile, *workpiece.part->threads(), workpiece.stock.position);
}

}  // namespace handwheel

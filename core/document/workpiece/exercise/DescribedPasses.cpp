// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/DescribedPasses.h"

#include "base/JsonText.h"
#include "document/workpiece/exercise/TurningTask.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

namespace handwheel {

namespace {

constexpr double kSecondsPerMinute = 60.0, kUsualFeed = 0.1;  // mm per revolution, where a pass names none

Error malformedPass(const char* what) {
  return {ErrorCode::ElementMalformed, {"passes", what}, {}, {}};
}

// Reads the thread of a pass, sharp or as round as its nose; the first groove begins at the first point.
Result<ThreadCut> threadFrom(const nlohmann::json& json, const TurningPass& pass) {
  ThreadCut thread;
  if (!json.is_object() || !json.contains("pitch") || !json["pitch"].is_number())
    return malformedPass("a thread needs a pitch");
  thread.pitch = json["pitch"].get<double>();
  if (const auto starts = json.find("starts"); starts != json.end() && starts->is_number_unsigned())
    thread.starts = static_cast<int>(std::min<std::uint64_t>(starts->get<std::uint64_t>(), 1'000));
  thread.isLeft = stringAt(json, "hand") == "left";
  if (const auto flat = json.find("flat"); flat != json.end() && flat->is_number()) thread.flat = flat->get<double>();
  thread.offset = pass.path.front().y();
  if (!thread.isSound()) return malformedPass("a thread is impossible");
  return thread;
}

// A pass at a constant feed; of a thread its lead is the feed.
Result<TurningPass> passFrom(const nlohmann::json& json, double spindleSpeed) {
  if (!json.is_object()) return malformedPass("an object was expected");
  const auto number = [&](const char* key, double otherwise) {
    const auto found = json.find(key);
    return found != json.end() && found->is_number() ? found->get<double>() : otherwise;
  };
  TurningPass pass;
  pass.noseRadius = number("nose_radius", AllowedTool().noseRadius);
  if (!(pass.noseRadius >= TurningPass::kLeastNose && pass.noseRadius <= TurningPass::kLargestNose))
    return malformedPass("a nose radius is impossible");
  pass.side = stringAt(json, "side") == "bore" ? TurningSide::Bore : TurningSide::Outside;
  const double feed = number("feed", kUsualFeed), mmPerSecond = feed * spindleSpeed / kSecondsPerMinute;
  if (!(feed > 0.0 && mmPerSecond > 0.0)) return malformedPass("feed and spindle speed must be above 0");
  const auto points = json.find("points");
  if (points == json.end() || !points->is_array() || points->empty() || points->size() > TurningPass::kMostPoints)
    return malformedPass("points were expected");
  for (const nlohmann::json& each : *points) {
    if (!each.is_array() || each.size() != 2 || !each[0].is_number() || !each[1].is_number())
      return malformedPass("points of two numbers each were expected");
    const ProfilePoint p(each[0].get<double>(), each[1].get<double>());
    const double seconds = pass.path.empty() ? 0.0 : (p - pass.path.back()).norm() / mmPerSecond;
    if (!(p.cwiseAbs().maxCoeff() <= StockCylinder::kLargestSize) || !std::isfinite(seconds))
      return malformedPass("a point is too far away");
    pass.times.push_back(pass.times.empty() ? 0.0 : pass.times.back() + seconds);
    pass.path.push_back(p);
  }
  pass.speeds.assign(pass.path.size(), spindleSpeed);
  if (const auto given = json.find("thread"); given != json.end()) {
    const Result<ThreadCut> thread = threadFrom(*given, pass);
    if (!thread) return thread.error();
    pass.thread = *thread;
  }
  return pass;
}

// The one feed of a pass, mm per revolution; none: it changes on the travelled, or the spindle had another speed.
std::optional<double> feedOf(const TurningPass& pass, double spindleSpeed) {
  constexpr double kShare = 1e-9;  // share of the feed: rounding of its times
  const auto isOther = [&](double speed) { return speed != spindleSpeed; };
  if (pass.speeds.size() != pass.path.size() || std::any_of(pass.speeds.begin(), pass.speeds.end(), isOther)) return {};
  double length = 0.0;
  for (std::size_t i = 1; i < pass.path.size(); ++i) length += (pass.path[i] - pass.path[i - 1]).norm();
  if (pass.times.front() != 0.0) return {};
  if (length == 0.0) return pass.times.back() == 0.0 ? std::optional(kUsualFeed) : std::nullopt;
  const double seconds = pass.times.back(), feed = length / seconds * kSecondsPerMinute / spindleSpeed;
  double travelled = 0.0;
  for (std::size_t i = 1; i < pass.path.size(); ++i) {
    travelled += (pass.path[i] - pass.path[i - 1]).norm();
    if (!(std::abs(travelled / length * seconds - pass.times[i]) <= kShare * seconds)) return {};
  }
  if (!std::isfinite(feed)) return {};
  // Rounds to the written number: 0.2, not 0.20000000000000001.
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(12) << feed;
  return nlohmann::json::parse(text.str()).get<double>();
}

nlohmann::json describedThread(const ThreadCut& thread) {
  nlohmann::json json = {{"pitch", thread.pitch}};
  if (thread.starts != 1) json["starts"] = thread.starts;
  if (thread.isLeft) json["hand"] = "left";
  if (thread.flat != 0.0) json["flat"] = thread.flat;
  return json;
}

// Null: a description cannot hold it.
nlohmann::json passJson(const TurningPass& pass, double spindleSpeed) {
  const bool isRound = pass.noseRadius >= TurningPass::kLeastNose && pass.noseRadius <= TurningPass::kLargestNose;
  if (pass.tool || pass.method != TurningMethod::Trim || !isRound || pass.path.empty()) return {};
  if (pass.thread && pass.thread->offset != pass.path.front().y()) return {};
  const std::optional<double> feed = feedOf(pass, spindleSpeed);
  if (!feed) return {};
  nlohmann::json json = {{"nose_radius", pass.noseRadius}, {"feed", *feed}};
  json["side"] = pass.side == TurningSide::Bore ? "bore" : "outside";
  nlohmann::json& points = json["points"] = nlohmann::json::array();
  for (const ProfilePoint& p : pass.path) points.push_back({p.x(), p.y()});
  if (pass.thread) json["thread"] = describedThread(*pass.thread);
  return json;
}

}  // namespace

nlohmann::json passesDescription(const TurningPasses& passes, double spindleSpeed) {
  nlohmann::json listed = nlohmann::json::array();
  for (const TurningPasses::Pass& pass : passes) {
    nlohmann::json json = passJson(*pass, spindleSpeed);
    if (json.is_null()) return {};
    listed.push_back(std::move(json));
  }
  return {{"passes", std::move(listed)}};
}

Result<std::vector<TurningPass>> describedPasses(const nlohmann::json& description, double spindleSpeed,
                                                 const TurnedProfile& bar) {
  const auto listed = description.is_object() ? description.find("passes") : description.end();
  if (listed == description.end() || !listed->is_array()) return malformedPass("a list was expected");
  std::vector<TurningPass> passes;
  std::uint64_t work = 0;
  for (const nlohmann::json& each : *listed) {
    Result<TurningPass> pass = passFrom(each, spindleSpeed);
    if (!pass) return pass.error();
    work += samplesUnder(bar, *pass) + pass->path.size() + (pass->thread ? bar.size() : 0);
    if (work > kMostCutAgain) return malformedPass("cutting them would take too long");
    passes.push_back(std::move(pass.value()));
  }
  return passes;
}

}  // namespace handwheel

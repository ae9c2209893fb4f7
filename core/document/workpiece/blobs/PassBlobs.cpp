// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/blobs/PassBlobs.h"

#include "base/JsonFields.h"
#include "base/JsonText.h"
#include "document/container/Blobs.h"
#include "machining/lathe/LatheJson.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace handwheel {

namespace {

constexpr const char* kPath = "workpiece/path";      // all passes
constexpr const char* kSpeeds = "workpiece/speeds";  // passes with "speeds"
constexpr const char* kAsked = "workpiece/asked";    // passes with "asked_speeds"
constexpr const char* kBore = "bore";                // value of "side"
constexpr const char* kOfProgram = "program";        // key of passes
constexpr const char *kExact = "exact", *kEdges = "edges", *kArcs = "arcs";
constexpr const char* kOfCommand = "command";             // key of passes
constexpr const char* kPoles = "poles";                   // value of "method"
constexpr const char *kRight = "right", *kLeft = "left";  // values of "hand"
// Keys of passes and of their threads.
constexpr const char *kNose = "nose_radius", *kPoints = "points", *kTool = "tool", *kSpindleSpeed = "spindle_speed",
                     *kHasSpeeds = "speeds", *kHasAsked = "asked_speeds", *kThread = "thread", *kSide = "side",
                     *kMethod = "method", *kResolutionKey = "resolution", *kParts = "parts", *kHand = "hand";
constexpr std::size_t kMostPasses = 100'000;
constexpr double kFastestSpindle = 1e5;   // r/min
constexpr std::size_t kPointNumbers = 3;  // time, r, z

double numberIn(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : 0.0;
}

bool isTrueIn(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

// Returns the number of points of a listed pass; 0 if the entry is malformed.
std::uint64_t pointsIn(const nlohmann::json& entry) {
  const std::uint64_t count = countAt(entry, kPoints);
  return count <= TurningPass::kMostPoints ? count : 0;
}

// Returns true if no point of a range is lost.
bool isWhole(const ReadArray<double>& path, std::uint64_t begin, std::uint64_t end) {
  if (path.values.size() < kPointNumbers * end) return false;
  return std::none_of(path.lost.begin(), path.lost.end(),
                      [&](const IndexRange& lost) { return lost.begin < end && begin < lost.end; });
}

bool isSpeed(double speed) {
  return speed >= 0.0 && speed <= kFastestSpindle;  // false for NaN
}

// Returns true if the array of this key has a speed for each point of a listed pass.
bool hasSpeeds(const nlohmann::json& entry, const char* key) {
  return entry.is_object() && isTrueIn(entry, key);
}

// The numbers of passes, and where those of the next one begin.
struct PassArrays {
  ReadArray<double> path, speeds, asked;
  std::uint64_t pathBegin = 0, speedsBegin = 0, askedBegin = 0;
};

bool isConstant(const std::vector<double>& speeds) {
  return std::adjacent_find(speeds.begin(), speeds.end(), std::not_equal_to<>()) == speeds.end();
}

// The speeds of an array from `begin` on. Nothing where they are malformed or lost.
std::optional<std::vector<double>> speedsIn(const ReadArray<double>& speeds, std::uint64_t begin, std::size_t count) {
  const auto isLost = [&](const IndexRange& lost) { return lost.begin < begin + count && begin < lost.end; };
  if (speeds.values.size() < begin + count || std::any_of(speeds.lost.begin(), speeds.lost.end(), isLost))
    return std::nullopt;
  const auto first = speeds.values.begin() + static_cast<std::ptrdiff_t>(begin);
  std::vector<double> read(first, first + static_cast<std::ptrdiff_t>(count));
  if (!std::all_of(read.begin(), read.end(), isSpeed)) return std::nullopt;
  return read;
}

// The speeds of a pass: those in the array, one for all of it, or none. Nothing where they are malformed or lost.
std::optional<std::vector<double>> speedsOf(const nlohmann::json& entry, const PassArrays& arrays, std::size_t count) {
  if (hasSpeeds(entry, kHasSpeeds)) return speedsIn(arrays.speeds, arrays.speedsBegin, count);
  const auto constant = entry.find(kSpindleSpeed);
  if (constant == entry.end()) return std::vector<double>();
  const double speed = constant->is_number() ? constant->get<double>() : -1.0;
  return isSpeed(speed) ? std::optional(std::vector<double>(count, speed)) : std::nullopt;
}

// The keys of the numbers of a thread, for reader and writer.
template <class Thread>
void visitThread(Thread& thread, const auto& visit) {
  visit("pitch", thread.pitch);
  visit("starts", thread.starts);
  visit("angle", thread.angle);
  visit("flat", thread.flat);
  visit("offset", thread.offset);
}

// The arcs of a pass with this number of points. Nothing if they are malformed.
std::optional<std::vector<TurningPass::Arc>> arcsIn(const nlohmann::json& entry, std::uint64_t points) {
  std::vector<TurningPass::Arc> arcs;
  const auto listed = entry.find(kArcs);
  if (listed == entry.end()) return arcs;
  if (!listed->is_array()) return std::nullopt;
  std::uint64_t before = 0;
  for (const nlohmann::json& each : *listed) {
    const bool isTriple =
        each.is_array() && each.size() == 3 && each[0].is_number_unsigned() && each[1].is_number_unsigned();
    if (!isTriple || !each[2].is_number()) return std::nullopt;
    const auto first = each[0].get<std::uint64_t>(), last = each[1].get<std::uint64_t>();
    const double bulge = each[2].get<double>();
    if (first < before || last <= first || last >= points || !std::isfinite(bulge)) return std::nullopt;
    arcs.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last), bulge});
    before = last;
  }
  return arcs;
}

// Returns true if the points of a pass lie on its arcs.
bool areOnPath(const TurningPass& pass) {
  constexpr double kSlack = 1e-3;  // mm
  return std::all_of(pass.arcs.begin(), pass.arcs.end(), [&](const TurningPass::Arc& arc) {
    const ProfileSegment curve{pass.path[arc.first], pass.path[arc.last], arc.bulge};
    return std::all_of(pass.path.begin() + arc.first, pass.path.begin() + arc.last + 1,
                       [&](const ProfilePoint& p) { return (curve.nearest(p) - p).norm() <= kSlack; });
  });
}

// The directions of the edges of a nose. Nothing if they are malformed.
std::optional<ProfilePoint> edgesIn(const nlohmann::json& entry) {
  const auto edges = entry.find(kEdges);
  if (edges == entry.end()) return ProfilePoint(0, 0);
  if (!edges->is_array() || edges->size() != 2) return std::nullopt;
  ProfilePoint direction(0, 0);
  for (std::size_t i = 0; i < 2; ++i) {
    const nlohmann::json& each = (*edges)[i];
    if (!each.is_number_integer() || std::abs(each.get<double>()) > 1.0) return std::nullopt;
    direction[static_cast<Eigen::Index>(i)] = each.get<double>();
  }
  return direction;
}

nlohmann::json threadJson(const ThreadCut& thread) {
  nlohmann::json json = {{kHand, thread.isLeft ? kLeft : kRight}};
  visitThread(thread, JsonFieldWriter(json));
  return json;
}

std::optional<ThreadCut> threadFrom(const nlohmann::json& entry) {
  constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
  ThreadCut thread{kMissing, 0, false, kMissing, kMissing, kMissing};
  const JsonFieldReader reader(entry);
  visitThread(thread, reader);
  const nlohmann::json& hand = reader.member(kHand);
  thread.isLeft = hand == kLeft;
  return (thread.isLeft || hand == kRight) && thread.isSound() ? std::optional(thread) : std::nullopt;
}

// The pass whose numbers begin there in the arrays of all passes.
std::optional<TurningPass> readPass(const nlohmann::json& entry, const PassArrays& arrays) {
  const ReadArray<double>& path = arrays.path;
  const std::uint64_t begin = arrays.pathBegin;
  TurningPass pass;
  if (!entry.is_object()) return std::nullopt;
  pass.noseRadius = numberIn(entry, kNose);
  pass.isOfProgram = isTrueIn(entry, kOfProgram);
  pass.isExact = isTrueIn(entry, kExact);
  pass.isOfCommand = isTrueIn(entry, kOfCommand);
  const std::uint64_t count = pointsIn(entry);
  auto arcs = arcsIn(entry, count);
  const auto edges = edgesIn(entry);
  if (!arcs || !edges) return std::nullopt;
  pass.arcs = std::move(*arcs);
  pass.edges = *edges;
  if (const auto side = entry.find(kSide); side != entry.end()) {
    if (*side != kBore) return std::nullopt;
    pass.side = TurningSide::Bore;
  }
  if (const auto method = entry.find(kMethod); method != entry.end()) {
    pass.method = TurningMethod::Poles;
    pass.resolution = numberIn(entry, kResolutionKey);
    pass.isInParts = isTrueIn(entry, kParts);  // programs that took a depth whole did not write it
    const bool isSound =
        pass.resolution >= ControlPointCut::kLeastResolution && pass.resolution <= ControlPointCut::kLargestResolution;
    if (*method != kPoles || !isSound) return std::nullopt;
  }
  if (const auto thread = entry.find(kThread); thread != entry.end()) {
    pass.thread = threadFrom(*thread);
    if (!pass.thread) return std::nullopt;
  }
  if (const auto tool = entry.find(kTool); tool != entry.end()) {
    Result<LatheTool> read = latheToolFrom(*tool);
    if (!read) return std::nullopt;
    pass.tool = std::make_shared<const LatheTool>(std::move(*read));
  }
  if (!(pass.noseRadius >= 0.0 && pass.noseRadius <= StockCylinder::kLargestSize)) return std::nullopt;
  if (count == 0) return std::nullopt;
  if (!isWhole(path, begin, begin + count)) return std::nullopt;
  const double* const first = &path.values[kPointNumbers * begin];
  if (!std::all_of(first, first + kPointNumbers * count, [](double v) { return std::isfinite(v); }))
    return std::nullopt;
  for (std::size_t i = 0; i < count; ++i) {
    const double* point = first + kPointNumbers * i;
    pass.times.push_back(std::max(point[0], i == 0 ? 0.0 : pass.times.back()));
    pass.path.emplace_back(point[1], point[2]);
  }
  if (!areOnPath(pass)) return std::nullopt;
  auto ofSpindle = speedsOf(entry, arrays, count);
  if (!ofSpindle) return std::nullopt;
  pass.speeds = std::move(*ofSpindle);
  if (hasSpeeds(entry, kHasAsked)) {
    auto asked = speedsIn(arrays.asked, arrays.askedBegin, count);
    if (!asked) return std::nullopt;
    pass.askedSpeeds = std::move(*asked);
  }
  return pass;
}

}  // namespace

nlohmann::json writePasses(const TurningPasses& passes, Container& container) {
  nlohmann::json listed = nlohmann::json::array();
  std::vector<double> points, speeds, asked;
  for (const auto& shared : passes) {
    const TurningPass& pass = *shared;
    for (std::size_t k = 0; k < pass.path.size(); ++k) {
      points.insert(points.end(), {pass.times[k], pass.path[k].x(), pass.path[k].y()});
    }
    nlohmann::json entry = {{kNose, pass.noseRadius}, {kPoints, pass.path.size()}};
    if (pass.tool) entry[kTool] = toJson(*pass.tool);
    if (!pass.speeds.empty() && isConstant(pass.speeds)) {
      entry[kSpindleSpeed] = pass.speeds.front();
    } else if (!pass.speeds.empty()) {
      entry[kHasSpeeds] = true;
      speeds.insert(speeds.end(), pass.speeds.begin(), pass.speeds.end());
    }
    if (!pass.askedSpeeds.empty()) {
      entry[kHasAsked] = true;
      asked.insert(asked.end(), pass.askedSpeeds.begin(), pass.askedSpeeds.end());
    }
    if (pass.thread) entry[kThread] = threadJson(*pass.thread);
    if (pass.side == TurningSide::Bore) entry[kSide] = kBore;
    if (pass.isOfProgram) entry[kOfProgram] = true;
    if (pass.isExact) entry[kExact] = true;
    if (!pass.edges.isZero()) entry[kEdges] = {static_cast<int>(pass.edges.x()), static_cast<int>(pass.edges.y())};
    for (const TurningPass::Arc& arc : pass.arcs) entry[kArcs].push_back({arc.first, arc.last, arc.bulge});
    if (pass.isOfCommand) entry[kOfCommand] = true;
    if (pass.method == TurningMethod::Poles) {
      entry[kMethod] = kPoles;
      entry[kResolutionKey] = pass.resolution;
      if (pass.isInParts) entry[kParts] = true;
    }
    listed.push_back(std::move(entry));
  }
  writeArray<double>(container, kPath, points, kPointNumbers);
  if (!speeds.empty()) writeArray<double>(container, kSpeeds, speeds);
  if (!asked.empty()) writeArray<double>(container, kAsked, asked);
  return listed;
}

Result<TurningPasses> readPasses(const nlohmann::json& listed, const Container& container, Progress progress) {
  TurningPasses passes;
  const std::size_t count = listed.is_array() ? std::min(listed.size(), kMostPasses) : 0;
  std::uint64_t points = 0, speedCount = 0, askedCount = 0;
  for (std::size_t i = 0; i < count; ++i) {
    points += pointsIn(listed[i]);
    if (hasSpeeds(listed[i], kHasSpeeds)) speedCount += pointsIn(listed[i]);
    if (hasSpeeds(listed[i], kHasAsked)) askedCount += pointsIn(listed[i]);
  }
  PassArrays arrays;
  arrays.path = readArray<double>(container, kPath, points, kPointNumbers);
  if (speedCount > 0) arrays.speeds = readArray<double>(container, kSpeeds, speedCount);
  if (askedCount > 0) arrays.asked = readArray<double>(container, kAsked, askedCount);
  for (std::size_t i = 0; i < count; ++i) {
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    if (auto pass = readPass(listed[i], arrays))
      passes.push_back(std::make_shared<const TurningPass>(std::move(*pass)));
    arrays.pathBegin += pointsIn(listed[i]);
    if (hasSpeeds(listed[i], kHasSpeeds)) arrays.speedsBegin += pointsIn(listed[i]);
    if (hasSpeeds(listed[i], kHasAsked)) arrays.askedBegin += pointsIn(listed[i]);
  }
  return passes;
}

}  // namespace handwheel

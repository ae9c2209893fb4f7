// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/turning/RecordedPasses.h"

#include "base/NumberText.h"
#include "machining/TurningFidelity.h"
#include "simulation/turning/HandPass.h"

#include <sstream>
#include <string_view>

namespace handwheel {

namespace {

constexpr const char *kTurning = "turn", *kBore = "bore", *kNose = "nose", *kPoles = "poles";

// The next word as a length within these limits, mm; the one that there was where it is none.
void readLength(std::istream& words, double least, double largest, double& length) {
  std::string word;
  double value = 0.0;
  ErrorCode why{};
  if (words >> word && parseDecimal(word, value, why) && value >= least && value <= largest) length = value;
}

// Returns the blank pass after an event of a recording; none if another tool than that for turning is used, or none is.
// Events that choose no tool change nothing.
std::optional<TurningPass> cuttingAfter(const std::string& event, const std::optional<TurningPass>& before) {
  std::istringstream words(event);
  std::string word;
  words >> word;
  if (event == "no tool") return std::nullopt;
  if (word != "tool") return before;
  if (!(words >> word) || word != kTurning) return std::nullopt;
  TurningPass blank;
  const FidelitySetting resolution = turnResolutionSetting();
  while (words >> word) {
    if (word == kBore) blank.side = TurningSide::Bore;
    if (word == kNose) readLength(words, TurningPass::kLeastNose, TurningPass::kLargestNose, blank.noseRadius);
    if (word != kPoles) continue;
    blank.method = TurningMethod::Poles;
    readLength(words, resolution.least, resolution.largest, blank.resolution);
  }
  return blank;
}

// The events of one tick, which a table of a recording has in one field (RecordingCsv.cpp).
std::vector<std::string> eventsIn(const std::string& text) {
  constexpr std::string_view kSeparator = "; ";
  std::vector<std::string> events;
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = text.find(kSeparator, begin)) != text.npos; begin = end + kSeparator.size())
    events.push_back(text.substr(begin, end - begin));
  events.push_back(text.substr(begin));
  return events;
}

bool isSameCutting(const std::optional<TurningPass>& one, const TurningPass& other) {
  return one && one->side == other.side && one->noseRadius == other.noseRadius && one->method == other.method &&
         one->resolution == other.resolution;
}

}  // namespace

std::string recordedTurning(const TurningPass& blank) {
  std::string text = kTurning;
  if (blank.side == TurningSide::Bore) text += std::string(" ") + kBore;
  text += std::string(" ") + kNose + " " + shortestText(blank.noseRadius);
  if (blank.method == TurningMethod::Poles) text += std::string(" ") + kPoles + " " + shortestText(blank.resolution);
  return text;
}

std::optional<std::vector<TurningPass>> passesOf(const Recording& recording, double base) {
  std::vector<HandPass> passes;
  auto event = recording.events().begin();
  std::optional<TurningPass> cutting = TurningPass();  // a recording that names no tool is one of turning
  bool isActing = false, wasHeld = false;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const RecordedTick& tick = recording[i];
    for (; event != recording.events().end() && event->tick < tick.tick; ++event) {
      for (const std::string& each : eventsIn(event->text)) {
        if (each == "tool lathe") return std::nullopt;
        cutting = cuttingAfter(each, cutting);
      }
    }
    const bool isHeld = (tick.tip.buttons & 1u) != 0, isPressed = isHeld && !wasHeld;
    wasHeld = isHeld;
    if (isActing && isHeld && !isSameCutting(cutting, passes.back().pass())) {  // another tool drops the pass
      passes.pop_back();
      isActing = false;
    }
    isActing = isHeld && cutting && (isPressed || (isActing && !tick.tip.isRestart));
    if (!isActing) continue;
    if (isPressed) passes.emplace_back(*cutting, base);
    if (tick.hasSource) passes.back().add(tick.felt.proxy, tick.tip.time, 0.0);
  }
  std::vector<TurningPass> made;
  for (HandPass& pass : passes)
    if (!pass.pass().path.empty()) made.push_back(pass.pass());
  return made;
}

}  // namespace handwheel

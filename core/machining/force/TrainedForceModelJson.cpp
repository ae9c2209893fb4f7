// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/JsonText.h"
#include "base/NumberText.h"
#include "machining/force/ForceResources.h"
#include "machining/force/TrainedForceModel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

constexpr const char* kModelFormat = "handwheel force model";
constexpr std::uint64_t kModelVersion = 1;
// Limits of the numbers in a model: far beyond all measurements, and so small that no force overflows.
constexpr double kMostWeight = 1e6, kLeastRange = 1e-9, kLargestRange = 1e9, kMostLogC = 100.0;

Error wrongModelElement(const char* element, const char* what) {
  return {ErrorCode::ElementMalformed, {element, what}, {}, {}};
}

// Reads numbers in a range under a key; their count must be exact.
Result<std::vector<double>> modelNumbersIn(const nlohmann::json& json, const char* key, std::size_t count, double least,
                                           double largest) {
  std::vector<double> numbers = numbersAt(json, key, count + 1);
  if (numbers.size() != count || json.at(key).size() != count)
    return wrongModelElement(key, "it is not a list of the numbers that belong there");
  for (const double number : numbers) {
    if (!(number >= least && number <= largest))
      return Error{
          ErrorCode::ValueOutOfRange, {key, shortestText(number), shortestText(least), shortestText(largest)}, {}, {}};
  }
  return numbers;
}

double modelNumberAt(const nlohmann::json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>() : 0.0;
}

// Returns a text without control characters, which a terminal would execute, and short enough for a line.
std::string shownTextAt(const nlohmann::json& json, const char* key) {
  constexpr std::size_t kMost = 500;
  std::string text = stringAt(json, key);
  if (text.size() > kMost) return {};
  std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
  return text;
}

TrainedForceModel::Origin originIn(const nlohmann::json& json) {
  TrainedForceModel::Origin origin;
  origin.data = shownTextAt(json, "data");
  origin.isSynthetic = json.contains("synthetic") && json.at("synthetic") == true;
  origin.material = shownTextAt(json, "material");
  origin.trainer = shownTextAt(json, "trainer");
  origin.seed = countAt(json, "seed");
  origin.epochs = countAt(json, "epochs");
  origin.cuts = countAt(json, "cuts");
  origin.error = modelNumberAt(json, "mse");
  origin.heldOutError = modelNumberAt(json, "held_out_error");
  return origin;
}

Result<ForceNetwork> networkIn(const nlohmann::json& json) {
  const std::uint64_t hidden = countAt(json, "hidden");
  if (hidden < 1 || hidden > ForceNetwork::kMostHidden)
    return Error{ErrorCode::ValueOutOfRange,
                 {"hidden", std::to_string(hidden), "1", std::to_string(ForceNetwork::kMostHidden)},
                 {},
                 {}};
  ForceNetwork network;
  const auto weights = modelNumbersIn(json, "weights", ForceNetwork::weightCount(hidden), -kMostWeight, kMostWeight);
  if (!weights) return weights.error();
  const auto least = modelNumbersIn(json, "input_least", ForceNetwork::kInputs, kLeastRange, kLargestRange);
  if (!least) return least.error();
  const auto largest = modelNumbersIn(json, "input_largest", ForceNetwork::kInputs, kLeastRange, kLargestRange);
  if (!largest) return largest.error();
  const auto range = modelNumbersIn(json, "force_N", 2, kLeastRange, kLargestRange);
  if (!range) return range.error();
  network.weights = *weights;
  std::copy(least->begin(), least->end(), network.least.begin());
  std::copy(largest->begin(), largest->end(), network.largest.begin());
  network.leastForce = range->at(0);
  network.largestForce = range->at(1);
  bool isOrdered = network.leastForce <= network.largestForce;
  for (std::size_t i = 0; i < ForceNetwork::kInputs; ++i) isOrdered &= network.least[i] <= network.largest[i];
  if (!isOrdered) return wrongModelElement("input_largest", "a range ends before it begins");
  return network;
}

}  // namespace

std::string toJson(const TrainedForceModel& model) {
  const ForceNetwork& network = model.network();
  const PowerLaw& law = model.powerLaw();
  const TrainedForceModel::Origin& origin = model.origin();
  nlohmann::ordered_json json = {
      {"format", kModelFormat},
      {"version", kModelVersion},
      {"data", origin.data},
      {"synthetic", origin.isSynthetic},
      {"material", origin.material},
      {"cuts", origin.cuts},
      {"trainer", origin.trainer},
      {"seed", origin.seed},
      {"epochs", origin.epochs},
      {"mse", origin.error},
      {"held_out_error", origin.heldOutError},
      {"inputs", {"depth_mm", "feed_mm_per_rev", "speed_m_per_min"}},
      {"input_least", network.least},
      {"input_largest", network.largest},
      {"force_N", {network.leastForce, network.largestForce}},
      {"hidden", network.hidden()},
      {"weights", network.weights},
      {"power_law_lnC_x_y_n", {law.logC, law.x, law.y, law.n}},
  };
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

Result<TrainedForceModel> forceModelFromJson(std::string_view text, const CuttingEdge& edge,
                                             const ThrustSettings& thrust) {
  if (text.size() > kMostModelBytes)
    return Error{
        ErrorCode::FileTooLarge, {"bytes", std::to_string(text.size()), std::to_string(kMostModelBytes)}, {}, {}};
  const Result<nlohmann::json> json = parseJson(text, "the force model");
  if (!json) return json.error();
  if (stringAt(*json, "format") != kModelFormat)
    return Error{ErrorCode::HeaderMalformed, {std::string("\"format\": \"") + kModelFormat + "\""}, {}, {}};
  if (const std::uint64_t version = countAt(*json, "version"); version != kModelVersion) {
    if (version > kModelVersion)
      return Error{ErrorCode::VersionNewer, {std::to_string(version), std::to_string(kModelVersion)}, {}, {}};
    return wrongModelElement("version", "it is not 1");
  }
  Result<ForceNetwork> network = networkIn(*json);
  if (!network) return network.error();
  const auto law = modelNumbersIn(*json, "power_law_lnC_x_y_n", 4, -kMostLogC, kMostLogC);
  if (!law) return law.error();
  for (std::size_t i = 1; i < law->size(); ++i) {
    if (std::abs(law->at(i)) > kMostExponent)
      return Error{
          ErrorCode::ValueOutOfRange,
          {"power_law_lnC_x_y_n", shortestText(law->at(i)), shortestText(-kMostExponent), shortestText(kMostExponent)},
          {},
          {}};
  }
  return TrainedForceModel(std::move(network.value()), {law->at(0), law->at(1), law->at(2), law->at(3)},
                           originIn(*json), edge, thrust);
}

TrainedForceModel shippedForceModel(const CuttingEdge& edge, const ThrustSettings& thrust) {
  const Result<TrainedForceModel> model = forceModelFromJson(forceModelResource(), edge, thrust);
  assert(model);
  return *model;
}

}  // namespace handwheel

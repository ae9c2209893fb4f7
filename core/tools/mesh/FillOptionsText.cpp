// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/FillOptionsText.h"

#include "base/NumberText.h"
#include "document/mesh/MeshDocument.h"
#include "mesh/measure/MeshFidelity.h"

#include <algorithm>

namespace handwheel {
namespace {

constexpr Limits kEarWeights = {0.0, 1e6};

// A measured setting under its own short name.
struct FillWord {
  const char* option;
  FidelitySetting setting;
};

std::vector<FillWord> fillWords() {
  return {{"fill", fillMethodSetting()},
          {"continuity", fillContinuitySetting()},
          {"density", patchDensitySetting()},
          {"piece-edges", pieceEdgesSetting()}};
}

bool isUsual(const EarWeights& ears) {
  const EarWeights usual;
  return ears.length == usual.length && ears.angles == usual.angles && ears.normal == usual.normal &&
         ears.lid == usual.lid;
}

Vertex readLoop(StepReader& reader, std::string_view word, const MeshDocument& document) {
  const auto& loops = document.defects().loops;
  if (!word.starts_with("v")) {
    const std::uint32_t id = reader.index(word, "loop", loops.size());
    return reader.isGood() ? keyOf(document.mesh(), loops[id]) : kNone;
  }
  const Vertex key = reader.index(word.substr(1), "vertex", document.mesh().vertexSlots());
  const auto has = [&](const BoundaryLoop& loop) { return keyOf(document.mesh(), loop) == key; };
  if (reader.isGood() && std::none_of(loops.begin(), loops.end(), has))
    reader.complain("there is no loop with the smallest vertex " + std::to_string(key));
  return key;
}

}  // namespace

std::string loopsText(const std::vector<Vertex>& keys) {
  std::string text;
  for (const Vertex key : keys) text += (text.empty() ? "v" : ",v") + std::to_string(key);
  return text;
}

std::vector<Vertex> readLoops(StepReader& reader, const std::string& words, const MeshDocument& document) {
  std::vector<Vertex> keys;
  for (const std::string_view part : parted(words, ',')) {
    if (!reader.isGood()) return {};
    keys.push_back(readLoop(reader, part, document));
  }
  return keys;
}

std::string_view wordFor(NumberType numbers) {
  return numbers == NumberType::Float32 ? "single" : "double";
}

NumberType readNumbers(StepReader& reader, const MeshDocument& document) {
  const auto word = reader.option("numbers");
  if (!word) return document.fileNumbers();
  if (*word != "single" && *word != "double") reader.complain("--numbers takes single or double");
  return *word == "single" ? NumberType::Float32 : NumberType::Float64;
}

void addFillOptions(StepWriter& step, const FillOptions& options) {
  FidelityValues values;
  setFillMethod(values, options.method);
  const double given[] = {values.of(fillMethodSetting()), static_cast<double>(options.continuity), options.density,
                          static_cast<double>(options.pieceEdges)};
  std::size_t i = 0;
  for (const FillWord& word : fillWords()) {
    const double value = given[i++];
    if (i == 1 || value != word.setting.standard) step.option(word.option, textOf(word.setting, value));
  }
  if (!options.bridges.empty()) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    for (const HoleBridge& bridge : options.bridges) ends.emplace_back(bridge.a, bridge.b);
    step.option("bridges", pairsText(ends));
  }
  const EarWeights& ears = options.ears;
  if (!isUsual(ears))
    step.option("ears", shortestText(ears.length) + "," + shortestText(ears.angles) + "," + shortestText(ears.normal) +
                            "," + shortestText(ears.lid));
  step.option("numbers", wordFor(options.numbers));
}

FillOptions readFillOptions(StepReader& reader, const MeshDocument& document, std::size_t loopSize) {
  FidelityValues values;
  for (const FillWord& word : fillWords()) {
    const auto given = reader.option(word.option);
    if (!given) continue;
    const Result<double> value = valueOf(word.setting, *given);
    if (!value || !values.set(word.setting, *value))
      reader.complain("--" + std::string(word.option) + " does not take '" + given->substr(0, 40) + "'");
  }
  FillOptions options;
  apply(values, options);
  if (const auto ends = reader.option("bridges"); ends) {
    for (const auto& [a, b] : reader.pairs(*ends, "point of the loop", loopSize)) options.bridges.push_back({a, b});
  }
  if (const auto ears = reader.option("ears"); ears) {
    const std::vector<std::string_view> parts = parted(*ears, ',');
    if (parts.size() != 4) reader.complain("--ears takes four weights: L,A,N,L");
    if (reader.isGood())
      options.ears = {reader.number(parts[0], kEarWeights), reader.number(parts[1], kEarWeights),
                      reader.number(parts[2], kEarWeights), reader.number(parts[3], kEarWeights)};
  }
  options.numbers = readNumbers(reader, document);
  options.keptCorners = keptCorners(document);
  return options;
}

std::set<int> keptLoops(const MeshDocument& document) {
  std::set<int> ids;
  for (const BoundaryLoop& loop : document.defects().loops)
    if (!loop.rim && document.isKeptOpen(loop)) ids.insert(loop.id);
  return ids;
}

std::set<PointKey> keptCorners(const MeshDocument& document) {
  std::set<PointKey> corners;
  for (const BoundaryLoop& loop : document.defects().loops) {
    if (loop.rim || !document.isKeptOpen(loop)) continue;
    for (const Vec3& p : loopPoints(document.mesh(), loop)) corners.insert(positionKey(p));
  }
  return corners;
}

}  // namespace handwheel

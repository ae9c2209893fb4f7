// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/BoundaryLoopText.h"

#include "document/mesh/MeshDocument.h"
#include "tools/mesh/operations/FillOperation.h"

#include <algorithm>

namespace handwheel {
namespace {

Vertex readLoop(ScriptLineReader& reader, std::string_view word, const MeshDocument& document) {
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

std::vector<Vertex> readLoops(ScriptLineReader& reader, const std::string& words, const MeshDocument& document) {
  std::vector<Vertex> keys;
  for (const std::string_view part : parted(words, ',')) {
    if (!reader.isGood()) return {};
    keys.push_back(readLoop(reader, part, document));
  }
  return keys;
}

NumberType numbersFor(const MeshDocument& document, const OperationValues& values) {
  return numbersOf(values).value_or(document.fileNumbers());
}

FillOptions fillOptionsFor(const MeshDocument& document, const OperationValues& values) {
  FillOptions options = fillOptionsOf(values);
  options.numbers = numbersFor(document, values);
  options.keptCorners = keptCorners(document);
  return options;
}

std::set<int> keptLoops(const MeshDocument& document) {
  std::set<int> ids;
  for (const BoundaryLoop& loop : document.defects().loops)
    if (document.isKeptOpen(loop)) ids.insert(loop.id);
  return ids;
}

std::set<PointKey> keptCorners(const MeshDocument& document) {
  std::set<PointKey> corners;
  for (const BoundaryLoop& loop : document.defects().loops) {
    if (!document.isKeptOpen(loop)) continue;
    for (const Vec3& p : loopPoints(document.mesh(), loop)) corners.insert(positionKey(p));
  }
  return corners;
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/container/Migrations.h"

#include "document/Container.h"
#include "document/container/Blobs.h"

#include <array>
#include <cassert>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

// Joins the points of all passes of a workpiece in one array, as an archive may have fewer entries than there are
// passes. A pass with lost parts is left without points.
Status joinPasses(Container& container) {
  constexpr std::size_t kNumbers = 3;
  constexpr std::uint64_t kMostPoints = 10'000'000;  // limit for a pass, in version 3
  nlohmann::json& manifest = *container.manifest;
  const nlohmann::json::json_pointer pointer("/document/turned/passes");
  if (manifest.value("kind", nlohmann::json()) != "workpiece" || !manifest.contains(pointer)) return Done{};
  nlohmann::json& passes = manifest[pointer];
  if (!passes.is_array()) return Done{};
  std::vector<double> points;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    if (!passes[i].is_object()) continue;
    const nlohmann::json listed = passes[i].value("points", nlohmann::json());
    const std::uint64_t count = listed.is_number_unsigned() ? listed.get<std::uint64_t>() : 0;
    const std::string number = std::to_string(i);
    const std::string name = "workpiece/passes/" + std::string(number.size() < 4 ? 4 - number.size() : 0, '0') + number;
    ReadArray<double> read;
    if (count <= kMostPoints) read = readArray<double>(container, name, count, kNumbers);
    const bool isWhole = read.lost.empty() && read.values.size() == kNumbers * count;
    if (isWhole)
      points.insert(points.end(), read.values.begin(), read.values.end());
    else
      passes[i]["points"] = 0;
  }
  std::erase_if(container.blobs, [](const auto& blob) { return blob.first.starts_with("workpiece/passes/"); });
  if (!points.empty()) writeArray<double>(container, "workpiece/path", points, kNumbers);
  return Done{};
}

}  // namespace

std::span<const Migration> migrations() {
  static const std::array<Migration, kContainerVersion - 1> kChain = {
      // A workpiece may have been cut: an older program would show the bar, and lose the part when it saves. A document
      // of version 1 without it is as it was.
      [](Container&) -> Status { return Done{}; },
      // A cell may hold bodies: an older program would show the robot alone, and drop their shapes when it saves. A
      // document of version 2 holds none.
      [](Container&) -> Status { return Done{}; },
      // A turned part may be bored: an older program would show it solid, and lose the bore when it saves. A document
      // of version 3 has no bore, and the path of each pass in blobs of its own.
      joinPasses,
      // Passes may be those of threads and tell the speed of the spindle, and a part its crashes: an older program
      // would
      // cut a thread as a neck, mark the others wrongly, and lose all of it when it saves. A document of version 4 has
      // none of them.
      [](Container&) -> Status { return Done{}; },
  };
  return kChain;
}

Status migrate(Container& container, std::uint64_t version, std::span<const Migration> chain) {
  assert(version >= 1);
  for (std::size_t i = static_cast<std::size_t>(version - 1); i < chain.size(); ++i) {
    if (const Status done = chain[i](container); !done) return done.error();
  }
  return Done{};
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/DrilledHoleBlobs.h"

#include "base/JsonFields.h"
#include "base/JsonText.h"
#include "document/container/Blobs.h"

#include <cmath>

namespace handwheel {
namespace {

using Json = nlohmann::json;

constexpr const char *kHoles = "holes", *kShape = "drill", *kPoses = "poses", *kErosion = "erosion", *kTried = "tried";
constexpr const char *kTimes = "volume/holes/times", *kPositions = "volume/holes/places", *kAxes = "volume/holes/axes";
constexpr const char* kShapes[] = {"ball", "burr", "twist", "saw"};  // in the order of DrillShape
constexpr std::size_t kMostHoles = 100'000;

template <class Setup>
void visitSetup(Setup& setup, const auto& visit) {
  visit("diameter", setup.tool.diameter);
  visit("point_angle", setup.tool.pointAngle);
  visit("length", setup.tool.length);
  visit("width", setup.tool.width);
  visit("material", setup.material.id);
  visit("energy", setup.material.energy);
  visit("tangential", setup.material.tangential);
  visit("spindle", setup.spindle);
}

// All valid drills can be read again. Length and width are bounded by the diameter, which limits the cost of drilling.
bool isSound(const DrillSetup& setup) {
  const auto isWithin = [](double x, double least, double most) { return x >= least && x <= most; };
  return setup.tool.diameter > 0.0 && setup.tool.diameter <= 1e6 && isWithin(setup.tool.pointAngle, 0.1, M_PI) &&
         isWithin(setup.tool.length, 0.0, 20.0 * setup.tool.diameter + 1.0) && setup.tool.width > 0.0 &&
         setup.tool.width <= setup.tool.diameter + 1.0 && isWithin(setup.material.energy, 1e-9, 1e9) &&
         isWithin(setup.material.tangential, 1e-9, 1e6) && isWithin(std::abs(setup.spindle), 0.0, 1e7) &&
         setup.erosion > 0.0;
}

std::optional<DrillSetup> setupIn(const Json& entry) {
  DrillSetup setup;
  const std::string shape = stringAt(entry, kShape);
  const auto* const known = std::find(std::begin(kShapes), std::end(kShapes), shape);
  if (known == std::end(kShapes)) return std::nullopt;
  setup.tool.shape = static_cast<DrillShape>(known - kShapes);
  if (const DrillMaterial* const material = drillMaterial(stringAt(entry, "material"))) setup.material = *material;
  visitSetup(setup, JsonFieldReader(entry));
  if (const Json& erosion = JsonFieldReader(entry).member(kErosion); erosion.is_number())
    setup.erosion = erosion.get<double>();
  return isSound(setup) ? std::optional(setup) : std::nullopt;
}

// The poses of all holes as they are stored.
struct StoredPoses {
  ReadArray<std::uint64_t> times;
  ReadArray<std::int64_t> positions;
  ReadArray<float> axes;

  bool isWhole(std::uint64_t count) const {
    return times.lost.empty() && positions.lost.empty() && axes.lost.empty() && times.values.size() == count &&
           positions.values.size() == 3 * count && axes.values.size() == 3 * count;
  }
  DrillPose at(std::size_t i) const {
    DrillPose pose;
    pose.micros = times.values[i];
    for (std::size_t k = 0; k < 3; ++k) {
      pose.at[k] = positions.values[3 * i + k];
      pose.axis[k] = axes.values[3 * i + k];
    }
    return pose;
  }
};

}  // namespace

void writeHoles(const DrilledHoles& holes, Container& container) {
  Json list = Json::array();
  std::vector<std::uint64_t> times;
  std::vector<std::int64_t> positions;
  std::vector<float> axes;
  for (const auto& hole : holes) {
    Json entry = {{kShape, kShapes[static_cast<std::size_t>(hole->setup.tool.shape)]}, {kPoses, hole->poses.size()}};
    visitSetup(hole->setup, JsonFieldWriter(entry));
    entry[kErosion] = std::isfinite(hole->setup.erosion) ? Json(hole->setup.erosion) : Json();
    list.push_back(std::move(entry));
    for (std::size_t i = 0; i < hole->poses.size(); ++i) {
      const DrillPose& pose = hole->poses[i];
      times.push_back(pose.micros);
      positions.insert(positions.end(), pose.at.begin(), pose.at.end());
      axes.insert(axes.end(), pose.axis.begin(), pose.axis.end());
    }
  }
  (*container.manifest)["document"][kHoles] = std::move(list);
  if (times.empty()) return;
  writeArray<std::uint64_t>(container, kTimes, times);
  writeArray<std::int64_t>(container, kPositions, positions, 3);
  writeArray<float>(container, kAxes, axes, 3);
}

DrilledHoles readHoles(const Container& container, std::vector<Error>& damage) {
  const Json list = (*container.manifest)["document"].value(kHoles, Json());
  const auto fail = [&](const char* what) {
    damage.push_back({ErrorCode::ElementMalformed, {"document.holes", what}, {}, {}});
    return DrilledHoles();
  };
  if (list.is_null()) return {};
  if (!list.is_array() || list.size() > kMostHoles) return fail("it is not a list of holes");
  std::uint64_t count = 0;
  for (const Json& entry : list) {
    const std::uint64_t poses = countAt(entry, kPoses);
    if (poses > DrillRecord::kMostPoses) return fail("a hole has too many poses");
    count += poses;
  }
  const StoredPoses stored{readArray<std::uint64_t>(container, kTimes, count),
                           readArray<std::int64_t>(container, kPositions, count, 3),
                           readArray<float>(container, kAxes, count, 3)};
  if (!stored.isWhole(count)) return fail("poses of the drill are lost");
  DrilledHoles holes;
  std::size_t next = 0;
  for (const Json& entry : list) {
    const std::optional<DrillSetup> setup = setupIn(entry);
    if (!setup) return fail("a drill is impossible or not known");
    auto hole = std::make_shared<DrillRecord>();
    hole->setup = *setup;
    for (std::uint64_t left = countAt(entry, kPoses); left > 0; --left) {
      const DrillPose pose = stored.at(next++);
      if (!pose.isSound()) return fail("a pose of the drill is impossible");
      hole->poses.push_back(pose);
    }
    holes.push_back(std::move(hole));
  }
  return holes;
}

void writeTried(const TriedHoles& tried, Container& container) {
  Json list = Json::array();
  for (const TriedHole& hole : tried) list.push_back(Json::array({hole.mark, hole.forbidden, hole.number}));
  (*container.manifest)["document"][kTried] = std::move(list);
}

std::shared_ptr<const TriedHoles> readTried(const Container& container, std::vector<Error>& damage) {
  const Json list = (*container.manifest)["document"].value(kTried, Json());
  if (list.is_null()) return nullptr;
  if (!list.is_array()) {
    damage.push_back({ErrorCode::ElementMalformed, {"document.tried", "it is not a list of tries"}, {}, {}});
    return nullptr;
  }
  auto tried = std::make_shared<TriedHoles>();
  std::uint32_t last = 1;  // tries are in order
  for (const Json& each : list) {
    const bool isHole = each.is_array() && each.size() == 3 && each[0].is_number_unsigned() && each[1].is_number() &&
                        each[2].is_number_unsigned();
    const double forbidden = isHole ? each[1].get<double>() : -1.0;
    const std::uint64_t number = isHole ? each[2].get<std::uint64_t>() : 0;
    if (!(forbidden >= 0.0 && forbidden <= 1e6) || number < last || number > TriedHole::kMost ||
        tried->size() == TriedHole::kMost) {
      damage.push_back({ErrorCode::ElementMalformed, {"document.tried", "a try is impossible"}, {}, {}});
      break;
    }
    last = static_cast<std::uint32_t>(number);
    tried->push_back({each[0].get<std::uint64_t>(), forbidden, last});
  }
  return tried->empty() ? nullptr : tried;
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/PlanningFiles.h"

#include "document/FileBytes.h"
#include "planning/problems/MoveItProblem.h"
#include "planning/problems/YamlText.h"

#include <algorithm>

namespace handwheel {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kScene = "scene", kRequest = "request";

Error inFile(Error error, const fs::path& file) {
  error.subject = file.string();
  return error;
}

Error malformedFile(const fs::path& file, std::string element, const char* reason) {
  return {ErrorCode::ElementMalformed, {std::move(element), reason}, {}, file.string()};
}

bool isYaml(const fs::path& file) {
  return file.extension() == ".yaml" || file.extension() == ".yml";
}

// The last position in a name at which one of the two words of a pair of files stands.
struct PairName {
  std::size_t at = std::string::npos;
  bool isScene = false;
};

PairName pairNameOf(const std::string& name) {
  const std::size_t scene = name.rfind(kScene), request = name.rfind(kRequest);
  const bool isScene = scene != name.npos && (request == name.npos || scene > request);
  return {isScene ? scene : request, isScene};
}

// "shelf_scene0012" becomes "shelf_12"; a name that has only a number gets that of the folder before it.
std::string problemName(const fs::path& scene) {
  const std::string stem = scene.stem().string();
  const std::size_t at = pairNameOf(stem).at;
  std::string name = stem.substr(0, at), number = stem.substr(at + kScene.size());
  while (!name.empty() && (name.back() == '_' || name.back() == '-')) name.pop_back();
  if (name.empty()) name = fs::absolute(scene).parent_path().filename().string();
  number.erase(0, std::min(number.find_first_not_of('0'), number.size()));
  return number.empty() ? name : name + '_' + number;
}

Result<PlanningSet> readPair(const fs::path& file) {
  const std::string name = file.filename().string();
  const PairName pair = pairNameOf(name);
  if (pair.at == name.npos)
    return malformedFile(file, "name", "one of a pair of files has 'scene' or 'request' in its name");
  const std::string_view own = pair.isScene ? kScene : kRequest, others = pair.isScene ? kRequest : kScene;
  std::string otherName = name;
  otherName.replace(pair.at, own.size(), others);
  const fs::path other = file.parent_path() / otherName;
  const fs::path &scene = pair.isScene ? file : other, &request = pair.isScene ? other : file;
  const Result<std::string> world = readFileHead(scene, YamlLimits::kMostBytes + 1),
                            query = readFileHead(request, YamlLimits::kMostBytes + 1);
  if (!world) return inFile(world.error(), scene);
  if (!query) return inFile(query.error(), request);
  Result<PlanningSet> set = readMoveItProblem(*world, *query, problemName(scene));
  if (set) return set;
  const auto& arguments = set.error().arguments;
  return inFile(set.error(), !arguments.empty() && arguments[0].starts_with(kRequest) ? request : scene);
}

Result<PlanningSet> readFolder(const fs::path& folder) {
  std::vector<fs::path> scenes;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    if (isYaml(at->path()) && pairNameOf(at->path().filename().string()).isScene) scenes.push_back(at->path());
  }
  std::sort(scenes.begin(), scenes.end());
  if (scenes.empty()) return malformedFile(folder, "folder", "it has no YAML files with 'scene' in their names");
  PlanningSet set;
  for (const fs::path& scene : scenes) {
    Result<PlanningSet> pair = readPair(scene);
    if (!pair) return pair.error();
    if (set.problems.empty()) set.joints = pair->joints;
    if (pair->joints != set.joints)
      return malformedFile(scene, "request.goal_constraints", "the joints are not those of the first pair");
    set.problems.push_back(std::move(pair->problems.front()));
  }
  set.name = fs::absolute(folder / "").parent_path().filename().string();
  return set;
}

}  // namespace

Result<PlanningSet> readPlanningFiles(const fs::path& path) {
  std::error_code ignored;  // Any fault shows when the file is read
  if (fs::is_directory(path, ignored)) return readFolder(path);
  if (isYaml(path)) return readPair(path);
  const Result<std::string> text = readFileBytes(path);
  Result<PlanningSet> set = text ? readPlanningSet(*text) : Result<PlanningSet>(text.error());
  return set ? std::move(set) : inFile(set.error(), path);
}

}  // namespace handwheel

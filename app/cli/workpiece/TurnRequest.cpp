// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/TurnRequest.h"

#include "base/NumberText.h"
#include "cli/workpiece/BarStockArgument.h"
#include "cli/workpiece/PostArguments.h"
#include "document/DocumentKind.h"
#include "machining/program/ToolPath.h"

namespace handwheel {

namespace {

constexpr double kLeastSpacing = 1e-6, kLargestSpacing = 1e3;  // mm

std::string readLength(const Arguments& arguments, const char* name, double least, double largest, double& value) {
  if (!arguments.has(name)) return {};
  if (readNumber(arguments.valueOf(name), value) && value >= least && value <= largest) return {};
  return std::string("--") + name + " takes a length in mm from " + shortestText(least) + " to " +
         shortestText(largest) + ".";
}

std::string readMaterial(const Arguments& arguments, TurnRequest& request) {
  const WorkMaterials& materials = WorkMaterials::standard();
  request.isMaterialGiven = arguments.has("material");
  const std::string id = arguments.has("material") ? arguments.valueOf("material") : kUsualMaterial;
  if (const WorkMaterial* const found = materials.find(id)) {
    request.material = *found;
    return {};
  }
  std::string ids;
  for (const WorkMaterial& each : materials.all()) ids += (ids.empty() ? "" : ", ") + each.id;
  return "--material is one of " + ids + ".";
}

std::string readDialect(const Arguments& arguments, TurnRequest& request) {
  const std::string dialect = arguments.has("dialect") ? arguments.valueOf("dialect") : "linuxcnc";
  if (dialect != "linuxcnc" && dialect != "fanuc") return "--dialect is linuxcnc or fanuc.";
  if (dialect == "fanuc") request.dialect = ProgramDialect::Fanuc;
  return {};
}

// Reads a list of block skips such as 1,3.
std::string readSkips(const Arguments& arguments, TurnRequest& request) {
  request.hasIncrements = arguments.has("increments");
  const bool isFanuc = request.dialect == ProgramDialect::Fanuc;
  if (request.hasIncrements && !isFanuc) return "--increments is of --dialect fanuc.";
  if (!arguments.has("block-skip")) return {};
  if (!arguments.has("program")) return "--block-skip is of --program P.";
  const std::string list = arguments.valueOf("block-skip");
  for (std::size_t i = 0; i < list.size(); i += 2) {
    const bool isDigitOfSkip = list[i] >= '1' && list[i] <= '9' && (isFanuc || list[i] == '1');
    const bool isListed = i + 1 == list.size() || (list[i + 1] == ',' && i + 2 < list.size());
    if (!isDigitOfSkip || !isListed)
      return isFanuc ? "--block-skip takes numbers from 1 to 9, such as 1,3." : "--block-skip is 1 on a LinuxCNC.";
    request.skips = static_cast<std::uint16_t>(request.skips | 1u << (list[i] - '0'));
  }
  return list.empty() ? "--block-skip takes numbers from 1 to 9, such as 1,3." : "";
}

std::string readPostOf(const Arguments& arguments, TurnRequest& request) {
  if (!arguments.has("post") && !arguments.has("insert")) return {};
  if (!arguments.has("program")) return "--post and --insert are of --program P.ngc.";
  return readPost(arguments, request.post.emplace());
}

// Programs cut exactly.
std::string readMethod(const Arguments& arguments, TurnRequest& request) {
  for (const char* const each : {"method", "resolution"})
    if (arguments.has(each) && !arguments.has("recording")) return std::string("--") + each + " is of --recording R.";
  const std::string method = arguments.valueOf("method");
  if (arguments.has("method") && method != "trim" && method != "poles") return "--method is trim or poles.";
  if (arguments.has("method")) request.method = method == "poles" ? TurningMethod::Poles : TurningMethod::Trim;
  if (arguments.has("resolution") && method != "poles") return "--resolution is of --method poles.";
  if (method != "poles") return {};
  const FidelitySetting setting = turnResolutionSetting();
  double resolution = setting.standard;
  const std::string problem = readLength(arguments, "resolution", setting.least, setting.largest, resolution);
  request.resolution = resolution;
  return problem;
}

std::string readNose(const Arguments& arguments, TurnRequest& request) {
  if (!arguments.has("nose")) return {};
  double nose = 0.0;
  const bool mayBePoint = arguments.has("program");
  if (mayBePoint && readNumber(arguments.valueOf("nose"), nose) && nose == 0.0) return {};
  const std::string problem = readLength(arguments, "nose", TurningPass::kLeastNose, TurningPass::kLargestNose, nose);
  request.noseRadius = nose;
  return problem;
}

}  // namespace

std::string readTurnRequest(const Arguments& arguments, TurnRequest& request) {
  request.input = arguments.operands[0];
  BarStockArgument word = readBar(request.input);
  if (!word.problem.empty()) return std::move(word.problem);
  request.bar = word.bar;
  request.recording = arguments.valueOf("recording");
  request.program = arguments.valueOf("program");
  request.tools = arguments.valueOf("tools");
  request.target = arguments.valueOf("target");
  request.output = arguments.valueOf("output");
  request.isReplay = arguments.has("replay");
  request.asJson = arguments.has("json");
  const int modes = int(request.isReplay) + int(arguments.has("recording")) + int(arguments.has("program"));
  if (modes != 1) return "Give one of --program P.ngc, --recording R and --replay.";
  if (!request.isReplay && !arguments.has("output")) return "The option -o OUT is missing.";
  if (isContainerName(request.recording))
    for (const char* const each : {"nose", "method", "resolution"})
      if (arguments.has(each)) return std::string("--") + each + " is not for a document, whose passes have their own.";
  if (isContainerName(request.recording) && arguments.has("spacing"))
    return "--spacing is not for a document, whose part has its own.";
  if (request.isReplay && arguments.has("output")) return "--replay writes nothing: leave out -o.";
  for (const auto read : {readNose, readMethod, readDialect, readSkips, readPostOf, readMaterial})
    if (std::string problem = read(arguments, request); !problem.empty()) return problem;
  if (arguments.has("spindle") && !(readNumber(arguments.valueOf("spindle"), request.spindle) &&
                                    request.spindle > 0.0 && request.spindle <= kMostSpindle))
    return "--spindle takes a speed in r/min from 0 to " + shortestText(kMostSpindle) + ".";
  return readLength(arguments, "spacing", kLeastSpacing, kLargestSpacing, request.spacing);
}

}  // namespace handwheel

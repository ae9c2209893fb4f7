// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/volume/ClayCommand.h"

#include "base/NumberText.h"
#include "base/Utf8.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/MemoryNotice.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/TipTrajectory.h"
#include "cli/volume/VolumeFiles.h"
#include "document/FileBytes.h"
#include "document/volume/ImageFiles.h"
#include "document/volume/LayerSteps.h"
#include "document/volume/VolumeKind.h"
#include "document/volume/VolumeMaking.h"
#include "tools/volume/ClayOperation.h"
#include "tools/volume/VoxelizeOperations.h"
#include "volume/VolumeErrors.h"

#include <nlohmann/json.hpp>

#include <chrono>

namespace handwheel {
namespace {

namespace fs = std::filesystem;

// The value of the option --layer.
struct WantedLayer {
  std::string name;
  double strength = 1.0;
};

struct ClayRequest {
  fs::path part, output;
  std::optional<double> voxel;
  std::vector<HandStroke> strokes;
  ReadOptions read;
  std::optional<WantedLayer> layer = {};
};

struct ClayAnswer {
  DocumentFile file;  // the file, with the damage found in reading
  std::string refusal;
  std::shared_ptr<const VolumeSnapshot> before;
  ClayBrush brush;
  Sculpted sculpted;
  double computed = 0.0;  // s that the strokes took the machine
};

std::vector<HandStroke> strokesOf(const TipTrajectory& path) {
  if (path.strokes.empty()) return {path.poses};
  std::vector<HandStroke> strokes;
  for (std::size_t i = 0; i < path.poses.size(); ++i) {
    if (path.strokes[i] == 0) continue;
    if (i == 0 || path.strokes[i] != path.strokes[i - 1]) strokes.emplace_back();
    strokes.back().push_back(path.poses[i]);
  }
  return strokes;
}

// Parses "NAME" or "NAME:STRENGTH"; none if it is neither.
std::optional<WantedLayer> layerOf(const std::string& word) {
  WantedLayer layer{word};
  const std::size_t colon = word.rfind(':');
  if (colon != std::string::npos) {
    layer.name = word.substr(0, colon);
    if (!readNumber(word.substr(colon + 1), layer.strength)) return std::nullopt;
  }
  const bool isName = !layer.name.empty() && layer.name.size() <= ClayLayers::kLongestName && isUtf8(layer.name);
  if (!isName || !(layer.strength >= 0.0 && layer.strength <= 1.0)) return std::nullopt;
  return layer;
}

// Returns the volume of the part, or the inside of its surface as a volume.
Result<std::shared_ptr<const VolumeSnapshot>> clayOf(const OpenedFile& opened, const ClayRequest& request,
                                                     MemoryNotice& notice, Progress progress) {
  if (auto volume = volumeIn(opened)) return volume;
  const Result<SparseVolume> made =
      materialOf(opened, request.part, request.voxel, {}, notice, progress.part(0.0, 0.7));
  if (!made) return made.error();
  return snapshotOf(*made, sourceName(request.part), progress.part(0.7, 1.0));
}

Result<ClayAnswer> sculptFile(const ClayRequest& request, const OperationValues& values, const DocumentKinds& kinds,
                              MemoryNotice& notice, Progress progress) {
  if (const Status can = canWriteVolume(request.output, kinds); !can) return can.error();
  const Result<OpenedFile> opened = kinds.open(request.part, request.read, progress.part(0.0, 0.1));
  if (!opened) return opened.error();
  ClayAnswer done{opened->file, refusalToReplace(request.output, opened->file), {}, {}, {}};
  if (!done.refusal.empty()) return done;
  if (!volumeIn(*opened)) done.file.assigned = {};
  const auto before = clayOf(*opened, request, notice, progress.part(0.1, 0.4));
  if (!before) return before.error();
  done.before = *before;
  const auto about = [&](Error error) {
    error.subject = request.part.string();
    return error;
  };
  const Result<ClayBrush> brush = clayBrushOf(values, *done.before);
  if (!brush) return about(brush.error());
  done.brush = *brush;
  std::shared_ptr<const VolumeSnapshot> part = done.before;
  if (request.layer) {
    const auto layered = withLayerOnTop(part, request.layer->name);
    if (!layered) return about(layered.error());
    part = *layered;
  }
  const auto begin = std::chrono::steady_clock::now();
  Result<Sculpted> sculpted =
      sculptAlong(part, *brush, request.strokes, values.number("rate"), progress.part(0.4, 0.9));
  done.computed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!sculpted) return about(sculpted.error());
  done.sculpted = std::move(*sculpted);
  if (request.layer) {
    const VolumeSnapshot& whole = *done.sculpted.part;
    done.sculpted.part = withLayerShare(whole, whole.layers->all().size() - 1, request.layer->strength, true).volume;
    if (done.sculpted.part->volume.isEmpty()) return about(Error{VolumeErrors::NothingLeft, {}, {}, {}});
  }
  DocumentFile file;
  file.displayUnit = done.file.displayUnit;
  file.assigned = done.file.assigned;
  const Result<WrittenFile> written =
      saveDocument(*kinds.withId("volume"), file, *done.sculpted.part, request.output, progress.part(0.9, 1.0));
  if (!written) return written.error();
  return done;
}

nlohmann::ordered_json reportOf(const ClayAnswer& done, const ClayRequest& request, const MemoryNotice& notice) {
  const Sculpted& sculpted = done.sculpted;
  const SparseVolume& after = sculpted.part->volume;
  nlohmann::ordered_json report = {{"added_mm3", sculpted.added},
                                   {"removed_mm3", sculpted.removed},
                                   {"volume_before_mm3", done.before->volume.enclosed()},
                                   {"volume_mm3", after.enclosed()},
                                   {"changed_blocks", sculpted.changedBlocks},
                                   {"strokes", request.strokes.size()},
                                   {"time_s", sculpted.seconds},
                                   {"computed_s", done.computed},
                                   {"radius_mm", done.brush.radius},
                                   {"voxel_mm", after.voxel()}};
  if (request.layer) {
    const std::vector<ClayLayer>& layers = sculpted.part->layers->all();
    report["layer"] = {{"name", layers.back().name},
                       {"strength", layers.back().strength},
                       {"blocks", layers.back().change->blocks().size()}};
    report["layers"] = layers.size();
  }
  notice.addTo(report);
  return report;
}

std::string textOf(const ClayAnswer& done, const ClayRequest& request) {
  const Sculpted& sculpted = done.sculpted;
  std::string text = request.output.string() + ": ";
  if (sculpted.changedBlocks == 0 && !request.layer) return text + "unchanged, as no stroke comes to the material.\n";
  text += roundedText(sculpted.added) + " mm³ added, " + roundedText(sculpted.removed) + " mm³ removed by a tool of " +
          roundedText(done.brush.radius) + " mm radius, voxels of " + roundedText(done.before->volume.voxel()) +
          " mm.\n";
  if (request.layer)
    text += "They are on the layer “" + request.layer->name + "” with a strength of " +
            roundedText(request.layer->strength) + ".\n";
  return text + std::to_string(sculpted.changedBlocks) + " blocks of voxels are others. Strokes of " +
         roundedText(sculpted.seconds) + " s took " + roundedText(done.computed, 3) + " s.\n";
}

CommandSpec claySpec() {
  CommandSpec spec = {
      "clay",
      "PART",
      "Sculpts a part as clay along strokes of a hand, and reports what comes and goes. The part may be any\n"
      "document; a mask of a volume is respected, and one that is painted stays with a .handwheel. Exit code 0: done;\n"
      "1: error.",
      {{"strokes", 0, "FILE",
        "The tool's middle: CSV with the columns t_s, x_mm, y_mm, z_mm; a column stroke numbers strokes, 0 being "
        "none of them"}}};
  for (OptionSpec& option : optionsOf(clayOperation())) spec.options.push_back(std::move(option));
  spec.options.push_back({"layer", 0, "NAME[:STRENGTH]",
                          "Put the strokes on this layer: the topmost one, or a new one; with this strength, 0 to 1, "
                          "after them. Only a .handwheel keeps layers"});
  spec.options.push_back({"output", 'o', "OUT", "The volume (.handwheel, .vdb, .nrrd), or its surface as a mesh"});
  for (OptionSpec& option : optionsOf(voxelizeOperation(), {"method", "wall"})) {
    if (option.name == "voxel")
      option.help = "Edge of a voxel, for a part that is not a volume yet; default: a 256th of the largest extent";
    spec.options.push_back(std::move(option));
  }
  spec.options.push_back(consentOption());
  addVolumeOptions(spec.options);
  return spec;
}

int runClay(const Arguments& arguments, const DocumentKinds& kinds) {
  OperationValues values(clayOperation()), sampling(voxelizeOperation());
  std::string problem = readOptions(arguments, values);
  if (problem.empty()) problem = readOptions(arguments, sampling);
  std::optional<WantedLayer> layer;
  if (problem.empty() && arguments.has("layer")) {
    layer = layerOf(std::string(arguments.valueOf("layer")));
    if (!layer) problem = "--layer takes a name, and after a colon a strength from 0 to 1, such as wrinkles:0.5.";
  }
  if (problem.empty() && !arguments.has("strokes")) problem = "The option --strokes FILE is missing.";
  if (problem.empty() && !arguments.has("output")) problem = "The option -o OUT is missing.";
  if (!problem.empty()) return failUsage(problem, "clay");
  const fs::path strokes = arguments.valueOf("strokes");
  const Result<std::string> text = readFileBytes(strokes);
  if (!text) {
    Error error = text.error();
    error.subject = strokes.string();
    return fail(error);
  }
  const TipTrajectory path = readTipTrajectory(*text, StrokeColumn::Read);
  if (!path.problem.empty()) return refuse(strokes.string() + ": " + path.problem);
  ClayRequest request{
      arguments.operands[0], arguments.valueOf("output"), sampling.given("voxel"), strokesOf(path), {}, layer};
  if (request.strokes.empty())
    return refuse(strokes.string() + ": The column stroke has only 0, so the hand does nothing; number its strokes.");
  request.read.partial = arguments.has("partial");
  MemoryNotice notice(arguments);
  std::optional<Result<ClayAnswer>> result;
  runInterruptible("Sculpting", [&](CommandJob& job) {
    result = sculptFile(request, values, kinds, notice.during(job), job.progress());
  });
  if (!*result) return fail(result->error());
  const ClayAnswer& done = result->value();
  reportLosses(done.file);
  if (!done.refusal.empty()) return refuse(done.refusal);
  return print(arguments.has("json") ? reportOf(done, request, notice).dump() + "\n" : textOf(done, request));
}

}  // namespace

Command clayCommand() {
  return {claySpec(), runClay};
}

}  // namespace handwheel

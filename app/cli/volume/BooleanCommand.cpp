// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/volume/BooleanCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/MemoryNotice.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/volume/VolumeFiles.h"
#include "tools/volume/VoxelizeOperations.h"
#include "volume/VolumeBoolean.h"

#include <array>
#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, VolumeBoolean>, 3> kOperations{
    {{"unite", VolumeBoolean::Unite}, {"subtract", VolumeBoolean::Subtract}, {"intersect", VolumeBoolean::Intersect}}};

struct BooleanRequest {
  fs::path first, second, output;
  VolumeBoolean how = VolumeBoolean::Unite;
  std::optional<double> voxel;
  ReadOptions read;
};

struct BooleanAnswer {
  std::array<DocumentFile, 2> files;  // the files, with the damage found in reading
  std::string refusal;
  SparseVolume first, second, made;
};

Result<BooleanAnswer> combineFiles(const BooleanRequest& request, const DocumentKinds& kinds, MemoryNotice& notice,
                                   Progress progress) {
  if (const Status can = canWriteVolume(request.output, kinds); !can) return can.error();
  const Result<OpenedFile> first = kinds.open(request.first, request.read, progress.part(0.0, 0.1));
  if (!first) return first.error();
  const Result<OpenedFile> second = kinds.open(request.second, request.read, progress.part(0.1, 0.2));
  if (!second) return second.error();
  BooleanAnswer done{{first->file, second->file}, {}, {}, {}, {}};
  for (const DocumentFile& file : done.files)
    if (done.refusal.empty()) done.refusal = refusalToReplace(request.output, file);
  if (!done.refusal.empty()) return done;
  // A surface is sampled in the grid of the other, so that no interpolation is needed.
  std::optional<double> voxel = request.voxel;
  std::optional<Vec3> origin;
  if (const auto other = volumeIn(*second)) {
    origin = other->volume.origin();
    if (!voxel) voxel = other->volume.voxel();
  }
  Result<SparseVolume> a = materialOf(*first, request.first, voxel, origin, notice, progress.part(0.2, 0.4));
  if (!a) return a.error();
  Result<SparseVolume> b =
      materialOf(*second, request.second, a->voxel(), a->origin(), notice, progress.part(0.4, 0.6));
  if (!b) return b.error();
  done.first = std::move(*a);
  done.second = std::move(*b);
  Result<SparseVolume> made = combined(done.first, done.second, request.how, progress.part(0.6, 0.8));
  if (!made) return made.error();
  done.made = std::move(*made);
  const Result<WrittenFile> written =
      writeVolume(done.made, request.first, done.files[0], request.output, kinds, progress.part(0.8, 1.0));
  if (!written) return written.error();
  return done;
}

nlohmann::ordered_json reportOf(const BooleanAnswer& done, const MemoryNotice& notice) {
  nlohmann::ordered_json report = {{"voxel_mm", done.made.voxel()},        {"first_mm3", done.first.enclosed()},
                                   {"second_mm3", done.second.enclosed()}, {"volume_mm3", done.made.enclosed()},
                                   {"blocks", done.made.blockCount()},     {"bytes", done.made.bytes()}};
  notice.addTo(report);
  return report;
}

std::string textOf(const BooleanAnswer& done, const fs::path& output) {
  return output.string() + ": " + roundedText(done.made.enclosed()) + " mm³ of " + roundedText(done.first.enclosed()) +
         " and " + roundedText(done.second.enclosed()) + " mm³, voxels of " + roundedText(done.made.voxel()) + " mm.\n";
}

CommandSpec booleanSpec() {
  CommandSpec spec = {"boolean",
                      "A B",
                      "Unites, subtracts or intersects the material of two documents: volumes, or what surfaces "
                      "enclose. The result has the voxels\nof A if that is a volume, else those of B. Exit code 0: "
                      "done; 1: error.",
                      {{"unite", 0, "", "What is in A or in B"},
                       {"subtract", 0, "", "What is in A and not in B"},
                       {"intersect", 0, "", "What is in both"},
                       {"output", 'o', "OUT", "The volume (.handwheel, .vdb, .nrrd), or its surface as a mesh"}}};
  for (OptionSpec& option : optionsOf(voxelizeOperation(), {"method", "wall"}))
    spec.options.push_back(std::move(option));
  spec.options.push_back(consentOption());
  addVolumeOptions(spec.options);
  return spec;
}

int runBoolean(const Arguments& arguments, const DocumentKinds& kinds) {
  OperationValues values(voxelizeOperation());
  std::string problem = readOptions(arguments, values);
  BooleanRequest request{arguments.operands[0], arguments.operands[1], arguments.valueOf("output"), {}, {}, {}};
  int chosen = 0;
  for (const auto& [word, how] : kOperations) {
    if (!arguments.has(word)) continue;
    ++chosen;
    request.how = how;
  }
  if (problem.empty() && chosen != 1) problem = "Choose one of --unite, --subtract and --intersect.";
  if (problem.empty() && !arguments.has("output")) problem = "The option -o OUT is missing.";
  if (!problem.empty()) return failUsage(problem, "boolean");
  request.voxel = values.given("voxel");
  request.read.partial = arguments.has("partial");
  MemoryNotice notice(arguments);
  std::optional<Result<BooleanAnswer>> result;
  runInterruptible("Combining the volumes",
                   [&](CommandJob& job) { result = combineFiles(request, kinds, notice.during(job), job.progress()); });
  if (!*result) return fail(result->error());
  const BooleanAnswer& done = result->value();
  for (const DocumentFile& file : done.files) reportLosses(file);
  if (!done.refusal.empty()) return refuse(done.refusal);
  return print(arguments.has("json") ? reportOf(done, notice).dump() + "\n" : textOf(done, request.output));
}

}  // namespace

Command booleanCommand() {
  return {booleanSpec(), runBoolean};
}

}  // namespace handwheel

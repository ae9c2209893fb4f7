// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/volume/ShellOffsetCommands.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/MemoryNotice.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/volume/VolumeFiles.h"
#include "tools/volume/ReshapeOperations.h"
#include "tools/volume/VoxelizeOperations.h"

#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

namespace fs = std::filesystem;

using Change = Result<SparseVolume> (*)(const SparseVolume&, const OperationValues&, Progress);

struct WallRequest {
  fs::path input, output;
  std::optional<double> voxel;
  ReadOptions read;
};

struct WallAnswer {
  DocumentFile file;  // the file, with the damage found in reading
  std::string refusal;
  SparseVolume before, after;
};

Result<WallAnswer> changeFile(const WallRequest& request, const OperationValues& values, Change change,
                              const DocumentKinds& kinds, MemoryNotice& notice, Progress progress) {
  if (const Status can = canWriteVolume(request.output, kinds); !can) return can.error();
  const Result<OpenedFile> opened = kinds.open(request.input, request.read, progress.part(0.0, 0.1));
  if (!opened) return opened.error();
  WallAnswer done{opened->file, refusalToReplace(request.output, opened->file), {}, {}};
  if (!done.refusal.empty()) return done;
  Result<SparseVolume> before = materialOf(*opened, request.input, request.voxel, {}, notice, progress.part(0.1, 0.4));
  if (!before) return before.error();
  done.before = std::move(*before);
  Result<SparseVolume> after = change(done.before, values, progress.part(0.4, 0.8));
  if (!after) {
    Error error = after.error();
    error.subject = request.input.string();
    return error;
  }
  done.after = std::move(*after);
  const Result<WrittenFile> written =
      writeVolume(done.after, request.input, done.file, request.output, kinds, progress.part(0.8, 1.0));
  if (!written) return written.error();
  return done;
}

nlohmann::ordered_json reportOf(const WallAnswer& done, const MemoryNotice& notice) {
  nlohmann::ordered_json report = {{"voxel_mm", done.after.voxel()},
                                   {"volume_before_mm3", done.before.enclosed()},
                                   {"volume_mm3", done.after.enclosed()},
                                   {"blocks", done.after.blockCount()},
                                   {"bytes", done.after.bytes()}};
  notice.addTo(report);
  return report;
}

std::string textOf(const WallAnswer& done, const fs::path& output) {
  return output.string() + ": " + roundedText(done.after.enclosed()) + " mm³ of " +
         roundedText(done.before.enclosed()) + " mm³, voxels of " + roundedText(done.after.voxel()) + " mm.\n";
}

int runChange(const Arguments& arguments, const DocumentKinds& kinds, const Operation& operation,
              std::string_view needed, Change change) {
  OperationValues values(operation), sampling(voxelizeOperation());
  std::string problem = readOptions(arguments, values);
  if (problem.empty()) problem = readOptions(arguments, sampling);
  if (problem.empty() && !needed.empty() && !arguments.has(needed))
    problem = "The option --" + std::string(needed) + " MM is missing.";
  if (problem.empty() && !arguments.has("output")) problem = "The option -o OUT is missing.";
  if (!problem.empty()) return failUsage(problem, operation.id);
  WallRequest request{arguments.operands[0], arguments.valueOf("output"), sampling.given("voxel"), {}};
  request.read.partial = arguments.has("partial");
  MemoryNotice notice(arguments);
  std::optional<Result<WallAnswer>> result;
  runInterruptible("Changing the volume", [&](CommandJob& job) {
    result = changeFile(request, values, change, kinds, notice.during(job), job.progress());
  });
  if (!*result) return fail(result->error());
  const WallAnswer& done = result->value();
  reportLosses(done.file);
  if (!done.refusal.empty()) return refuse(done.refusal);
  return print(arguments.has("json") ? reportOf(done, notice).dump() + "\n" : textOf(done, request.output));
}

int runShell(const Arguments& arguments, const DocumentKinds& kinds) {
  return runChange(arguments, kinds, shellOperation(), "wall", makeShell);
}

int runOffset(const Arguments& arguments, const DocumentKinds& kinds) {
  return runChange(arguments, kinds, offsetOperation(), "distance", makeOffset);
}

int runDebris(const Arguments& arguments, const DocumentKinds& kinds) {
  return runChange(arguments, kinds, debrisOperation(), "below", removeDebris);
}

int runGaps(const Arguments& arguments, const DocumentKinds& kinds) {
  return runChange(arguments, kinds, gapsOperation(), "radius", closeGaps);
}

int runSmooth(const Arguments& arguments, const DocumentKinds& kinds) {
  return runChange(arguments, kinds, smoothOperation(), {}, smoothWhole);
}

CommandSpec specOf(const Operation& operation, std::string_view summary) {
  CommandSpec spec = {operation.id, "IN", summary, {}};
  for (OptionSpec& option : optionsOf(operation)) spec.options.push_back(std::move(option));
  spec.options.push_back({"output", 'o', "OUT", "The volume (.handwheel, .vdb, .nrrd), or its surface as a mesh"});
  for (OptionSpec& option : optionsOf(voxelizeOperation(), {"method", "wall"}))
    spec.options.push_back(std::move(option));
  spec.options.push_back(consentOption());
  addVolumeOptions(spec.options);
  return spec;
}

}  // namespace

std::vector<Command> shellOffsetCommands() {
  return {
      {specOf(shellOperation(),
              "Makes a wall along the surface of a volume, or of what a surface encloses. Exit code 0: done; 1: "
              "error."),
       runShell},
      {specOf(offsetOperation(),
              "Moves the surface of a volume, or of what a surface encloses, out or in. Exit code 0: done; 1: "
              "error."),
       runOffset},
      {specOf(debrisOperation(),
              "Takes the small parts of a volume, or of what a surface encloses, away. Exit code 0: done; 1: error."),
       runDebris},
      {specOf(gapsOperation(),
              "Fills gaps, cracks and pits of a volume, or of what a surface encloses. Exit code 0: done; 1: error."),
       runGaps},
      {specOf(smoothOperation(),
              "Takes small bumps and dents off a volume, or off what a surface encloses. Exit code 0: done; 1: error."),
       runSmooth}};
}

}  // namespace handwheel

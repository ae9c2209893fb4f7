// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/volume/SegmentCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/MemoryNotice.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/volume/OutputName.h"
#include "document/volume/ImageFiles.h"
#include "document/volume/VolumeKind.h"
#include "document/volume/VolumeMaking.h"
#include "text/NoteText.h"
#include "tools/volume/SegmentOperation.h"
#include "volume/image/ImageLabels.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

namespace fs = std::filesystem;

struct SegmentAnswer {
  Segmented segmented;
  Vec3 spacing;
  std::vector<std::string> warnings;
  std::vector<LabelRegion> labels = {};  // empty: the image is no label map
};

Error about(const fs::path& path, Error error) {
  if (error.subject.empty()) error.subject = path.string();
  return error;
}

Result<SegmentAnswer> segmentFile(const fs::path& input, const fs::path& output, const OperationValues& values,
                                  const DocumentKinds& kinds, MemoryNotice& notice, Progress progress) {
  const DocumentKind& kind = *kinds.withId("volume");
  if (const auto endings = writtenEndings(kind.formats()); !hasOneOf(output, endings))
    return unknownEnding(output, endings);
  const Result<ImageFile> file = readImageFile(input, progress.part(0.0, 0.4));
  if (!file) return about(input, file.error());
  SegmentAnswer done{{}, file->image.grid().spacing(), {}};
  for (const Note& note : notesOn(file->remarks)) done.warnings.push_back(noteText(note).toStdString());
  Result<Segmented> segmented = segment(file->image, values, progress.part(0.4, 0.7), [&](double voxel, double bytes) {
    return notice.begin(voxel, bytes, std::nullopt);
  });
  if (!segmented) return about(input, segmented.error());
  done.segmented = std::move(*segmented);
  done.labels = regionsOf(file->image);
  const auto snapshot = snapshotOf(done.segmented.volume, sourceName(input), progress.part(0.7, 0.8));
  if (!snapshot) return about(input, snapshot.error());
  const Result<WrittenFile> written = saveDocument(kind, {}, **snapshot, output, progress.part(0.8, 1.0));
  if (!written) return written.error();
  return done;
}

bool isChosen(const SegmentAnswer& done, const LabelRegion& region) {
  const ValueRange& range = done.segmented.range;
  return region.label.value >= range.least && region.label.value <= range.largest;
}

nlohmann::ordered_json reportOf(const SegmentAnswer& done, const MemoryNotice& notice) {
  const SparseVolume& volume = done.segmented.volume;
  const auto end = [](double value) { return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(); };
  nlohmann::ordered_json report = {{"voxels", std::llround(volume.material() / std::pow(volume.voxel(), 3))},
                                   {"volume_mm3", volume.enclosed()},
                                   {"components", done.segmented.parts},
                                   {"components_kept", done.segmented.kept},
                                   {"range", {end(done.segmented.range.least), end(done.segmented.range.largest)}},
                                   {"voxel_mm", volume.voxel()},
                                   {"spacing_mm", {done.spacing.x(), done.spacing.y(), done.spacing.z()}},
                                   {"warnings", done.warnings}};
  for (const LabelRegion& region : done.labels)
    report["labels"].push_back({{"value", region.label.value},
                                {"name", region.label.name},
                                {"samples", region.samples},
                                {"volume_mm3", region.volume},
                                {"chosen", isChosen(done, region)}});
  notice.addTo(report);
  return report;
}

std::string textOf(const SegmentAnswer& done, const fs::path& output) {
  const SparseVolume& volume = done.segmented.volume;
  std::string text = output.string() + ": values ";
  if (std::isfinite(done.segmented.range.least)) text += "from " + roundedText(done.segmented.range.least) + " ";
  if (std::isfinite(done.segmented.range.largest)) text += "to " + roundedText(done.segmented.range.largest) + " ";
  text.back() = ',';
  text += " " + roundedText(volume.enclosed()) + " mm³ in " + std::to_string(done.segmented.kept);
  if (done.segmented.kept < done.segmented.parts) text += " of " + std::to_string(done.segmented.parts);
  text += " part(s), voxels of " + roundedText(volume.voxel()) + " mm.\n";
  for (const LabelRegion& region : done.labels) {
    text += (isChosen(done, region) ? "  * label " : "    label ") + roundedText(region.label.value, 9);
    if (!region.label.name.empty()) text += " " + region.label.name;
    text += ": " + roundedText(region.volume, 6) + " mm³\n";
  }
  return text;
}

int runSegment(const Arguments& arguments, const DocumentKinds& kinds) {
  OperationValues values(segmentOperation());
  std::string problem = readOptions(arguments, values);
  if (!arguments.has("output")) problem = "The option -o OUT is missing.";
  if (problem.empty() && arguments.has("range") && !rangeIn(values.text("range")))
    problem = "--range is two numbers, the lower one first: 300:2000, 300: or :50.";
  if (!problem.empty()) return failUsage(problem, "segment");
  const fs::path input = arguments.operands[0], output = arguments.valueOf("output");
  if (const std::string refusal = refusalToOverwrite(output, {input}); !refusal.empty()) return refuse(refusal);
  MemoryNotice notice(arguments);
  std::optional<Result<SegmentAnswer>> result;
  runInterruptible("Segmenting", [&](CommandJob& job) {
    result = segmentFile(input, output, values, kinds, notice.during(job), job.progress());
  });
  if (!*result) return fail(result->error());
  const SegmentAnswer& done = result->value();
  for (const std::string& warning : done.warnings) complain(warning);
  return print(arguments.has("json") ? reportOf(done, notice).dump() + "\n" : textOf(done, output));
}

CommandSpec segmentSpec() {
  CommandSpec spec = {
      "segment",
      "IMAGE",
      "Creates a volume, or its surface, from the samples of an image with values in a range. The image is a\n"
      "file in NRRD, MetaImage or NIfTI, plain samples with a description, or a folder or file of DICOM.\n"
      "Exit code 0: done; 1: error.",
      {{"output", 'o', "OUT", "The volume (.handwheel, .vdb, .nrrd), or its surface as a mesh"}}};
  for (OptionSpec& option : optionsOf(segmentOperation())) spec.options.push_back(std::move(option));
  spec.options.push_back(consentOption());
  spec.options.push_back({"json", 0, "", "Print the figures as one line of JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return spec;
}

}  // namespace

Command segmentCommand() {
  return {segmentSpec(), runSegment};
}

}  // namespace handwheel

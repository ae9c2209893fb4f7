// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/SplitMergeCommands.h"

#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/mesh/MeshOutput.h"
#include "document/formats/MeshExport.h"
#include "document/mesh/MeshKind.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/Shells.h"

namespace handwheel {

namespace {

namespace fs = std::filesystem;

// Beyond, a folder of them is of no use to anybody: the mesh is dust.
constexpr std::size_t kMostShells = 10'000;

// The mesh of a document as it is, or of a file after welding.
HalfEdgeMesh meshOf(const Input& input, Progress progress) {
  const MeshSnapshot* document = input.meshDocument();
  return document ? document->mesh.mesh : buildMesh(input.mesh->soup, progress).mesh;
}

struct Outcome {
  std::string text;     // message on the written files
  std::string refusal;  // the reason why nothing, or no more, was written
  std::vector<DocumentFile> files;
};

Error cancelled() {
  return {ErrorCode::Cancelled, {}, {}, {}};
}

// part-01.stl, part-02.stl, …: as many digits as the last one has.
std::string nameOf(const fs::path& input, const std::string& extension, std::size_t number, std::size_t count) {
  const std::string digits = std::to_string(number), all = std::to_string(count);
  return input.stem().string() + "-" + std::string(all.size() - digits.size(), '0') + digits + extension;
}

// Shells are written as meshes, not as documents.
std::vector<std::string> meshEndings() {
  std::vector<std::string> all = writtenEndings(meshFileFormats());
  std::erase(all, kContainerEnding);
  return all;
}

Result<Outcome> split(const fs::path& path, const fs::path& folder, const std::string& extension,
                      const ReadOptions& options, const DocumentKinds& kinds, Progress progress) {
  if (!formatForOutput("shell" + extension)) return unknownEnding("shell" + extension, meshEndings());
  const Result<Input> input = readMeshInput(path, options, kinds, progress.part(0.0, 0.2));
  if (!input) return input.error();
  Outcome done{{}, {}, {input->opened.file}};
  const std::vector<HalfEdgeMesh> shells =
      splitIntoShells(meshOf(*input, progress.part(0.2, 0.4)), progress.part(0.4, 0.5));
  if (progress.cancelled()) return cancelled();
  if (shells.size() > kMostShells) {
    done.refusal = "There are " + std::to_string(shells.size()) + " shells, more than " + std::to_string(kMostShells) +
                   ". Remove the debris first.";
    return done;
  }
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) return Error{ErrorCode::WriteFailed, {problem.message()}, {}, folder.string()};
  std::vector<fs::path> outputs;
  for (std::size_t i = 0; i < shells.size(); ++i) {
    outputs.push_back(folder / nameOf(path, extension, i + 1, shells.size()));
    if (!fs::exists(outputs.back())) continue;
    done.refusal = outputs.back().string() + " already exists.";
    return done;
  }
  for (std::size_t i = 0; i < shells.size(); ++i) {
    const fs::path& output = outputs[i];
    const double from = 0.5 + 0.5 * double(i) / double(shells.size()), each = 0.5 / double(shells.size());
    const Status written = writeMesh(*input, shells[i], output, progress.part(from, from + each));
    if (!written) return written.error();
    done.text += output.string() + ": " + std::to_string(shells[i].liveFaceCount()) + " triangles\n";
  }
  return done;
}

Result<Outcome> merge(const std::vector<std::string>& paths, const fs::path& output, const ReadOptions& options,
                      const DocumentKinds& kinds, Progress progress) {
  if (!isContainerName(output)) {
    if (const auto format = formatForOutput(output); !format) return format.error();
  }
  Outcome done;
  std::optional<Input> first;
  HalfEdgeMesh all;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const double from = 0.8 * double(i) / double(paths.size()), each = 0.8 / double(paths.size());
    Result<Input> input = readMeshInput(paths[i], options, kinds, progress.part(from, from + 0.5 * each));
    if (!input) return input.error();
    done.files.push_back(input->opened.file);
    done.refusal = refusalToReplace(output, input->opened.file);
    if (!done.refusal.empty()) return done;
    append(all, meshOf(*input, progress.part(from + 0.5 * each, from + each)));
    if (progress.cancelled()) return cancelled();
    if (!first) {
      first = std::move(input.value());
    } else if (input->mesh->numbers == NumberType::Float64) {
      first->mesh->numbers = NumberType::Float64;  // nothing is rounded
    }
  }
  const Status written = writeMesh(*first, all, output, progress.part(0.8, 1.0));
  if (!written) return written.error();
  done.text = output.string() + ": " + std::to_string(all.liveFaceCount()) + " triangles\n";
  return done;
}

int tell(const Result<Outcome>& result) {
  if (!result) return fail(result.error());
  for (const DocumentFile& file : result->files) reportLosses(file);
  if (const int code = print(result->text); code != kExitDone) return code;
  return result->refusal.empty() ? kExitDone : refuse(result->refusal);
}

}  // namespace

CommandSpec splitSpec() {
  return {"split",
          "FILE",
          "Writes each shell of a mesh (triangles connected across edges) to a separate file. The files are named\n"
          "after the mesh and numbered in the order of the shells' first triangles; existing files are not replaced.",
          {
              {"output", 'o', "FOLDER", "Output folder; created if it does not exist"},
              {"format", 0, "ENDING", meshFormatWords(false) + "; default: the format of the mesh"},
              {"partial", 0, "", "Read the undamaged part of a damaged file"},
              {"help", 'h', "", "Show this help"},
          }};
}

int runSplit(const Arguments& arguments, const DocumentKinds& kinds) {
  if (!arguments.has("output")) return failUsage("The option -o FOLDER is missing.", "split");
  const fs::path path = arguments.operands[0];
  const std::string extension = arguments.has("format") ? "." + arguments.valueOf("format")
                                : isContainerName(path) ? std::string(".ply")
                                                        : path.extension().string();
  const ReadOptions options{.partial = arguments.has("partial")};
  std::optional<Result<Outcome>> result;
  runInterruptible("Splitting", [&](CommandJob& job) {
    result = split(path, arguments.valueOf("output"), extension, options, kinds, job.progress());
  });
  return tell(*result);
}

CommandSpec mergeSpec() {
  return {"merge",
          "IN [IN...]",
          "Writes several meshes to one file, one after the other. Nothing is joined: where they touch or intersect,\n"
          "they still do so afterwards; 'repair' repairs what can be repaired.",
          {
              meshOutputOption(),
              {"partial", 0, "", "Read the undamaged part of damaged files"},
              {"help", 'h', "", "Show this help"},
          }};
}

int runMerge(const Arguments& arguments, const DocumentKinds& kinds) {
  if (!arguments.has("output")) return failUsage("The option -o OUT is missing.", "merge");
  const ReadOptions options{.partial = arguments.has("partial")};
  std::optional<Result<Outcome>> result;
  runInterruptible("Merging", [&](CommandJob& job) {
    result = merge(arguments.operands, arguments.valueOf("output"), options, kinds, job.progress());
  });
  return tell(*result);
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/CompareCommand.h"

#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/Picture.h"
#include "document/mesh/MeshSnapshot.h"
#include "mesh/structure/MeshBuilder.h"
#include "report/DeviationReport.h"

#include <QTemporaryDir>

namespace handwheel {

namespace {

struct CompareRequest {
  std::filesystem::path mesh, scan, report;
  ReadOptions read;
  DeviationOptions options;
};

// Turns the words into a request. Returns what is wrong with them, or nothing.
std::string readRequest(const Arguments& arguments, CompareRequest& request) {
  request.mesh = arguments.operands[0];
  request.scan = arguments.operands[1];
  request.report = arguments.valueOf("report");
  request.read.partial = arguments.has("partial");
  request.options.measuresBound = true;
  const std::string ending = request.report.extension().string();
  if (arguments.has("report") && ending != ".html" && ending != ".pdf" && ending != ".json") {
    return "--report takes a name that ends in .html, .pdf or .json.";
  }
  if (arguments.has("report") &&
      (isSameFile(request.report, request.mesh) || isSameFile(request.report, request.scan))) {
    return "FILE and SCAN cannot be the report too: " + request.report.string() + ".";
  }
  std::size_t& samples = request.options.samples;
  if (arguments.has("samples") &&
      (!readNumber(arguments.valueOf("samples"), samples) || samples > kMaxDeviationSamples)) {
    return "--samples takes a number from 0 to " + std::to_string(kMaxDeviationSamples) + ".";
  }
  return {};
}

Result<HalfEdgeMesh> readMesh(const std::filesystem::path& path, const ReadOptions& options, const DocumentKinds& kinds,
                              std::vector<DocumentFile>& read, Progress progress) {
  const Result<Input> input = readMeshInput(path, options, kinds, progress.part(0.0, 0.7));
  if (!input) return input.error();
  read.push_back(input->opened.file);
  if (const MeshSnapshot* document = input->meshDocument()) return document->mesh.mesh;
  return buildMesh(input->mesh->soup, progress.part(0.7, 1.0)).mesh;
}

struct Compared {
  Comparison comparison;
  std::vector<DocumentFile> read;
};

Result<Compared> compare(const CompareRequest& request, const DocumentKinds& kinds, Progress progress) {
  Compared done{{request.mesh.string(), request.scan.string(), {}, {}}, {}};
  const Result<HalfEdgeMesh> mesh = readMesh(request.mesh, request.read, kinds, done.read, progress.part(0.0, 0.15));
  if (!mesh) return mesh.error();
  const Result<HalfEdgeMesh> scan = readMesh(request.scan, request.read, kinds, done.read, progress.part(0.15, 0.3));
  if (!scan) return scan.error();
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  Result<Deviation> result = deviation(*mesh, *scan, request.options, progress.part(0.3, 1.0));
  if (!result) return result.error();
  done.comparison.deviation = std::move(*result);
  return done;
}

// Drawn in a process of its own, which measures the distances at the vertices once more. Without it the report has no
// pictures, and says so.
void addPicture(const CompareRequest& request, Comparison& comparison) {
  const QTemporaryDir folder;
  const std::filesystem::path png = folder.filePath(QStringLiteral("sides.png")).toStdString();
  if (renderInChildProcess({request.mesh, png, request.read.partial, request.scan,
                            defaultRange(comparison.deviation.ofMesh)}) == kExitDone) {
    comparison.picture.load(QString::fromStdString(png.string()));
  }
}

}  // namespace

CommandSpec compareSpec() {
  return {
      "compare",
      "FILE SCAN",
      "Measures the distances of a mesh from the scan that it was made from, and of the scan from the mesh.\n"
      "Distances are taken at all vertices and at samples spread evenly over both surfaces; positive distances are\n"
      "on the side of the normals of the other surface: outside a closed one.",
      {
          {"report", 0, "FILE", "Write the figures with histograms, as .html or .pdf with pictures, or .json"},
          {"samples", 0, "N", "Samples on each surface (default 200000); 0: vertices only"},
          {"partial", 0, "", "Read the undamaged part of a damaged file"},
          {"help", 'h', "", "Show this help"},
      }};
}

int runCompare(const Arguments& arguments, const DocumentKinds& kinds) {
  CompareRequest request;
  const std::string problem = readRequest(arguments, request);
  if (!problem.empty()) return failUsage(problem, "compare");

  std::optional<Result<Compared>> result;
  runInterruptible("Comparing", [&](CommandJob& job) { result = compare(request, kinds, job.progress()); });
  if (!*result) return fail(result->error());
  Compared& done = result->value();
  for (DocumentFile& file : done.read) {
    file.lost.clear();  // nothing is written, so nothing is not kept
    reportLosses(file);
  }
  if (arguments.has("report")) {
    if (request.report.extension() != ".json") addPicture(request, done.comparison);
    if (wasInterrupted()) return kExitInterrupted;
    const Status written = writeReport(done.comparison, request.report);
    if (!written) return fail(written.error());
  }
  return print(readableText(done.comparison));
}

}  // namespace handwheel

// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/DecimateCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/ReportJson.h"
#include "cli/mesh/MeshOutput.h"
#include "document/formats/MeshExport.h"
#include "document/mesh/MeshKind.h"
#include "mesh/search/LocalIntersections.h"
#include "mesh/simplify/Decimation.h"
#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/MeshBuilder.h"
#include "report/BoundText.h"
#include "tools/mesh/OpenMeshReasons.h"
#include "tools/mesh/operations/DecimateOperation.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

struct DecimateRequest {
  std::filesystem::path input, output;
  ReadOptions read;
  DecimationOptions options;
};

// Turns the words into a request. Returns what is wrong with them, or nothing.
std::string readRequest(const Arguments& arguments, DecimateRequest& request) {
  if (!arguments.has("output")) return "The option -o OUT is missing.";
  request.input = arguments.operands[0];
  request.output = arguments.valueOf("output");
  request.read.partial = arguments.has("partial");
  OperationValues values(decimateOperation());
  if (const std::string problem = readOptions(arguments, values); !problem.empty()) return problem;
  if (!problemOf(values).empty()) return sentenceOf(problemOf(values));
  request.options = decimationOptionsOf(values);
  request.options.measureDistance = true;
  return {};
}

// Returns the largest distance that rounding to the numbers of the file may move a point, mm: half a unit in the last
// digit of each coordinate. Points are within the margin of the mesh.
double roundingMove(const HalfEdgeMesh& mesh, double margin, NumberType numbers) {
  const Box box = boundsOf(mesh);
  if (numbers == NumberType::Float64 || box.isEmpty()) return 0.0;
  const Vec3 farthest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()) + Vec3::Constant(margin);
  return 0.5 * farthest
                   .unaryExpr([](double v) {
                     const auto single = static_cast<float>(v);
                     return static_cast<double>(std::nextafter(single, INFINITY)) - static_cast<double>(single);
                   })
                   .norm();
}

struct Decimated {
  DocumentFile file;  // losses of reading
  // Its distances have in them how far the numbers of the output move points.
  DecimationReport report;
  std::string refusal;        // the reason why nothing was written
  std::size_t crossings = 0;  // number of pairs of triangles that intersect since
};

Result<Decimated> decimateFile(const DecimateRequest& request, const DocumentKinds& kinds, Progress progress) {
  std::optional<MeshFormat> format;
  if (!isContainerName(request.output)) {
    const Result<MeshFormat> named = formatForOutput(request.output);
    if (!named) return named.error();
    format = *named;
  }
  const Result<Input> input = readMeshInput(request.input, request.read, kinds, progress.part(0.0, 0.15));
  if (!input) return input.error();
  Decimated done{input->opened.file, {}, refusalToReplace(request.output, input->opened.file)};
  if (!done.refusal.empty()) return done;
  const MeshSnapshot* document = input->meshDocument();
  HalfEdgeMesh mesh = document ? document->mesh.mesh : buildMesh(input->mesh->soup, progress.part(0.15, 0.2)).mesh;
  DecimationOptions options = request.options;
  double rounding = 0.0;
  if (format && options.error) {
    rounding = roundingMove(mesh, *options.error, numberTypeOf(*format, input->mesh->numbers));
    *options.error -= rounding;
    if (!(*options.error > 0.0)) {
      done.refusal = request.output.string() + ": the precision of its numbers moves vertices by up to " +
                     roundedText(rounding) +
                     " mm, more than --error allows. Move the part near the origin, or write a .handwheel.";
      return done;
    }
  }
  const HalfEdgeMesh original = mesh;
  if (!progress.cancelled()) done.report = decimate(mesh, options, progress.part(0.2, 0.8));
  if (const auto change = intersectionsChange(original, mesh, progress.part(0.8, 0.9))) done.crossings = change->fresh;
  if (done.report.largestDistance) *done.report.largestDistance += rounding;
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (const char* reason = reasonOf(done.report.refusal)) {
    done.refusal = request.input.string() + ": " + reason + ". --method bounded has no such limit.";
    return done;
  }
  const Status written = writeMesh(*input, mesh, request.output, progress.part(0.9, 1.0));
  if (!written) return written.error();
  return done;
}

nlohmann::ordered_json jsonOf(const Decimated& done) {
  const DecimationReport& report = done.report;
  nlohmann::ordered_json json = {{"triangles_before", report.facesBefore},
                                 {"triangles", report.facesAfter},
                                 {"distance_mm", nullptr},
                                 {"new_self_intersecting_pairs", done.crossings}};
  if (report.largestDistance) json["distance_mm"] = *report.largestDistance;
  return json;
}

std::string readableText(const DecimationReport& report, bool isBounded) {
  std::string text =
      "Triangles: " + std::to_string(report.facesBefore) + " before, " + std::to_string(report.facesAfter) + " now.\n";
  if (report.largestDistance)
    text += "Largest distance found between original and result: " + roundedUpText(*report.largestDistance) + " mm.\n" +
            (isBounded ? "No point is farther away than --error allows.\n" : "No point is farther away.\n");
  return text;
}

}  // namespace

CommandSpec decimateSpec() {
  CommandSpec spec = {"decimate",
                      "FILE",
                      "Reduces the number of triangles while staying as close to the original as possible. Holes, "
                      "handles and parts are\n"
                      "preserved, and no triangle flips. Exit code 0: done; 2: --faces was not reached, or nothing "
                      "could be removed, as\n"
                      "reported on stderr; 1: error.",
                      {meshOutputOption()}};
  for (OptionSpec& option : optionsOf(decimateOperation())) spec.options.push_back(std::move(option));
  spec.options.push_back({"json", 0, "", "Print the figures as JSON"});
  spec.options.push_back({"partial", 0, "", "Read the undamaged part of a damaged file"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return spec;
}

int runDecimate(const Arguments& arguments, const DocumentKinds& kinds) {
  DecimateRequest request;
  const std::string problem = readRequest(arguments, request);
  if (!problem.empty()) return failUsage(problem, "decimate");

  std::optional<Result<Decimated>> result;
  runInterruptible("Decimating", [&](CommandJob& job) { result = decimateFile(request, kinds, job.progress()); });
  if (!*result) return fail(result->error());
  const Decimated& done = result->value();
  reportLosses(done.file);
  if (!done.refusal.empty()) return refuse(done.refusal);
  const std::string text =
      arguments.has("json") ? textOf(jsonOf(done)) : readableText(done.report, request.options.error.has_value());
  if (const int code = print(text); code != kExitDone) return code;
  if (done.crossings > 0)
    complain(std::to_string(done.crossings) + (done.crossings == 1 ? " pair" : " pairs") +
             " of triangles intersect that did not before. --no-crossings prevents that.");
  if (request.options.error && done.report.facesAfter + done.report.removedDegenerate == done.report.facesBefore) {
    complain("No triangle was removed: none can be removed within --error. Try a larger one.");
    return kExitSomethingLeft;
  }
  if (request.options.faces == 0 || done.report.facesAfter <= request.options.faces) return kExitDone;
  complain("More than " + std::to_string(request.options.faces) +
           " triangles remain: no more can be removed within the given limits.");
  return kExitSomethingLeft;
}

}  // namespace handwheel

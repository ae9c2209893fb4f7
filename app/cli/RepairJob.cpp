// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/RepairJob.h"

#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/UntouchedCheck.h"
#include "document/mesh/MeshExport.h"
#include "document/mesh/MeshKind.h"
#include "mesh/MeshBuilder.h"
#include "mesh/Weld.h"

#include <algorithm>
#include <chrono>

namespace handwheel {

namespace {

const Error kCancelled{ErrorCode::Cancelled, {}, {}, {}};

std::vector<int> loopsNotIn(const HalfEdgeMesh& mesh, std::set<int> ids) {
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh)) ids.erase(loop.id);
  return {ids.begin(), ids.end()};
}

// Vertices of the input among both lists, each once.
std::vector<Vertex> touchedInputs(std::vector<Vertex> repaired, const std::vector<Vertex>& parted,
                                  std::size_t inputVertices) {
  repaired.insert(repaired.end(), parted.begin(), parted.end());
  std::erase_if(repaired, [&](Vertex v) { return v >= inputVertices; });
  std::sort(repaired.begin(), repaired.end());
  repaired.erase(std::unique(repaired.begin(), repaired.end()), repaired.end());
  return repaired;
}

// Measures what was written: its figures, and whether every untouched vertex is in it.
Status measure(const RepairRequest& request, const DocumentKinds& kinds, const HalfEdgeMesh& before,
               const HalfEdgeMesh& after, RepairRun& run, Progress progress) {
  const Result<MeshFile> written = readMeshInput(request.output, {}, kinds, progress.part(0.0, 0.3));
  if (!written) return written.error();
  run.untouchedIdentical = untouchedAreIdentical(before, after, run.touched, written->soup);
  run.after =
      reportOn(written->soup, request.countSelfIntersections ? SelfIntersections::Count : SelfIntersections::Skip,
               progress.part(0.3, 1.0));
  return Done{};
}

// The format of the output; none for a container, which holds what the document holds.
Result<std::optional<MeshFormat>> formatFor(const std::filesystem::path& output) {
  if (isContainerName(output)) return std::optional<MeshFormat>();
  const Result<MeshFormat> format = formatForOutput(output);
  if (!format) return format.error();
  return std::optional<MeshFormat>(*format);
}

Result<ExportReport> write(const HalfEdgeMesh& mesh, NumberType numbers, const std::filesystem::path& output,
                           const DocumentKinds& kinds, Progress progress) {
  if (!isContainerName(output)) return exportMesh(mesh, numbers, output, progress);
  const DocumentKind& kind = *kinds.withId(kMeshKind);
  MeshSnapshot snapshot;
  snapshot.mesh = inspected(mesh);
  snapshot.build = std::make_shared<const BuildReport>();
  snapshot.numbers = numbers;
  const Result<WrittenFile> written = saveDocument(kind, DocumentFile(), snapshot, output, progress);
  if (!written) return written.error();
  return ExportReport{{}, written->bytes, {}};
}

}  // namespace

Result<RepairRun> repairFile(const RepairRequest& request, const DocumentKinds& kinds, Job& job) {
  const auto start = std::chrono::steady_clock::now();
  const Progress progress = job.progress();
  const Result<std::optional<MeshFormat>> format = formatFor(request.output);
  if (!format) return format.error();
  Result<MeshFile> file = readMeshInput(request.input, request.read, kinds, progress.part(0.0, 0.1));
  if (!file) return file.error();

  RepairRun run;
  run.damage = std::move(file->damage);
  run.unlistedDamage = file->unlistedDamage;
  run.lost = std::move(file->lost);
  if (request.countSelfIntersections) {
    run.before = reportOn(file->soup, SelfIntersections::Count, progress.part(0.1, 0.2));
  }
  const NumberType numbers = *format ? numberTypeOf(**format, file->numbers) : file->numbers;
  roundPoints(file->soup, numbers);
  BuiltMesh built = buildMesh(file->soup);
  if (progress.cancelled()) return kCancelled;
  run.unknownLoops = loopsNotIn(built.mesh, request.options.keepOpen);
  if (!run.unknownLoops.empty()) return run;

  HalfEdgeMesh mesh = built.mesh;
  RepairOptions options = request.options;
  options.fill.numbers = numbers;
  run.repair = repair(mesh, options, progress.part(0.25, 0.75));
  if (run.repair.cancelled || progress.cancelled()) return kCancelled;
  run.nothingLeft = mesh.liveFaceCount() == 0;
  if (run.nothingLeft) return run;

  job.startWriting();
  const Result<ExportReport> exported = write(mesh, numbers, request.output, kinds, progress.part(0.75, 0.85));
  if (!exported) return exported.error();
  run.repair.turnedFaces += built.report.turnedFaces.size();
  run.repair.partedVertices += exported->parted.size();
  run.touched = touchedInputs(run.repair.touchedVertices, exported->parted, built.mesh.vertexSlots());
  const Status measured = measure(request, kinds, built.mesh, mesh, run, progress.part(0.85, 1.0));
  if (!measured) return measured.error();
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

}  // namespace handwheel
